#pragma once
// Possible travel of the wheels of an axle whose rig cannot drive them.

#include "workbench/kc/rig.hpp"

namespace mbgen::kc {

/// Reason why the wheels of an axle cannot be driven one by one: they cannot travel, or only together. None if they
/// can, or if this cannot be determined.
std::optional<Diagnostic> ride_fault(const Compilation& user, const Axle& axle, const OperatingPoint& at);

}  // namespace mbgen::kc
