#pragma once
// Probes beside a design: whether the goal is lower a small step away, where the constraints let it go.

#include <optional>

#include "workbench/optimise/optimality.hpp"

namespace mbgen::optimise {

/// A point beside a design whose goal is lower.
struct BetterPoint {
  Eigen::VectorXd variables;
  double gain = 0;  ///< of the goal
};

/// Looks beside a point in both senses of each direction that the equalities, and the limits and bounds with a
/// multiplier, leave free, 3e-3 of each variable far, and along the remaining gradient. Steps return to curved
/// constraints, and what they lack there is charged by the multipliers. Nothing where no gain exceeds the rounding of
/// the goal, 1e-10 of it and of its changes. with_pairs: sums and differences of directions too, for saddles. size: by
/// which the goal of the programme is divided. Requires: the point evaluates.
std::optional<BetterPoint> better_beside(const Programme& programme, const Eigen::VectorXd& variables,
                                         const Optimality& optimality, double size, bool with_pairs);

}  // namespace mbgen::optimise
