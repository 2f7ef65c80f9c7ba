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
  double rest = 0;      ///< largest element of the gradient that no combination explains, over the size of goals
  double own_rest = 0;  ///< the same over the point's own goal or gradient, whichever is more; `rest` where it has none
  Eigen::VectorXd rest_direction = {};  ///< minus that part of the gradient: the way down
};

/// The conditions of first order hold up to this rest: the goal is then about its square, 1e-8 of the goal's size,
/// above the best nearby. SLSQP can end there where constraints are curved (the Maratos effect).
constexpr double kSmallRest = 1e-4;

/// A bound this near is active, in parts of the range or of the value, whichever is less; a constraint likewise, in
/// parts of its scale or limit.
constexpr double kActivePart = 1e-6;

/// Multipliers by least squares with signs (C. L. Lawson, R. J. Hanson, Solving Least Squares Problems, 1974, ch. 23),
/// of active constraints and bounds. size: of the goal and its gradient in the search, so that the rest does not depend
/// on scales. beside: gradients around a corner of the goal, whose best convex combination with the point's stands for
/// it. Requires: the point has derivatives; size > 0.
Optimality optimality_at(const ProgrammePoint& point, const Eigen::VectorXd& variables, const Eigen::VectorXd& lower,
                         const Eigen::VectorXd& upper, double size, const std::vector<Eigen::VectorXd>& beside = {});

}  // namespace mbgen::optimise
