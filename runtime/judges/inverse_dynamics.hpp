#pragma once
// Inverse dynamics of the judges: accelerations of all bodies, forces of the actuators on them, and virtual work along
// every motion that the constraints leave.

#include <vector>

#include "runtime/judges/evaluation.hpp"

namespace mbgen {

/// Accelerations of the bodies that agree with the constraints and give these tree coordinates theirs. zdd: per
/// coordinate.
Eigen::VectorXd accelerations_of(const CartesianSystem& system, const PlacedState& at, const Evaluation& evaluation,
                                 const std::vector<int>& independent, const std::vector<double>& zdd);

/// Forces on the bodies for a unit input of each actuator. inputs: that the system has, and has again afterwards.
Eigen::MatrixXd actuator_columns(CartesianSystem& system, const PlacedState& at, const std::vector<double>& inputs);

/// Forces with the least weighted sum of squares. actuation: motions x actuators. Result: whether the
/// actuators move every motion.
bool least_forces(const Model& model, const Eigen::MatrixXd& actuation, const Eigen::VectorXd& required,
                  std::vector<double>& force);

}  // namespace mbgen
