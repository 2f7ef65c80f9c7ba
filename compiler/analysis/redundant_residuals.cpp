#include "compiler/analysis/redundant_residuals.hpp"

#include <algorithm>
#include <random>

#include "compiler/analysis/violation.hpp"

namespace mbgen {
namespace {

using Eigen::VectorXd;

constexpr double kOtherMode = 1e-6;  // m or 1: no equation that holds about the reference opens so far on its branch
constexpr double kSecondOrder =
    0.03;  // share of a residual left on a step of an eighth: 1/64 where it grows with the square
constexpr double kNearSingular = 0.01;  // share of the best margin below which a configuration is no place to step

/// A block can step at view index `s`: something is redundant, something moves, and the place is regular. Large blocks
/// have the residuals of their walk.
bool can_step(const PartView& view, const std::vector<int>& kept, std::size_t s) {
  if (view.jacobians.empty() || kept.size() == view.part.rows.size() || view.locked() || view.ranks[s] < view.rank)
    return false;
  return view.rank == 0 || view.margin(s) >= kNearSingular * view.margin(view.best());
}

/// A mixture of the freedoms that a block has at view index `s`, largest entry kStep.
VectorXd mixed_freedoms(const PartView& view, std::size_t s, std::mt19937_64& random) {
  const Eigen::MatrixXd free = null_space(view.jacobians[s], view.rank);
  VectorXd weights(free.cols());
  for (double& w : weights) w = static_cast<double>(random() >> 11) * 0x1p-52 - 1.0;
  const VectorXd direction = free * weights;
  return kStep / direction.cwiseAbs().maxCoeff() * direction;
}

/// Absolute residuals of a block, zero for the kept equations.
VectorXd redundant_part(const Configuration& at, std::size_t b, const std::vector<int>& kept) {
  VectorXd residual = residual_left(at, b).cwiseAbs();
  for (int e : kept) residual[e] = 0;
  return residual;
}

/// Records the residuals of a block's redundant equations after a step, unless the step did not reach its end.
void note(const LoopBlock& block, const PartView& view, const std::vector<double>& from, const VectorXd& residual,
          const std::vector<double>& to, bool second_order, RedundantResiduals& residuals, Violation& worst) {
  Violation here;
  here.second_order = second_order;
  const double length = distance(block, view, from, to, here.coordinate);
  if (length < kStep / 2 || length > 2 * kStep) return;
  ++residuals.steps;
  residuals.residual = residuals.residual.cwiseMax(residual);
  here.residual = residual.maxCoeff(&here.equation);
  here.motion = std::abs(to[here.coordinate] - from[here.coordinate]);
  if (here.residual > worst.residual) worst = here;
}

}  // namespace

std::vector<RedundantResiduals> redundant_residuals(NumericSystem& numbers, const std::vector<PartView>& views,
                                                    const std::vector<std::vector<int>>& kept,
                                                    const std::vector<std::vector<ClosureEquation>>& equations,
                                                    const std::vector<Configuration>& configurations) {
  const Topology& topology = numbers.topology();
  const auto opened = [&](const Configuration& at, std::size_t b) { return redundant_part(at, b, kept[b]); };
  std::vector<RedundantResiduals> result(views.size());
  std::vector<Violation> worst(views.size());
  std::vector<std::size_t> seen(views.size(), 0);
  std::mt19937_64 random(20120404);
  for (std::size_t b = 0; b < views.size(); ++b) result[b].residual = VectorXd::Zero(views[b].part.rows.size());
  for (const Configuration& from : configurations) {
    std::vector<double> z = from.z;
    std::vector<std::vector<int>> closing(views.size());
    std::vector<std::size_t> stepping;
    std::vector<VectorXd> ways(views.size());
    for (std::size_t b = 0; b < views.size(); ++b) {
      if (!from.closed[b]) continue;
      const std::size_t s = seen[b]++;
      if (!can_step(views[b], kept[b], s)) continue;
      ways[b] = mixed_freedoms(views[b], s, random);
      move(topology.blocks[b], views[b], ways[b], z);
      closing[b] = kept[b];
      stepping.push_back(b);
    }
    if (stepping.empty()) continue;
    const Configuration to = close_equations(numbers, std::move(z), closing);
    for (std::size_t b : stepping) {
      if (!to.closed[b]) continue;
      const VectorXd residuals = opened(to, b);
      bool second_order = false;
      if (residuals.maxCoeff() > kContradiction) {
        std::vector<double> nearer = from.z;
        move(topology.blocks[b], views[b], ways[b] / 8, nearer);
        const Configuration near = close_equations(numbers, std::move(nearer), closing);
        const double left = near.closed[b] ? opened(near, b).maxCoeff() / residuals.maxCoeff() : 1.0;
        if (left < kJump) continue;
        second_order = left < kSecondOrder;
      }
      // Equations that agree at the reference, and not by far at a random start: another assembly mode.
      const bool agrees = result[b].steps > 0 && seen[b] > 1 && result[b].residual.maxCoeff() <= kContradiction;
      if (agrees && residuals.maxCoeff() > kOtherMode) continue;
      note(topology.blocks[b], views[b], from.z, residuals, to.z, second_order, result[b], worst[b]);
    }
  }
  for (std::size_t b = 0; b < views.size(); ++b) {
    if (!(worst[b].residual > kContradiction)) continue;
    const ClosureEquation& equation = equations[b][worst[b].equation];
    const std::string names = loops_text(topology, {equation.loop});
    const std::string fault = worst[b].second_order ? "the position of " + names +
                                                          " is singular: its equations hinder all but the first motion"
                                                    : "redundant equations of " + names + " contradict the others";
    result[b].problems.push_back(refusal(numbers.model(), topology, {equation.loop}, fault, worst[b], equation));
  }
  return result;
}

}  // namespace mbgen
