#include "compiler/analysis/quasi_partition.hpp"

#include <algorithm>
#include <map>

#include "compiler/analysis/partition.hpp"
#include "compiler/analysis/symmetry.hpp"

namespace mbgen {
namespace {

static_assert(kLargestQuasiBlock <= kLargestSmallBlock, "a block with quasi-velocities has dense samples");

/// Length of the rod that an equation of a block closes, 1 for those of joints.
double row_length(const Topology& topology, const LoopBlock& block, const Constants<double>& constants, int equation) {
  for (int l : block.loops) {
    const Loop& loop = topology.loops[l];
    if (equation < loop.equations) return loop.rod < 0 ? 1.0 : constants.rods[loop.rod].length;
    equation -= loop.equations;
  }
  return 1.0;
}

/// The partition of a block without balls.
LoopPartition without_rod_lengths(const NumericSystem& numbers, const LoopBlock& block, LoopPartition partition) {
  for (Pivot& pivot : partition.pivots)
    pivot.reference *= row_length(numbers.topology(), block, numbers.constants(), pivot.equation);
  return partition;
}

Eigen::MatrixXd dense(const std::vector<SparseRow<double>>& rows, std::size_t columns) {
  Eigen::MatrixXd result =
      Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(rows.size()), static_cast<Eigen::Index>(columns));
  for (std::size_t e = 0; e < rows.size(); ++e)
    for (std::size_t i = 0; i < rows[e].columns.size(); ++i) result(e, rows[e].columns[i]) = rows[e].values[i];
  return result;
}

/// Jacobians of the given units by (quasi-)velocities, per unit, over the configurations in which their blocks are
/// closed.
std::vector<std::vector<Eigen::MatrixXd>> quasi_jacobians(NumericSystem& numbers,
                                                          const std::vector<Configuration>& configurations,
                                                          const Recursion& recursion,
                                                          const std::vector<const RecursionUnit*>& units) {
  std::vector<std::vector<Eigen::MatrixXd>> jacobians(units.size());
  for (const Configuration& configuration : configurations) {
    const System<double>& at = numbers.at(configuration.z);
    System<double> system{at.model, at.topology, recursion.layout, at.environment, at.x, at.constants, at.annotator};
    const Kinematics<double> k = kinematics(system);
    const RecursionWork<double> work = recursion_work(system, recursion, k);
    for (std::size_t u = 0; u < units.size(); ++u)
      if (configuration.closed[units[u]->block])
        jacobians[u].push_back(dense(quasi_jacobian(work, *units[u]), units[u]->joints.size()));
  }
  return jacobians;
}

/// Leaves out the equations that the partition over joint rates leaves out, so that multipliers are the same over both.
void keep_equations(const LoopPartition& partition, std::vector<Eigen::MatrixXd>& jacobians) {
  std::vector<bool> kept(jacobians.empty() ? 0 : jacobians[0].rows(), false);
  for (const Pivot& pivot : partition.pivots) kept[pivot.equation] = true;
  for (Eigen::MatrixXd& jacobian : jacobians)
    for (std::size_t e = 0; e < kept.size(); ++e)
      if (!kept[e]) jacobian.row(static_cast<Eigen::Index>(e)).setZero();
}

}  // namespace

void set_quasi_partitions(NumericSystem& numbers, const std::vector<Configuration>& configurations,
                          Analysis& analysis) {
  const Topology& topology = numbers.topology();
  const Recursion recursion = plan_recursion(numbers.model(), topology, analysis.driven);
  std::vector<const RecursionUnit*> with_balls;
  for (const RecursionUnit& unit : recursion.units) {
    if (unit.block < 0) continue;
    BlockAnalysis& block = analysis.blocks[unit.block];
    block.quasi = without_rod_lengths(numbers, topology.blocks[unit.block], block);
    for (PartitionCandidate& candidate : block.candidates)
      candidate.pivots = without_rod_lengths(numbers, topology.blocks[unit.block], candidate).pivots;
    if (std::any_of(unit.steps.begin(), unit.steps.end(), [](const JointStep& s) { return s.quasi(); }))
      with_balls.push_back(&unit);
  }
  std::vector<std::vector<Eigen::MatrixXd>> jacobians;
  if (!with_balls.empty()) jacobians = quasi_jacobians(numbers, configurations, recursion, with_balls);
  std::map<int, int> chosen_first;  // of each structure, units are in an order of their own
  for (std::size_t u = 0; u < with_balls.size(); ++u) {
    const int b = with_balls[u]->block;
    BlockAnalysis& block = analysis.blocks[b];
    keep_equations(block, jacobians[u]);
    const int first = chosen_first.try_emplace(block.first_alike, b).first->second;
    std::span<const PartitionCandidate> like;
    if (first != b) like = analysis.blocks[first].candidates;
    BlockAnalysis quasi = choose_partition(jacobians[u], block.rank, block.driven, like);
    block.quasi = quasi;
    block.candidates = std::move(quasi.candidates);
  }
  const Mirror mirror = find_mirror(topology, numbers.constants());
  for (std::size_t b = 0; b < topology.blocks.size(); ++b)
    for (PartitionCandidate& candidate : analysis.blocks[b].candidates)
      candidate.symmetric = is_symmetric(mirror, topology.blocks[b], candidate.dependent);
}

}  // namespace mbgen
