#pragma once
// The state that a motion starts from.

#include <string>
#include <vector>

#include "compiler/compile.hpp"
#include "runtime/generic/generic.hpp"

namespace mbgen::cli {

/// All coordinates zero, at rest, t = 0: the reference configuration, driven coordinates not yet at their motions.
GenericState reference_state(const Compilation& compilation);

/// The state that the model's `initial` asks for: `positions` as asked with the loops closed, static equilibrium when
/// wanted (positions are then the guess), `velocities` as asked, the rest consistent. inputs: all of them, model order.
/// Fails: UserError when the loops do not close there, there is no equilibrium, or values contradict the closures.
GenericState initial_state(const Compilation& compilation, const std::vector<double>& inputs);

/// The same at the default inputs, as emitted code holds it.
InitialState default_initial_state(const Compilation& compilation);

}  // namespace mbgen::cli
