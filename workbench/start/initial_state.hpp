#pragma once
// The initial state of a motion.

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "compiler/compile.hpp"
#include "runtime/generic/generic.hpp"
#include "workbench/engines/engine.hpp"

namespace mbgen {

/// All coordinates zero, at rest, t = 0: the reference configuration, driven coordinates not yet at their motions.
GenericState reference_state(const Compilation& compilation);

/// A requested initial value that was changed, since the loops cannot be closed at all requested values.
struct MovedValue {
  Where where;
  int coordinate = -1;
  bool is_velocity = false;
  double asked = 0, found = 0;  ///< rad or m, or per second
};

struct Start {
  GenericState state;
  std::vector<double>
      unloaded;  ///< auxiliary states before reactions pressed frictions, which then have those of `state`
  std::vector<MovedValue> moved;  ///< none of a static equilibrium's positions, which are guesses
};

/// The state that the model's `initial` requests: `positions` with the loops closed, or the nearest closed ones if they
/// are inconsistent (weighted least squares with locks), static equilibrium if requested (positions are then the
/// guess), `velocities` likewise, the rest consistent. inputs: all of them, model order. Fails: UserError if locked or
/// driven values leave a loop open, if there is no equilibrium, or if a value contradicts the motion of its coordinate.
Start initial_start(const Compilation& compilation, const std::vector<double>& inputs);

/// The state alone.
GenericState initial_state(const Compilation& compilation, const std::vector<double>& inputs);

/// The same for an engine: its own reactions press frictions, if it computes them.
GenericState initial_state(const Start& start, const Engine& engine);

/// The state; coordinates that moved go to standard error.
GenericState noted_initial_state(const Compilation& compilation, const std::vector<double>& inputs);

/// A note for each value that was changed, with the amount; none for changes within the rounding of a few digits.
Diagnostics moved_notes(const Compilation& compilation, const std::vector<MovedValue>& moved);

/// A note on wheels that stand or spin while their tyres move over the road, with the rates of rolling; for wheels with
/// a written rate only if they turn backwards.
Diagnostics sliding_notes(const Compilation& compilation, const GenericState& start);

/// A note on a vehicle on flat roads whose static equilibrium is far below, above or rotated from its reference, if the
/// model gives no guess: hardpoints should be those of a standing vehicle.
Diagnostics far_rest_notes(const Compilation& compilation, const GenericState& start);

/// All of them.
Diagnostics start_notes(const Compilation& compilation, const Start& start);

/// Changed values for programs: coordinate, quantity, asked, found.
nlohmann::ordered_json moved_json(const Compilation& compilation, const std::vector<MovedValue>& moved);

/// The same at the default inputs, as in emitted code.
InitialState default_initial_state(const Compilation& compilation);

/// The same for a solver that may lack a start: if the model has none, with a note on standard error.
std::optional<InitialState> known_start(const Compilation& compilation);

}  // namespace mbgen
