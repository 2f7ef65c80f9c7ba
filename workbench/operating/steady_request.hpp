#pragma once
// The request for a steady motion, as typed and by indices.

#include <Eigen/Core>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "compiler/compile.hpp"
#include "runtime/generic/generic.hpp"

namespace mbgen {

/// An output of the model that has a value in a steady motion.
struct OutputGoal {
  int output = -1;  ///< index into Model::outputs
  double value = 0;
};

/// Request for a steady motion.
struct SteadyRequest {
  /// coordinate=rate; none: the first translation that moves at the start, if inputs are solved for; without such
  /// inputs no rate is prescribed, and the rates follow from the balance of drive and drag. out.NAME=value: an output
  /// that has this value
  std::vector<std::string> hold;
  std::vector<std::string> solve;      ///< unknown inputs: a drive, a steering angle
  std::vector<OutputGoal> goals = {};  ///< beside those of `hold`
  bool finds_heading = false;          ///< the yaw angle is unknown too: for goals that fix a direction
};

struct TypedRequest {
  std::vector<std::pair<int, std::optional<double>>> rates;  ///< held coordinates; none: the rate of the start
  std::vector<int> inputs;                                   ///< to be found
  std::vector<OutputGoal> goals;
};

/// independent: coordinates whose rates may be held. Fails: UserError for unknown names (the nearest is named) and
/// values that are no numbers.
TypedRequest typed_request(const Compilation& compilation, const std::vector<int>& independent,
                           const SteadyRequest& request);

/// Values of the outputs less those wanted; not finite where `status` says that there are no accelerations.
Eigen::VectorXd goal_errors(const std::vector<OutputGoal>& goals, const GenericSolver& solver, Status status,
                            const GenericState& state, const GenericDerivative& derivative);

}  // namespace mbgen
