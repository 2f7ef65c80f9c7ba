#pragma once
// Ball joints that start in the pole of their angles, where these have no rates: they start in their other chart.

#include <vector>

#include "compiler/compile.hpp"
#include "runtime/state/state.hpp"

namespace mbgen {

/// A rate of a coordinate in the chart that its ball is in.
struct TurningRate {
  int coordinate = -1;
  double rate = 0;  ///< rad/s
  const InitialTurning* asked = nullptr;
};

/// Takes the joints of Initial::turnings to charts that suit the positions of `state`, and gives the rates of their
/// angles there.
/// Fails: UserError for a joint whose angles are meant themselves (compiler/topology/poles.hpp).
std::vector<TurningRate> turning_rates(const Compilation& compilation, GenericState& state);

}  // namespace mbgen
