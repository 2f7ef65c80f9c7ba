#pragma once
// The force law of one tyre of a model as text.

#include <string>

#include "compiler/compile.hpp"

namespace mbgen {

/// Properties and coefficients in use of a tyre, and at its load at rest: stiffnesses, peak friction, and a table of
/// forces and moments over slips. The load is that of the equilibrium, or of the initial state where there is none near
/// it. Fails: UserError for an unknown name.
std::string tyre_law_text(const Compilation& compilation, const std::string& name);

}  // namespace mbgen
