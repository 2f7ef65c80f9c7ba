#include "compiler/analysis/choice_at.hpp"

#include <algorithm>

#include "compiler/algebra/dense.hpp"
#include "compiler/analysis/actuation.hpp"
#include "compiler/analysis/analysis.hpp"
#include "compiler/analysis/configuration.hpp"
#include "compiler/analysis/large_block.hpp"
#include "compiler/analysis/partition.hpp"
#include "compiler/analysis/partition_numbers.hpp"
#include "compiler/analysis/quasi_partition.hpp"

namespace mbgen {
namespace {

/// Whether a partition over the columns that are not driven reaches the rank, not next to losing it.
bool has_rank(const Eigen::MatrixXd& jacobian, const BlockAnalysis& block) {
  std::vector<int> movable = block.dependent;
  movable.insert(movable.end(), block.independent.begin(), block.independent.end());
  if (block.rank == 0 || movable.size() < static_cast<std::size_t>(block.rank)) return block.rank == 0;
  const Eigen::VectorXd s = singular_values(jacobian(Eigen::all, movable));
  return s.size() >= block.rank && s[block.rank - 1] > search_numbers::kFullRankShare * s[0];
}

/// Choice for a block of few joints. Result: false where it has lost rank.
bool choose_small(const Eigen::MatrixXd& jacobian, const std::vector<ClosureEquation>& equations,
                  BlockAnalysis& block) {
  Eigen::MatrixXd kept = jacobian;
  for (const int e : block.redundant_equations) kept.row(e).setZero();
  if (!has_rank(kept, block)) kept = jacobian;
  if (!has_rank(kept, block)) return false;
  BlockAnalysis anew = choose_partition({kept}, block.rank, block.driven);
  anew.certificate = std::move(block.certificate);
  for (const int e : anew.redundant_equations)
    anew.redundant_names.push_back(equations[static_cast<std::size_t>(e)].name);
  block = std::move(anew);
  return true;
}

/// The same for a large one.
bool choose_large(const NumericSystem& numbers, std::size_t b, const std::vector<ClosureEquation>& equations,
                  const std::vector<Configuration>& here, BlockAnalysis& block) {
  const LoopBlock& loops = numbers.topology().blocks[b];
  BlockAnalysis anew = choose_large_partition(loops, b, large_view(numbers, b, here), block.driven, here);
  if (anew.rank < block.rank) return false;
  anew.typical_pivot = block.typical_pivot;
  anew.certificate = std::move(block.certificate);
  for (const int e : anew.redundant_equations)
    anew.redundant_names.push_back(equations[static_cast<std::size_t>(e)].name);
  block = std::move(anew);
  return true;
}

/// Local columns of these coordinates in a block, ascending.
std::vector<int> columns_in(const LoopBlock& block, const std::vector<int>& coordinates) {
  std::vector<int> columns;
  for (std::size_t c = 0; c < block.joints.size(); ++c)
    if (std::ranges::count(coordinates, block.joints[c]) > 0) columns.push_back(static_cast<int>(c));
  return columns;
}

std::vector<int> joined_columns(std::vector<int> columns, const std::vector<int>& others) {
  columns.insert(columns.end(), others.begin(), others.end());
  std::ranges::sort(columns);
  return columns;
}

/// Gives a block the partition in which these columns are independent. Result: false where they do not determine it.
bool hold_columns(Eigen::MatrixXd jacobian, const std::vector<int>& columns, BlockAnalysis& block) {
  for (const int e : block.redundant_equations) jacobian.row(e).setZero();
  BlockAnalysis held = block;
  held.driven = joined_columns(block.driven, columns);
  const auto is_held = [&](int column) { return std::ranges::count(columns, column) > 0; };
  std::erase_if(held.dependent, is_held);
  std::erase_if(held.independent, is_held);
  if (!has_rank(jacobian, held)) return false;
  const BlockAnalysis anew = choose_partition({jacobian}, block.rank, held.driven, {}, block.late);
  block.dependent = anew.dependent;
  block.independent = joined_columns(anew.independent, columns);
  block.pivots = anew.pivots;
  block.triangular_sizes = anew.triangular_sizes;
  return true;
}

/// One position at which all loops are closed, with its closures.
std::vector<Configuration> closed_at(NumericSystem& numbers, const std::vector<double>& z) {
  std::vector<Configuration> here(1);
  here[0].z = z;
  here[0].closed.assign(numbers.topology().blocks.size(), true);
  evaluate_closures(numbers, here[0]);
  return here;
}

}  // namespace

double weakest_pivot(const Model& model, const Topology& topology, const Analysis& analysis,
                     const std::vector<double>& z) {
  NumericSystem numbers(model, topology);
  System<double>& system = numbers.at(z);
  std::vector<double> quality;
  frozen_directions(system, kinematics(system), analysis.blocks, analysis.driven, &quality);
  return quality.empty() ? 1.0 : *std::min_element(quality.begin(), quality.end());
}

std::optional<Analysis> chosen_at(const Model& model, const Topology& topology, const Analysis& analysis,
                                  const std::vector<double>& z) {
  NumericSystem numbers(model, topology);
  const std::vector<Configuration> here = closed_at(numbers, z);
  Analysis result = analysis;
  for (std::size_t b = 0; b < topology.blocks.size(); ++b) {
    BlockAnalysis& block = result.blocks[b];
    const std::vector<ClosureEquation> equations = closure_equations(model, topology, topology.blocks[b]);
    const bool is_chosen = is_large(topology.blocks[b]) ? choose_large(numbers, b, equations, here, block)
                                                        : choose_small(here[0].blocks[b].jacobian, equations, block);
    if (!is_chosen) return {};
    block.first_alike = static_cast<int>(b);
  }
  set_quasi_partitions(numbers, here, result);
  set_actuation(numbers, here, result);
  return result;
}

std::optional<Analysis> with_independent(const Model& model, const Topology& topology, const Analysis& analysis,
                                         const std::vector<double>& z, const std::vector<int>& coordinates) {
  NumericSystem numbers(model, topology);
  const std::vector<Configuration> here = closed_at(numbers, z);
  Analysis result = analysis;
  for (std::size_t b = 0; b < topology.blocks.size(); ++b) {
    const std::vector<int> columns = columns_in(topology.blocks[b], coordinates);
    if (columns.empty()) continue;
    if (is_large(topology.blocks[b]) || !hold_columns(here[0].blocks[b].jacobian, columns, result.blocks[b])) return {};
  }
  return result;
}

}  // namespace mbgen
