#include "compiler/analysis/quasi_partition.hpp"

#include <algorithm>

#include "compiler/analysis/partition.hpp"

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

}  // namespace

LoopPartition quasi_partition(NumericSystem& numbers, std::size_t b, const std::vector<Configuration>& configurations,
                              const BlockAnalysis& analysis, const std::vector<bool>& driven) {
  const Topology& topology = numbers.topology();
  const Recursion recursion = plan_recursion(numbers.model(), topology, driven);
  const auto unit = std::find_if(recursion.units.begin(), recursion.units.end(),
                                 [&](const RecursionUnit& u) { return u.block == static_cast<int>(b); });
  LoopPartition result = static_cast<const LoopPartition&>(analysis);
  if (std::none_of(unit->steps.begin(), unit->steps.end(), [](const JointStep& s) { return s.quasi(); })) {
    for (Pivot& pivot : result.pivots)
      pivot.reference *= row_length(topology, topology.blocks[b], numbers.constants(), pivot.equation);
    return result;
  }
  std::vector<Eigen::MatrixXd> jacobians;
  for (const Configuration& configuration : configurations) {
    if (!configuration.closed[b]) continue;
    const System<double>& at = numbers.at(configuration.z);
    System<double> system{at.model, at.topology, recursion.layout, at.environment, at.x, at.constants, at.scribe};
    const Kinematics<double> k = kinematics(system);
    const auto rows = quasi_jacobian(recursion_work(system, recursion, k), *unit);
    Eigen::MatrixXd jacobian = Eigen::MatrixXd::Zero(rows.size(), unit->joints.size());
    for (std::size_t e = 0; e < rows.size(); ++e)
      for (std::size_t i = 0; i < rows[e].columns.size(); ++i) jacobian(e, rows[e].columns[i]) = rows[e].values[i];
    jacobians.push_back(std::move(jacobian));
  }
  const BlockAnalysis chosen = choose_partition(jacobians, analysis.rank, analysis.driven);
  return static_cast<const LoopPartition&>(chosen);
}

}  // namespace mbgen
