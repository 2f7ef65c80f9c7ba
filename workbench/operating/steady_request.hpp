#pragma once
// The request for a steady motion, by indices.

#include <Eigen/Core>
#include <optional>
#include <utility>
#include <vector>

#include "runtime/generic/generic.hpp"
#include "workbench/operating/steady_motion.hpp"

namespace mbgen {

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
