#pragma once
// Values of the user's own that the solver keeps beside the coordinates: states that are integrated, and values that
// are set at instants of time.

#include <optional>
#include <string>
#include <vector>

#include "compiler/model/outputs.hpp"

namespace mbgen {

/// A state with an expression as its rate; an auxiliary state of the solver.
struct UserState {
  std::string name;
  Where where;
  Quantity derivative;  ///< unit of the state over s
  double initial = 0;
  std::string unit;
  Presentation shown = {};
};

/// The size of what a joint or rod transmits, N or N m: a load that presses parts together.
struct ReactionLoad {
  /// The whole vector, or its part across or along the joint's axis, which goes with `from`.
  enum class Direction { whole, across, along };
  ReactionOutput::What what = ReactionOutput::What::force;
  int joint = -1, rod = -1;  ///< one of them; of a rod the force on `to`
  Direction direction = Direction::whole;
};

/// A value that is set at t = 0, period, 2 period, ... and holds in between. At an instant the values are set in the
/// order of the model; each expression sees those above it as they are set, itself and those below as they were.
struct SampledValue {
  std::string name;
  Where where;
  double period = 0;                      ///< s, > 0
  Quantity value;                         ///< what it is set to, `delay` instants later, or
  std::optional<ReactionLoad> load = {};  ///< this, with the forces at the instant before any value is set
  double initial = 0;
  int delay = 0;  ///< instants between the evaluation of `value` and its effect
  std::string unit;
  Presentation shown = {};
};

}  // namespace mbgen
