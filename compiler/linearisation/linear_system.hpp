#pragma once
// Linear equations as data, and the point that they belong to.

#include <Eigen/Core>
#include <vector>

namespace mbgen {

/// Where a model is linearised. Requires of it: closed loops and consistent velocities.
struct OperatingPoint {
  std::vector<double> z, zd, x;  ///< all coordinates, all velocities, auxiliary states
  double t = 0;                  ///< s
  std::vector<double> inputs;    ///< all of the model
};

/// A state of the linear system.
struct LinearState {
  enum class Kind { position, velocity, auxiliary };
  Kind kind = Kind::position;
  int index = 0;  ///< tree coordinate, or auxiliary state
};

/// s' = A s + B u and y = C s + D u for the deviations s of the states, u of the inputs and y of the outputs. States
/// are the positions of the independent coordinates, their velocities, and the auxiliary states except sampled values;
/// the dependent coordinates keep the loops closed, driven coordinates keep their motions, and time is fixed. With
/// rolling, positions whose velocities follow from rolling only are states too: they come after the independent ones.
struct LinearSystem {
  std::vector<LinearState> states;
  Eigen::MatrixXd A;            ///< states x states
  Eigen::MatrixXd B;            ///< states x inputs of the model
  Eigen::MatrixXd C;            ///< outputs of the model x states
  Eigen::MatrixXd D;            ///< outputs x inputs
  Eigen::MatrixXd coordinates;  ///< coordinates x states: deviations of all positions
  Eigen::VectorXd drift;        ///< s' at the point itself; zero for accelerations in an equilibrium
};

}  // namespace mbgen
