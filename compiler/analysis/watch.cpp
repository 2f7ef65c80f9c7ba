#include <algorithm>
#include <random>

#include "compiler/analysis/compatibility.hpp"
#include "compiler/analysis/opening.hpp"

namespace mbgen {
namespace {

using Eigen::VectorXd;

constexpr double kContradiction = 1e-10;  // m or 1: rounding leaves 1e-13, closed is 1e-11
constexpr double kNearSingular = 0.01;    // share of the best margin below which a configuration is no place to step

/// A block can step at view index `s`: something is redundant, something moves, and the place is regular. Large blocks
/// were watched on their walk.
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

/// Notes what the redundant equations of a block show after a step, unless the step did not come out as asked.
void note(const LoopBlock& block, const PartView& view, const std::vector<int>& kept, const std::vector<double>& from,
          const VectorXd& residuals, const std::vector<double>& to, Watch& watch, Opening& worst) {
  Opening here;
  const double length = distance(block, view, from, to, here.coordinate);
  if (length < kStep / 2 || length > 2 * kStep) return;
  ++watch.steps;
  VectorXd residual = residuals.cwiseAbs();
  for (int e : kept) residual[e] = 0;
  watch.residual = watch.residual.cwiseMax(residual);
  here.residual = residual.maxCoeff(&here.equation);
  here.motion = std::abs(to[here.coordinate] - from[here.coordinate]);
  if (here.residual > worst.residual) worst = here;
}

}  // namespace

std::vector<Watch> watch_redundant(NumericSystem& numbers, const std::vector<PartView>& views,
                                   const std::vector<std::vector<int>>& kept,
                                   const std::vector<std::vector<ClosureEquation>>& equations,
                                   const std::vector<Configuration>& configurations) {
  const Topology& topology = numbers.topology();
  std::vector<Watch> watches(views.size());
  std::vector<Opening> worst(views.size());
  std::vector<std::size_t> seen(views.size(), 0);
  std::mt19937_64 random(20120404);
  for (std::size_t b = 0; b < views.size(); ++b) watches[b].residual = VectorXd::Zero(views[b].part.rows.size());
  for (const Configuration& from : configurations) {
    std::vector<double> z = from.z;
    std::vector<std::vector<int>> closing(views.size());
    std::vector<std::size_t> stepping;
    for (std::size_t b = 0; b < views.size(); ++b) {
      if (!from.closed[b]) continue;
      const std::size_t s = seen[b]++;
      if (!can_step(views[b], kept[b], s)) continue;
      move(topology.blocks[b], views[b], mixed_freedoms(views[b], s, random), z);
      closing[b] = kept[b];
      stepping.push_back(b);
    }
    if (stepping.empty()) continue;
    const Configuration to = close_equations(numbers, std::move(z), closing);
    for (std::size_t b : stepping)
      if (to.closed[b])
        note(topology.blocks[b], views[b], kept[b], from.z, to.residuals[b], to.z, watches[b], worst[b]);
  }
  for (std::size_t b = 0; b < views.size(); ++b) {
    if (!(worst[b].residual > kContradiction)) continue;
    const ClosureEquation& equation = equations[b][worst[b].equation];
    watches[b].problems.push_back(
        refusal(numbers.model(), topology, {equation.loop},
                "redundant equations of " + loops_text(topology, {equation.loop}) + " contradict the others", worst[b],
                equation));
  }
  return watches;
}

}  // namespace mbgen
