#pragma once
// The state that a motion starts from.

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

/// A start value that the model asks for and that gave way, since the loops do not close at all of them.
struct MovedValue {
  Where where;
  int coordinate = -1;
  bool is_velocity = false;
  double asked = 0, found = 0;  ///< rad or m, or per second
};

struct Start {
  GenericState state;
  std::vector<double>
      unpressed;  ///< auxiliary states before reactions pressed frictions, which then have those of `state`
  std::vector<MovedValue> moved;  ///< none of a static equilibrium's positions, which are guesses
};

/// The state that the model's `initial` asks for: `positions` as asked with the loops closed, or where they do not fit
/// together nearest to them (weighted least squares with locks), static equilibrium when wanted (positions are then the
/// guess), `velocities` likewise, the rest consistent. inputs: all of them, model order.
/// Fails: UserError when locked or driven values leave a loop open, there is no equilibrium, or a value contradicts the
/// motion of its coordinate.
Start initial_start(const Compilation& compilation, const std::vector<double>& inputs);

/// The state alone.
GenericState initial_state(const Compilation& compilation, const std::vector<double>& inputs);

/// The same for an engine: frictions are pressed by its own reactions, where it has some.
GenericState initial_state(const Start& start, const Engine& engine);

/// The state; coordinates that moved go to standard error.
GenericState noted_initial_state(const Compilation& compilation, const std::vector<double>& inputs);

/// A note for each value that moved and by how much; none where none moved by more than values of a few digits are off.
Diagnostics moved_notes(const Compilation& compilation, const std::vector<MovedValue>& moved);

/// A note on the wheels that stand or spin while their tyres run over the road, with the rates that roll; of those
/// whose rate the model itself says, on the ones that turn backwards.
Diagnostics sliding_notes(const Compilation& compilation, const GenericState& start);

/// A note on a vehicle on flat roads whose static equilibrium is far below, above or turned from its reference, where
/// the model gives no guess: hardpoints are those of a standing vehicle.
Diagnostics far_rest_notes(const Compilation& compilation, const GenericState& start);

/// All of them.
Diagnostics start_notes(const Compilation& compilation, const Start& start);

/// Values that moved, for machines: coordinate, quantity, asked, found.
nlohmann::ordered_json moved_json(const Compilation& compilation, const std::vector<MovedValue>& moved);

/// The same at the default inputs, as emitted code holds it.
InitialState default_initial_state(const Compilation& compilation);

/// The same for a solver that goes without where the model has no start; a note on standard error says so.
std::optional<InitialState> known_start(const Compilation& compilation);

}  // namespace mbgen
