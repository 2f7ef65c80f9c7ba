#pragma once
// Reasons why a model has no static equilibrium.

#include <string>
#include <vector>

#include "compiler/compile.hpp"
#include "runtime/generic/generic.hpp"

namespace mbgen {

/// Load of each tyre in a state, N; none if they cannot be computed. inputs: of the model.
std::vector<double> tyre_loads(const Compilation& compilation, const std::vector<double>& inputs,
                               const GenericState& at);

/// Throws the UserError of a search that ended with `status` at `last`: the largest acceleration, the coordinates that
/// moved farthest from `start`, the loads of the tyres, and the usual causes that apply. inputs: of the model.
[[noreturn]] void fail_equilibrium(const Compilation& compilation, const std::vector<double>& inputs,
                                   const GenericState& start, const GenericState& last, Status status);

}  // namespace mbgen
