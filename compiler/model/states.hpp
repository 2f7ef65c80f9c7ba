#pragma once
// The user's states beside the coordinates: integrated states, and values set at instants of time.

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

/// Magnitude of the force or moment transmitted by a joint or rod, N or N m, as normal force of a friction.
struct ReactionLoad {
  /// The whole vector, or its part across or along the joint's axis, which is fixed to `from`.
  enum class Direction { whole, across, along };
  ReactionOutput::What what = ReactionOutput::What::force;
  int joint = -1, rod = -1;  ///< one of them; for a rod the force on `to`
  Direction direction = Direction::whole;
};

/// A value that is set at t = 0, period, 2 period, ... and is constant in between. At an instant the values are set in
/// the order of the model: an expression uses the new values of those above, and the old values of itself and those
/// below.
struct SampledValue {
  std::string name;
  Where where;
  double period = 0;                      ///< s, > 0
  Quantity value;                         ///< its new value, `delay` instants later, or
  std::optional<ReactionLoad> load = {};  ///< this load, with the forces at the instant before any value is set
  double initial = 0;
  int delay = 0;  ///< instants between the evaluation of `value` and its effect
  std::string unit;
  Presentation shown = {};
};

}  // namespace mbgen
