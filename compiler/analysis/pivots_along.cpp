#include "compiler/analysis/pivots_along.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "compiler/analysis/freedom_walk.hpp"
#include "compiler/analysis/partition_numbers.hpp"
#include "compiler/analysis/triangular.hpp"

namespace mbgen {
namespace {

constexpr double kStepAlong = 0.15;    // rad or m, of the coordinate that moves most
constexpr int kMostStepsAlong = 120;   // in one direction: a turn of a crank that links outrun by half
constexpr double kSureQuality = 0.25;  // smallest pivot over its median along the motion that needs no other order
constexpr std::size_t kLargestFineBlock = 2;

/// Jacobians along the freedom from the reference: a turn, or as far as it goes both ways.
std::vector<SparseRows> jacobians_along(NumericSystem& numbers, std::size_t b, const Configuration& reference,
                                        const LoopPartition& partition) {
  const LoopBlock& block = numbers.topology().blocks[b];
  std::vector<std::vector<int>> equations(numbers.topology().blocks.size());
  for (const Pivot& pivot : partition.pivots) equations[b].push_back(pivot.equation);
  std::sort(equations[b].begin(), equations[b].end());
  const int leader = block.joints[partition.independent[0]];
  std::vector<SparseRows> found{reference.blocks[b].sparse};
  double turned = 0;
  for (const double sense : {1.0, -1.0}) {
    Configuration at = reference;
    std::vector<double> weights(block.joints.size(), 0.0);
    weights[partition.independent[0]] = sense;
    for (int k = 0; k < kMostStepsAlong && turned < 2 * std::numbers::pi; ++k) {
      const std::vector<double> way = mixed_freedoms(at.blocks[b].sparse, partition, weights);
      double longest = 0;
      for (const double part : way) longest = std::max(longest, std::abs(part));
      if (!std::isfinite(longest)) break;
      std::vector<double> start = at.z;
      for (std::size_t c = 0; c < way.size(); ++c) start[block.joints[c]] += kStepAlong / longest * way[c];
      const double before = at.z[leader];
      at = close_equations(numbers, std::move(start), equations);
      if (!at.closed[b]) break;
      turned += std::abs(at.z[leader] - before);
      found.push_back(at.blocks[b].sparse);
    }
  }
  return found;
}

double median_along(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

/// Two pivots of a fine block and how near zero they come, over their medians.
struct PairOrder {
  Pivot first, second;
  double least = -1;
};

PairOrder order_of_pair(const std::vector<SparseRows>& samples, const int (&rows)[2], const int (&columns)[2]) {
  PairOrder best;
  for (const int r : {0, 1}) {
    for (const int c : {0, 1}) {
      std::vector<double> first, second;
      bool changes_sign = false;
      for (const SparseRows& sample : samples) {
        const auto entry = [&](int row, int column) { return sample[rows[row]].at(columns[column]); };
        const double determinant = entry(0, 0) * entry(1, 1) - entry(0, 1) * entry(1, 0);
        first.push_back(std::abs(entry(r, c)));
        changes_sign = changes_sign || (entry(r, c) < 0) != (samples[0][rows[r]].at(columns[c]) < 0);
        second.push_back(first.back() > 0 ? std::abs(determinant) / first.back() : 0.0);
      }
      const PairOrder order{{rows[r], columns[c], median_along(first)},
                            {rows[1 - r], columns[1 - c], median_along(second)}};
      double least = changes_sign ? 0 : 1;
      for (std::size_t s = 0; s < samples.size(); ++s)
        least = std::min({least, first[s] / order.first.reference, second[s] / order.second.reference});
      if (least > best.least * (1 + search_numbers::kTie)) best = {order.first, order.second, least};
    }
  }
  return best;
}

/// The pivots fine block by fine block; empty if one has more than two rows.
std::vector<Pivot> ordered_finely(const std::vector<SparseRows>& samples, const std::vector<Pivot>& pivots) {
  const std::size_t rank = pivots.size();
  std::vector<std::vector<bool>> pattern(rank, std::vector<bool>(rank));
  for (std::size_t r = 0; r < rank; ++r)
    for (std::size_t c = 0; c < rank; ++c)
      pattern[r][c] = std::ranges::any_of(samples, [&](const SparseRows& sample) {
        return std::abs(sample[pivots[r].equation].at(pivots[c].coordinate)) > search_numbers::kStructuralZero;
      });
  std::vector<Pivot> ordered;
  for (const auto& block : block_triangular_form(pattern)) {
    if (block.size() > kLargestFineBlock || block[0].second < 0 || block.back().second < 0) return {};
    const int rows[] = {pivots[block[0].first].equation, pivots[block.back().first].equation};
    const int columns[] = {pivots[block[0].second].coordinate, pivots[block.back().second].coordinate};
    if (block.size() == 2) {
      const PairOrder pair = order_of_pair(samples, rows, columns);
      ordered.push_back(pair.first);
      ordered.push_back(pair.second);
      continue;
    }
    std::vector<double> sizes;
    for (const SparseRows& sample : samples) sizes.push_back(std::abs(sample[rows[0]].at(columns[0])));
    ordered.push_back({rows[0], columns[0], median_along(sizes)});
  }
  return ordered;
}

/// Smallest monitor of a partition along the motion, 0 if a pivot changes its sign: it passes zero between the samples.
double least_quality(const std::vector<SparseRows>& samples, const LoopPartition& partition, std::size_t coordinates) {
  double least = 1;
  std::vector<double> before;
  for (const SparseRows& sample : samples) {
    const FrozenFactors<double> factors = factorise_frozen(sample, partition, coordinates);
    for (std::size_t k = 0; k < before.size(); ++k)
      if ((factors.pivot[k] < 0) != (before[k] < 0)) return 0;
    before = factors.pivot;
    least = std::min(least, std::isfinite(factors.quality) ? factors.quality : 0.0);
  }
  return least;
}

}  // namespace

void order_along_motion(NumericSystem& numbers, std::size_t b, const Configuration& reference,
                        LoopPartition& partition) {
  const std::size_t coordinates = numbers.topology().blocks[b].joints.size();
  if (partition.independent.size() != 1 || !partition.driven.empty() || partition.pivots.empty()) return;
  const std::vector<SparseRows> samples = jacobians_along(numbers, b, reference, partition);
  const double least = least_quality(samples, partition, coordinates);
  if (least >= kSureQuality) return;
  LoopPartition other = partition;
  other.pivots = ordered_finely(samples, partition.pivots);
  if (!other.pivots.empty() && least_quality(samples, other, coordinates) > 2 * least) partition = std::move(other);
}

}  // namespace mbgen
