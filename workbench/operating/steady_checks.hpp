#pragma once
// Whether a motion is steady, and the only one.

#include <Eigen/Core>
#include <cstddef>
#include <string>
#include <vector>

#include "compiler/compile.hpp"
#include "runtime/generic/generic.hpp"

namespace mbgen {

constexpr double kSteady = 1e-7;  ///< rad/s^2 or m/s^2, and of auxiliary states in parts of their magnitudes a second

/// Norms of columns, none of them 0: inputs are torques as well as angles.
Eigen::VectorXd column_sizes(const Eigen::MatrixXd& matrix);

/// Whether the forces behind accelerations that are left are rounding: 1e-8 of the model's weight, or of its mass times
/// 1 m/s^2 where there is no gravity, at a lever of 1 m. left: accelerations of the independent coordinates, then rates
/// of auxiliary states in parts of their magnitudes.
bool is_weighed_out(const Compilation& compilation, const GenericSolver& solver, const OperatingPoint& point,
                    const Eigen::VectorXd& left);

/// An unknown of a steady motion that a user may choose: a rate or an input.
struct SteadyChoice {
  std::size_t column = 0;
  std::string name;
  bool is_rate = false;
};

/// Directions along which unknowns may change without accelerations, as "zd.car_tx +1, drive +16": the largest rate is
/// 1, or the largest input if no rate changes. derivatives: of the accelerations, by all unknowns. choices: rates
/// before inputs.
std::vector<std::string> free_directions(const Eigen::MatrixXd& derivatives, const std::vector<SteadyChoice>& choices);

}  // namespace mbgen
