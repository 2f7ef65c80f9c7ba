#include "workbench/optimise/probes.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "compiler/algebra/dense.hpp"

namespace mbgen::optimise {
namespace {

constexpr double kProbeStep = 3e-3, kProbeRounding = 1e-10, kRank = 1e-9;
/// Steps along the remaining gradient.
constexpr double kRestSteps[] = {1e-4, 1e-2};
/// A better step grows fourfold up to here while the goal falls.
constexpr double kFarthest = 0.1;
/// A multiplier below this, in parts of the goal's size, holds nothing.
constexpr double kHolds = 1e-6;
/// Of a constraint, in parts of its scale, beyond the point's own excess.
constexpr double kMostExcess = 1e-6;
/// Variables up to which sums and differences of directions are looked at.
constexpr Eigen::Index kMostPaired = 8;

/// Constraints that hold a design, and what a step beyond them costs.
struct Held {
  Eigen::MatrixXd rows;
  Eigen::VectorXd widths;  ///< of a step of 1, per variable: its size, but not beyond its range
  std::vector<Eigen::Index> inequalities = {};
  ProgrammePoint base = {};
};

Held held_at(const Programme& programme, const Eigen::VectorXd& variables, const Optimality& optimality, double size,
             ProgrammePoint base) {
  Held held{.rows = base.of_equalities, .widths = variables.cwiseAbs().cwiseMax(1.0), .base = std::move(base)};
  held.widths = held.widths.cwiseMin(programme.upper - programme.lower);
  const auto add = [&](const Eigen::RowVectorXd& row) {
    held.rows.conservativeResize(held.rows.rows() + 1, variables.size());
    held.rows.bottomRows(1) = row;
  };
  for (Eigen::Index k = 0; k < held.base.inequalities.size(); ++k) {
    if (optimality.inequalities[k] <= kHolds * size) continue;
    held.inequalities.push_back(k);
    add(held.base.of_inequalities.row(k));
  }
  for (Eigen::Index v = 0; v < variables.size(); ++v)
    if (std::abs(optimality.bounds[v]) > kHolds * size) add(Eigen::RowVectorXd::Unit(variables.size(), v));
  return held;
}

/// Free directions as columns, in parts of the widths.
Eigen::MatrixXd directions_of(const Held& held, Eigen::Index variables, bool with_pairs) {
  Eigen::MatrixXd free = Eigen::MatrixXd::Identity(variables, variables);
  if (held.rows.rows() > 0) free = indifferent_directions(held.rows * held.widths.asDiagonal(), kRank);
  const Eigen::Index count = free.cols();
  if (!with_pairs || count > kMostPaired) return free;
  for (Eigen::Index a = 0; a < count; ++a)
    for (Eigen::Index b = a + 1; b < count; ++b) {
      free.conservativeResize(variables, free.cols() + 2);
      free.col(free.cols() - 2) = (free.col(a) + free.col(b)) / std::sqrt(2.0);
      free.col(free.cols() - 1) = (free.col(a) - free.col(b)) / std::sqrt(2.0);
    }
  return free;
}

/// Differences of the held constraints to those at the design; zero of the bounds.
Eigen::VectorXd off_constraints(const Held& held, const ProgrammePoint& at) {
  Eigen::VectorXd off = Eigen::VectorXd::Zero(held.rows.rows());
  off.head(at.equalities.size()) = at.equalities - held.base.equalities;
  Eigen::Index row = at.equalities.size();
  for (const Eigen::Index k : held.inequalities) off[row++] = at.inequalities[k] - held.base.inequalities[k];
  return off;
}

/// Cost of what a point lacks of the constraints, twice for safety; infinite where it breaks one.
double charge(const Held& held, const Optimality& optimality, double size, const ProgrammePoint& at) {
  double sum = 0;
  for (Eigen::Index e = 0; e < at.equalities.size(); ++e) {
    const double off = std::abs(at.equalities[e] - held.base.equalities[e]);
    if (off > kMostExcess) return HUGE_VAL;
    sum += 2 * off * std::abs(optimality.equalities[e]) / size;
  }
  for (Eigen::Index k = 0; k < at.inequalities.size(); ++k) {
    const double off = at.inequalities[k] - std::max(0.0, held.base.inequalities[k]);
    if (off > kMostExcess) return HUGE_VAL;
    const double moved = std::max(0.0, at.inequalities[k] - held.base.inequalities[k]);
    sum += 2 * moved * optimality.inequalities[k] / size;
  }
  return sum;
}

/// A step on the constraints; false where the model has no result there.
bool probe(const Programme& programme, const Held& held, Eigen::VectorXd& at, ProgrammePoint& found) {
  constexpr int kReturns = 6;
  const auto clamped = [&] { return at.cwiseMax(programme.lower).cwiseMin(programme.upper).eval(); };
  at = clamped();
  for (int k = 0; k < kReturns; ++k) {
    if (!programme.evaluate(at, false, found)) return false;
    const Eigen::VectorXd off = off_constraints(held, found);
    if (off.size() == 0 || off.cwiseAbs().maxCoeff() <= 1e-12) return true;
    at += held.widths.asDiagonal() * least_squares(held.rows * held.widths.asDiagonal(), -off, kRank);
    at = clamped();
  }
  return programme.evaluate(at, false, found);
}

}  // namespace

std::optional<BetterPoint> better_beside(const Programme& programme, const Eigen::VectorXd& variables,
                                         const Optimality& optimality, double size, bool with_pairs) {
  ProgrammePoint base;
  if (!programme.evaluate(variables, true, base)) return {};
  const double goal = base.goal;
  const Held held = held_at(programme, variables, optimality, size, std::move(base));
  const Eigen::MatrixXd free = directions_of(held, variables.size(), with_pairs);
  std::vector<Eigen::VectorXd> steps;
  for (Eigen::Index d = 0; d < free.cols(); ++d)
    for (const double step : {-kProbeStep, kProbeStep}) steps.push_back(step * free.col(d));
  const Eigen::VectorXd rest = optimality.rest_direction.cwiseProduct(held.widths);
  for (const double step : kRestSteps)
    if (rest.norm() > 0) steps.push_back((step / rest.norm()) * rest);
  BetterPoint best;
  Eigen::VectorXd best_step;
  double largest_change = 0;
  const auto take_better = [&](const Eigen::VectorXd& step) {
    Eigen::VectorXd at = variables + held.widths.asDiagonal() * step;
    ProgrammePoint found;
    if (!probe(programme, held, at, found) || at == variables) return false;
    largest_change = std::max(largest_change, std::abs(found.goal - goal));
    const double gain = goal - found.goal - charge(held, optimality, size, found);
    if (!(gain > best.gain)) return false;
    best = {at, gain};
    best_step = step;
    return true;
  };
  for (const Eigen::VectorXd& step : steps) {
    if (programme.goes_on && !programme.goes_on()) return {};
    take_better(step);
  }
  if (!(best.gain > kProbeRounding * (std::abs(goal) + largest_change))) return {};
  while (best_step.norm() < kFarthest && take_better(4 * best_step)) {
  }
  best.gain *= size;
  return best;
}

}  // namespace mbgen::optimise
