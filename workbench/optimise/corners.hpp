#pragma once
// Corners of a goal, as where another of two numbers becomes the largest: the gradient jumps there, and a smooth method
// stops at any place of the edge.

#include <optional>

#include "workbench/optimise/optimality.hpp"

namespace mbgen::optimise {

/// An end at a corner.
struct CornerEnd {
  Eigen::VectorXd variables;
  Optimality optimality;  ///< of a convex combination of gradients beside it
};

/// Descends along an edge of the goal with shrinking steps: where a step along minus the smallest convex combination of
/// the gradients seen so far does not lower the goal, its gradient joins them. None where they do not cancel at the
/// last step, a constraint is broken on the way, or the model has no result there. size: of the goal; most: number of
/// evaluations; shortest: step, at least the step of differences, whose derivatives change across it.
/// Source: J. V. Burke, A. S. Lewis, M. L. Overton, "A Robust Gradient Sampling Algorithm for Nonsmooth, Nonconvex
/// Optimization", SIAM J. Optim. 15(3), 2005, with C. Lemarechal's null steps in place of random samples.
std::optional<CornerEnd> corner_near(const Programme& programme, const Eigen::VectorXd& variables, double size,
                                     int most, double shortest);

/// Multipliers at a corner whose derivatives are differences: by gradients a step away from it, where no difference
/// reaches across, so to about a hundredth. None where they do not cancel up to that. size: of the goal.
std::optional<Optimality> multipliers_around(const Programme& programme, const Eigen::VectorXd& variables, double size);

}  // namespace mbgen::optimise
