#pragma once
// The force law of one tyre of a model as text.

#include <string>

#include "compiler/compile.hpp"

namespace mbgen {

/// Properties and active coefficients of a tyre, and at its load at rest: stiffnesses, peak friction, and a table of
/// forces and moments over slips. The load is taken at the equilibrium, or at the initial state if there is no
/// equilibrium near it. Fails: UserError for an unknown name.
std::string tyre_law_text(const Compilation& compilation, const std::string& name);

}  // namespace mbgen
