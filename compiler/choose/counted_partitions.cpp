#include "compiler/choose/counted_partitions.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>

#include "compiler/passes/passes.hpp"
#include "compiler/program/in_threads.hpp"
#include "compiler/trace/each_program.hpp"

namespace mbgen {
namespace {

// Relative distance within which passes may change the order of candidates: on coach and truck they removed 220 to 247
// operations of 4400, 300 to 310 of 7450, and 6 to 26 of shares of 2200 and less.
constexpr double kNearShare = 0.005;
constexpr double kLeastNear = 16;          // operations
constexpr std::size_t kMostOptimised = 3;  // per block: a pass takes longer than a trace

/// Blocks of one structure, in their order.
using Twins = std::vector<int>;

/// Groups of blocks with more than one candidate, short lists first.
std::vector<Twins> groups_of_twins(const Analysis& analysis) {
  std::map<int, Twins> by_first;
  for (std::size_t b = 0; b < analysis.blocks.size(); ++b)
    if (analysis.blocks[b].candidates.size() > 1)
      by_first[analysis.blocks[b].first_alike].push_back(static_cast<int>(b));
  std::vector<Twins> groups;
  for (auto& [first, twins] : by_first) groups.push_back(std::move(twins));
  const auto order = [&](const Twins& twins) {
    return std::pair(analysis.blocks[twins[0]].candidates.size(), twins[0]);
  };
  std::sort(groups.begin(), groups.end(), [&](const Twins& a, const Twins& b) { return order(a) < order(b); });
  return groups;
}

/// Indices of the candidates that may be the cheapest after the passes, in the order of the list.
std::vector<int> nearest(const std::vector<PartitionCandidate>& candidates, std::vector<int> among) {
  std::stable_sort(among.begin(), among.end(),
                   [&](int a, int b) { return candidates[a].traced < candidates[b].traced; });
  const auto least = static_cast<double>(candidates[among[0]].traced);
  const double most = least + std::max(kLeastNear, kNearShare * least);
  std::erase_if(among, [&](int c) { return static_cast<double>(candidates[c].traced) > most; });
  if (among.size() > kMostOptimised) among.resize(kMostOptimised);
  std::sort(among.begin(), among.end());
  return among;
}

/// Counts the first `most` candidates of a block and chooses one of them.
int choose(const Model& model, const Topology& topology, const Analysis& analysis, int b, int most,
           std::vector<PartitionCandidate>& candidates) {
  const auto traced = [&](int c, TraceOrder order) {
    return trace_block(model, topology, analysis, b, candidates[c], order);
  };
  std::vector<int> counted(std::min(static_cast<std::size_t>(most), candidates.size())), with_mirror;
  std::iota(counted.begin(), counted.end(), 0);
  in_threads(counted.size(), [&](std::size_t c) {
    candidates[c].traced = count_operations(traced(static_cast<int>(c), TraceOrder::as_recorded)).total();
  });
  long least = std::numeric_limits<long>::max();
  for (const int c : counted) least = std::min(least, candidates[c].traced);
  for (const int c : counted)
    if (candidates[c].symmetric && static_cast<double>(candidates[c].traced) <= (1 + kSymmetryBonus) * least)
      with_mirror.push_back(c);
  const std::vector<int> near = nearest(candidates, with_mirror.empty() ? counted : with_mirror);
  if (near.size() == 1) return near[0];
  in_threads(near.size(), [&](std::size_t i) {
    candidates[near[i]].operations = count_operations(optimise(traced(near[i], TraceOrder::canonical))).total();
  });
  return *std::min_element(near.begin(), near.end(),
                           [&](int a, int b) { return candidates[a].operations < candidates[b].operations; });
}

/// Chooses the same coordinates as for block `twin`, of the same structure, if they are on the list.
void take_like(int twin, const Analysis& analysis, BlockAnalysis& block) {
  const BlockAnalysis& other = analysis.blocks[twin];
  for (std::size_t c = 0; c < block.candidates.size(); ++c)
    if (block.candidates[c].dependent == other.candidates[other.chosen].dependent) {
      block.chosen = static_cast<int>(c);
      block.chosen_like = twin;
    }
}

}  // namespace

void choose_by_counting(const Model& model, const Topology& topology, Analysis& analysis) {
  const std::vector<Twins> groups = groups_of_twins(analysis);
  int left = kMostCounted;
  for (std::size_t g = 0; g < groups.size(); ++g) {
    const int share = left / static_cast<int>(groups.size() - g);
    BlockAnalysis& first = analysis.blocks[groups[g][0]];
    if (share < 2) continue;
    first.chosen = choose(model, topology, analysis, groups[g][0], share, first.candidates);
    left -= std::min(share, static_cast<int>(first.candidates.size()));
    for (const int twin : groups[g])
      if (twin != groups[g][0]) take_like(groups[g][0], analysis, analysis.blocks[twin]);
  }
  for (BlockAnalysis& block : analysis.blocks)
    if (!block.candidates.empty()) block.quasi = block.candidates[block.chosen];
}

}  // namespace mbgen
