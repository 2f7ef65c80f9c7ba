#include "compiler/analysis/large_block.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "compiler/analysis/freedom_walk.hpp"
#include "compiler/analysis/partition.hpp"
#include "compiler/analysis/violation.hpp"

namespace mbgen {
namespace {

constexpr double kStillShare = 1e-6;  // share of the largest motion, as in certificate.cpp

std::vector<int> all_below(std::size_t count) {
  std::vector<int> indices(count);
  std::iota(indices.begin(), indices.end(), 0);
  return indices;
}

SparseElimination elimination_of(const std::vector<const SparseRows*>& samples, std::size_t coordinates,
                                 const std::vector<int>& barred_columns, const std::vector<int>& late) {
  std::vector<bool> barred(coordinates, false);
  for (int c : barred_columns) barred[c] = true;
  return eliminate(samples, all_below(samples[0]->size()), barred, late);
}

/// Jacobians of the configurations with the generic rank.
std::vector<const SparseRows*> regular_samples(std::size_t b, const PartView& whole,
                                               const std::vector<Configuration>& configurations) {
  std::vector<const SparseRows*> samples;
  for (std::size_t s = 0; s < whole.configurations.size(); ++s)
    if (whole.ranks[s] == whole.rank) samples.push_back(&configurations[whole.configurations[s]].blocks[b].sparse);
  return samples;
}

LoopPartition partition_of(const SparseElimination& elimination, std::size_t coordinates,
                           const std::vector<int>& driven) {
  LoopPartition partition;
  partition.pivots = elimination.pivots;
  partition.driven = driven;
  std::vector<bool> taken(coordinates, false);
  for (int c : driven) taken[c] = true;
  for (const Pivot& pivot : elimination.pivots) {
    partition.dependent.push_back(pivot.coordinate);
    taken[pivot.coordinate] = true;
  }
  std::sort(partition.dependent.begin(), partition.dependent.end());
  for (std::size_t c = 0; c < coordinates; ++c)
    if (!taken[c]) partition.independent.push_back(static_cast<int>(c));
  return partition;
}

std::vector<int> rows_without_pivot(const std::vector<Pivot>& pivots, std::size_t rows) {
  std::vector<bool> taken(rows, false);
  for (const Pivot& pivot : pivots) taken[pivot.equation] = true;
  std::vector<int> left;
  for (std::size_t r = 0; r < rows; ++r)
    if (!taken[r]) left.push_back(static_cast<int>(r));
  return left;
}

/// The rows of velocities alone, where some of them have no pivot.
LateRows late_rows_of(const SparseElimination& elimination, const std::vector<int>& of_velocities) {
  LateRows late{of_velocities, 0};
  for (const Pivot& pivot : elimination.pivots) late.early_rank += contains(of_velocities, pivot.equation) ? 0 : 1;
  const bool all =
      late.early_rank + static_cast<int>(of_velocities.size()) == static_cast<int>(elimination.pivots.size());
  return all ? LateRows{} : late;
}

/// Columns that do not move with a mixture of the freedoms, in any configuration of generic rank.
std::vector<int> immobile_columns(const std::vector<const SparseRows*>& samples, const LoopPartition& partition,
                                  std::size_t coordinates) {
  std::vector<bool> moves(coordinates, false);
  const std::vector<double> weights(coordinates, 1.0);
  for (const SparseRows* sample : samples) {
    const std::vector<double> way = mixed_freedoms(*sample, partition, weights);
    double longest = 0;
    for (double part : way) longest = std::max(longest, std::abs(part));
    for (std::size_t c = 0; c < coordinates; ++c) moves[c] = moves[c] || std::abs(way[c]) > kStillShare * longest;
  }
  std::vector<int> still;
  for (std::size_t c = 0; c < coordinates; ++c)
    if (!moves[c]) still.push_back(static_cast<int>(c));
  return still;
}

}  // namespace

PartView large_view(const NumericSystem& numbers, std::size_t b, const std::vector<Configuration>& configurations) {
  const LoopBlock& block = numbers.topology().blocks[b];
  PartView view;
  view.part = {block.loops, all_below(block.equations), all_below(block.joints.size())};
  view.late = numbers.velocity_rows(b);
  for (std::size_t i = 0; i < configurations.size(); ++i) {
    if (!configurations[i].closed[b]) continue;
    const SparseElimination here =
        elimination_of({&configurations[i].blocks[b].sparse}, block.joints.size(), {}, view.late);
    view.configurations.push_back(static_cast<int>(i));
    view.ranks.push_back(static_cast<int>(here.pivots.size()));
    view.rank = std::max(view.rank, view.ranks.back());
  }
  return view;
}

Certificate certify_large(const Topology& topology, std::size_t b, const PartView& whole,
                          const std::vector<ClosureEquation>& equations,
                          const std::vector<Configuration>& configurations) {
  const LoopBlock& block = topology.blocks[b];
  const std::vector<const SparseRows*> samples = regular_samples(b, whole, configurations);
  const SparseElimination elimination = elimination_of(samples, block.joints.size(), {}, whole.late);
  Certificate c;
  c.closed_configurations = static_cast<int>(whole.configurations.size());
  std::map<int, int, std::greater<>> count;
  for (int rank : whole.ranks) ++count[rank];
  for (const auto& [rank, times] : count) c.ranks.push_back({rank, times});
  c.immobile = immobile_columns(samples, partition_of(elimination, block.joints.size(), {}), block.joints.size());
  c.degrees_of_freedom = static_cast<int>(block.joints.size()) - whole.rank;
  c.smallest_kept = elimination.smallest_kept;
  c.largest_dropped = elimination.largest_dropped;
  c.steps = static_cast<int>(whole.configurations.size()) - 1;  // all but the reference are steps along the freedoms
  for (int i : whole.configurations)
    for (int j : block.joints) c.reach = std::max(c.reach, std::abs(configurations[i].z[j]));
  for (int e : rows_without_pivot(elimination.pivots, equations.size())) {
    double residual = c.steps > 0 ? 0.0 : -1.0;
    for (int i : whole.configurations)
      if (c.steps > 0) residual = std::max(residual, std::abs(configurations[i].residuals[b][e]));
    c.redundant.push_back({e, equations[e].loop, equations[e].name, equations[e].meaning, residual});
  }
  return c;
}

BlockAnalysis choose_large_partition(const LoopBlock& block, std::size_t b, const PartView& whole,
                                     const std::vector<int>& driven, const std::vector<Configuration>& configurations,
                                     const std::vector<int>& free) {
  const std::size_t coordinates = block.joints.size();
  const std::vector<const SparseRows*> samples = regular_samples(b, whole, configurations);
  std::vector<int> barred = driven;
  barred.insert(barred.end(), free.begin(), free.end());
  const SparseElimination elimination = elimination_of(samples, coordinates, barred, whole.late);
  BlockAnalysis result;
  static_cast<LoopPartition&>(result) = partition_of(elimination, coordinates, driven);
  result.rank = static_cast<int>(elimination.pivots.size());
  result.late = late_rows_of(elimination, whole.late);
  result.worst_pivot_ratio = elimination.worst_ratio;
  result.triangular_sizes = {result.rank};  // eliminated as one
  result.redundant_equations = rows_without_pivot(elimination.pivots, block.equations);
  if (!chooses_again(block) || result.rank == 0) return result;
  std::vector<Eigen::MatrixXd> jacobians;
  for (int i : whole.configurations)
    jacobians.push_back(configurations[i].blocks[b].part(all_below(block.equations), all_below(coordinates)));
  result.typical_pivot = typical_pivot(jacobians, result.rank, driven, result.late);
  return result;
}

Diagnostics large_contradictions(const Model& model, const Topology& topology, std::size_t b,
                                 const std::vector<ClosureEquation>& equations,
                                 const std::vector<Configuration>& configurations) {
  const LoopBlock& block = topology.blocks[b];
  Violation worst;
  for (const Configuration& there : configurations) {
    if (!there.closed[b]) continue;
    Violation here;
    here.residual = there.residuals[b].cwiseAbs().maxCoeff(&here.equation);
    if (!(here.residual > worst.residual)) continue;
    for (int j : block.joints)
      if (const double way = std::abs(there.z[j] - configurations[0].z[j]); way > here.motion)
        here.coordinate = j, here.motion = way;
    worst = here;
  }
  if (!(worst.residual > kContradiction)) return {};
  const ClosureEquation& equation = equations[worst.equation];
  return {refusal(model, topology, {equation.loop},
                  "redundant equations of " + loops_text(topology, {equation.loop}) + " contradict the others", worst,
                  equation)};
}

}  // namespace mbgen
