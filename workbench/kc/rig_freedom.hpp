#pragma once
// How far the wheels of an axle can travel, where its rig cannot drive them.

#include "workbench/kc/rig.hpp"

namespace mbgen::kc {

/// Why the wheels of an axle cannot be driven one by one: nothing lets them travel, or only together. None where they
/// can, or where that cannot be told.
std::optional<Diagnostic> ride_fault(const Compilation& user, const Axle& axle, const OperatingPoint& at);

}  // namespace mbgen::kc
