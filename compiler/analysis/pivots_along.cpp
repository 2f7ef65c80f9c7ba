#include "compiler/analysis/pivots_along.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "compiler/algebra/median.hpp"
#include "compiler/analysis/freedom_walk.hpp"
#include "compiler/analysis/partition.hpp"
#include "compiler/analysis/partition_numbers.hpp"
#include "compiler/analysis/triangular.hpp"

namespace mbgen {
namespace {

constexpr double kStepAlong = 0.15;    // rad or m, of the coordinate that moves most
constexpr double kBackAgain = 0.1;     // rad or m, to the reference: more than half a step
constexpr std::size_t kFewSteps = 4;   // the motion is not back again before
constexpr int kMostStepsAlong = 120;   // in one direction: a turn of a crank that links outrun by half
constexpr double kSureQuality = 0.25;  // smallest pivot over its median along the motion that needs no other order
constexpr double kResting = 0.1;       // share of the fastest rate below which a free coordinate is about to turn back
constexpr std::size_t kLargestFineBlock = 2;

SparseRows rows_of(const BlockSample& sample) {
  if (!sample.sparse.empty()) return sample.sparse;
  SparseRows rows(sample.jacobian.rows());
  for (Eigen::Index e = 0; e < sample.jacobian.rows(); ++e)
    for (Eigen::Index c = 0; c < sample.jacobian.cols(); ++c)
      if (sample.jacobian(e, c) != 0) rows[e].push_back(static_cast<int>(c), sample.jacobian(e, c));
  return rows;
}

/// The motion of the equations' only freedom, the fastest rate 1; empty where they leave another number.
std::vector<double> way_of(const SparseRows& jacobian, const std::vector<int>& equations, std::size_t coordinates) {
  LoopPartition partition;
  partition.pivots = eliminate({&jacobian}, equations, std::vector<bool>(coordinates, false)).pivots;
  if (partition.pivots.size() + 1 != coordinates) return {};
  std::vector<double> weights(coordinates, 1.0);
  for (const Pivot& pivot : partition.pivots) weights[pivot.coordinate] = 0;
  partition.independent = {static_cast<int>(std::max_element(weights.begin(), weights.end()) - weights.begin())};
  std::vector<double> way = mixed_freedoms(jacobian, partition, weights);
  double fastest = 0;
  for (const double rate : way) fastest = std::max(fastest, std::abs(rate));
  if (!std::isfinite(fastest)) return {};
  for (double& rate : way) rate /= fastest;
  return way;
}

/// Whether all coordinates of a block are where they were, up to whole turns.
bool is_back(const LoopBlock& block, const Configuration& at, const Configuration& reference) {
  return std::ranges::all_of(block.joints, [&](int j) {
    return std::abs(std::remainder(at.z[j] - reference.z[j], 2 * std::numbers::pi)) <= kBackAgain;
  });
}

/// Turns a way so that it goes on where the one before went.
void go_on(const std::vector<double>& before, std::vector<double>& way) {
  double product = 0;
  for (std::size_t c = 0; c < way.size(); ++c) product += before[c] * way[c];
  if (product < 0)
    for (double& rate : way) rate = -rate;
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
      const PairOrder order{{rows[r], columns[c], median(first)}, {rows[1 - r], columns[1 - c], median(second)}};
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
    ordered.push_back({rows[0], columns[0], median(sizes)});
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

/// Smallest share of the fastest rate that a coordinate has along the motion, 0 if it turns back.
double least_share(const MotionAlong& along, int coordinate) {
  double least = 1;
  for (const std::vector<double>& way : along.ways) {
    if ((way[coordinate] < 0) != (along.ways[0][coordinate] < 0)) return 0;
    least = std::min(least, std::abs(way[coordinate]));
  }
  return least;
}

}  // namespace

MotionAlong motion_along(NumericSystem& numbers, std::size_t b, const Configuration& reference,
                         const LoopPartition& partition) {
  const LoopBlock& block = numbers.topology().blocks[b];
  const bool is_single = partition.independent.size() == 1 && partition.driven.empty();
  if (!is_single || partition.pivots.size() < kFollowedFrom || !reference.closed[b]) return {};
  std::vector<std::vector<int>> equations(numbers.topology().blocks.size());
  for (const Pivot& pivot : partition.pivots) equations[b].push_back(pivot.equation);
  std::sort(equations[b].begin(), equations[b].end());
  const std::vector<double> first = way_of(rows_of(reference.blocks[b]), equations[b], block.joints.size());
  if (first.empty()) return {};
  MotionAlong along = {{rows_of(reference.blocks[b])}, {first}};
  bool is_whole = false;
  for (const double sense : {1.0, -1.0}) {
    Configuration at = reference;
    std::vector<double> way = first;
    for (double& rate : way) rate *= sense;
    for (int k = 0; k < kMostStepsAlong && !is_whole; ++k) {
      std::vector<double> start = at.z;
      for (std::size_t c = 0; c < way.size(); ++c) start[block.joints[c]] += kStepAlong * way[c];
      at = close_equations(numbers, std::move(start), equations);
      if (!at.closed[b]) break;
      std::vector<double> next = way_of(rows_of(at.blocks[b]), equations[b], block.joints.size());
      if (next.empty()) break;
      go_on(way, next);
      way = next;
      for (double& rate : next) rate *= sense;
      along.jacobians.push_back(rows_of(at.blocks[b]));
      along.ways.push_back(std::move(next));
      is_whole = along.ways.size() > kFewSteps && is_back(block, at, reference);
    }
  }
  return along;
}

int free_coordinate_along(const MotionAlong& along, const LoopPartition& partition) {
  const int given = partition.independent.empty() ? -1 : partition.independent[0];
  if (along.ways.empty() || least_share(along, given) >= kResting) return given;
  std::vector<double> shares;
  for (int c = 0; c < static_cast<int>(along.ways[0].size()); ++c) shares.push_back(least_share(along, c));
  const double best = *std::max_element(shares.begin(), shares.end());
  if (best < kResting) return given;
  int chosen = given;
  std::ptrdiff_t most = 0;
  for (int c = 0; c < static_cast<int>(shares.size()); ++c) {
    if (shares[c] < std::max(kResting, best / 4)) continue;
    const auto count = std::ranges::count_if(partition.pivots, [&](const Pivot& pivot) {
      return std::abs(along.jacobians[0][pivot.equation].at(c)) > search_numbers::kStructuralZero;
    });
    if (count > most) chosen = c, most = count;
  }
  return chosen;
}

double order_along_motion(const MotionAlong& along, std::size_t coordinates, LoopPartition& partition) {
  if (along.jacobians.empty()) return 1;
  const double least = least_quality(along.jacobians, partition, coordinates);
  if (least >= kSureQuality) return least;
  LoopPartition other = partition;
  other.pivots = ordered_finely(along.jacobians, partition.pivots);
  if (other.pivots.empty()) return least;
  const double of_other = least_quality(along.jacobians, other, coordinates);
  if (!(of_other > 2 * least)) return least;
  partition = std::move(other);
  return of_other;
}

void prefer_along_motion(const MotionAlong& along, std::size_t coordinates, BlockAnalysis& block) {
  if (along.jacobians.empty() || block.candidates.empty()) return;
  std::vector<PartitionCandidate> sure;
  for (PartitionCandidate& candidate : block.candidates) {
    const double least = order_along_motion(along, coordinates, candidate);
    if (least >= kSureQuality) sure.push_back(candidate);
  }
  if (!sure.empty()) block.candidates = std::move(sure);
  take(block, block.candidates[0]);
}

}  // namespace mbgen
