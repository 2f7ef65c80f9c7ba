#pragma once
// Conditions of first order at a design: which bounds and constraints hold it, and how far the goal would follow them.

#include <Eigen/Core>
#include <vector>

#include "workbench/optimise/nonlinear_programme.hpp"

namespace mbgen::optimise {

/// Multipliers by which the gradient of the goal is a combination of those of active bounds and constraints: the goal
/// falls by a multiplier per unit by which its limit is moved outwards. All in scaled variables and constraints.
struct Optimality {
  Eigen::VectorXd inequalities, equalities;  ///< multipliers, zero of inactive ones; of inequalities >= 0
  Eigen::VectorXd bounds;                    ///< of an upper bound above 0, of a lower one below 0
  std::vector<int> at_bound;                 ///< -1 lower, 1 upper, 0 none, per variable
  double rest = 0;  ///< largest element of the gradient that no combination explains, over 1 + the gradient's largest
};

/// A rest below this is a design that the conditions of first order hold at.
constexpr double kSmallRest = 1e-5;

/// Multipliers by least squares with signs (C. L. Lawson, R. J. Hanson, Solving Least Squares Problems, 1974, ch. 23),
/// of constraints that are no further than 1e-6 from their limits. Requires: the point has derivatives.
Optimality optimality_at(const ProgrammePoint& point, const Eigen::VectorXd& variables, const Eigen::VectorXd& lower,
                         const Eigen::VectorXd& upper);

}  // namespace mbgen::optimise
