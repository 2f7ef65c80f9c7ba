#include "compiler/analysis/branch.hpp"

#include <algorithm>
#include <numeric>
#include <random>

#include "compiler/analysis/certificate.hpp"
#include "compiler/analysis/violation.hpp"

namespace mbgen {
namespace {

using Eigen::VectorXd;

constexpr double kBranchStep = 0.05;    // rad, or times the lever arm: too short to reach another assembly mode
constexpr double kShortestShare = 0.1;  // of a step: where that cannot be closed the walk ends
constexpr double kLongestStraight = 2;  // steps that a place is away from the one before
constexpr double kLongestTurn = 4;      // the same where branches meet and the freedom is between them
constexpr int kWalks = 3;               // in different directions, each in both senses
constexpr int kStepsOfWalk = 20;
constexpr int kStepsApart = 5;  // of the places that are kept

/// The whole block first, then its loops alone.
std::vector<BlockPart> parts_of(const Topology& topology, const LoopBlock& block) {
  std::vector<BlockPart> parts{block_part(topology, block, block.loops)};
  if (block.loops.size() > 1)
    for (int l : block.loops) parts.push_back(block_part(topology, block, {l}));
  return parts;
}

/// Walks of one block; the others stay at the reference.
class BranchWalk {
 public:
  BranchWalk(NumericSystem& numbers, std::size_t b, const std::vector<ClosureEquation>& equations, Newton newton)
      : numbers_(numbers), b_(b), equations_(equations), newton_(newton), closing_(numbers.topology().blocks.size()) {
    const LoopBlock& block = numbers.topology().blocks[b];
    whole_ = block_part(numbers.topology(), block, block.loops);
    closing_[b].resize(block.equations);
    std::iota(closing_[b].begin(), closing_[b].end(), 0);
  }

  /// Places along walks whose freedoms are mixed at random, in both senses.
  std::vector<Configuration> places(const Configuration& reference) {
    std::mt19937_64 random(20120406);
    std::vector<Configuration> found;
    for (int w = 0; w < kWalks; ++w) {
      VectorXd mixture(whole_.columns.size());
      for (double& m : mixture) m = static_cast<double>(random() >> 11) * 0x1p-52 - 1.0;
      for (const double sense : {1.0, -1.0}) {
        Configuration here = reference;
        VectorXd direction = sense * mixture;
        std::vector<int> ranks;
        for (int k = 0; k < kStepsOfWalk && step(here, direction); ++k) {
          ranks.push_back(rank_at(here));
          if (left_branch(ranks)) break;
          found.push_back(here);
        }
      }
    }
    return found;
  }

 private:
  int rank_at(const Configuration& here) const {
    return mbgen::view(numbers_, b_, whole_, equations_, {here}).ranks[0];
  }

  /// Along a branch the rank is the same but at places of their own: where two places in a row had less, the walk has
  /// come through a place where branches meet to another one.
  static bool left_branch(const std::vector<int>& ranks) {
    for (std::size_t k = 1; k + 1 < ranks.size(); ++k)
      if (std::max(ranks[k - 1], ranks[k]) < ranks.back()) return true;
    return false;
  }

  /// One step in the freedom nearest to `direction`, which becomes it. False: it cannot be made.
  bool step(Configuration& here, VectorXd& direction) {
    const LoopBlock& block = numbers_.topology().blocks[b_];
    const PartView view = mbgen::view(numbers_, b_, whole_, equations_, {here});
    const Eigen::MatrixXd free = null_space(view.jacobians[0], view.rank);
    direction = (free * (free.transpose() * direction)).eval();
    const double length = direction.size() == 0 ? 0.0 : direction.cwiseAbs().maxCoeff();
    if (!(length > 0)) return false;
    direction /= length;
    const double longest = newton_ == Newton::damped ? kLongestTurn : kLongestStraight;
    for (double size = kBranchStep; size > kShortestShare * kBranchStep; size /= 2) {
      std::vector<double> z = here.z;
      move(block, view, size * direction, z);
      Configuration there = close_equations(numbers_, std::move(z), closing_, newton_);
      int coordinate = 0;
      const double moved = distance(block, view, here.z, there.z, coordinate);
      if (!there.closed[b_] || moved < size / 2 || moved > longest * size) continue;
      here = std::move(there);
      return true;
    }
    return false;
  }

  NumericSystem& numbers_;
  std::size_t b_;
  const std::vector<ClosureEquation>& equations_;
  Newton newton_;
  std::vector<std::vector<int>> closing_;  // all equations of this block
  BlockPart whole_;
};

/// Takes back the random configurations of a block and adds every fifth place of its walks.
void replace(std::size_t b, const std::vector<Configuration>& places, std::vector<Configuration>& configurations) {
  for (std::size_t i = 1; i < configurations.size(); ++i) configurations[i].closed[b] = false;
  for (std::size_t i = kStepsApart - 1; i < places.size(); i += kStepsApart) {
    configurations.push_back(places[i]);
    std::vector<bool>& closed = configurations.back().closed;
    closed.assign(closed.size(), false);
    closed[b] = true;
  }
}

/// Ranks of a block above the rank of its branch; empty if the reference, or a walk from it, reaches all of them. If no
/// plain step leaves the reference, branches may cross there, and the walk continues along one of them.
std::vector<RankCount> keep_block(NumericSystem& numbers, std::size_t b, const std::vector<ClosureEquation>& equations,
                                  std::vector<Configuration>& configurations) {
  const std::vector<BlockPart> parts = parts_of(numbers.topology(), numbers.topology().blocks[b]);
  std::vector<PartView> seen;
  for (const BlockPart& part : parts) seen.push_back(view(numbers, b, part, equations, configurations));
  if (std::all_of(seen.begin(), seen.end(), [](const PartView& v) { return v.ranks[0] == v.rank; })) return {};
  std::vector<Configuration> places = BranchWalk(numbers, b, equations, Newton::full).places(configurations[0]);
  if (places.empty()) places = BranchWalk(numbers, b, equations, Newton::damped).places(configurations[0]);
  bool others = false;
  std::vector<int> above;
  for (std::size_t p = 0; p < parts.size(); ++p) {
    int rank = seen[p].ranks[0];
    if (!places.empty()) rank = std::max(rank, view(numbers, b, parts[p], equations, places).rank);
    others = others || seen[p].rank > rank;
    for (int other : seen[p].ranks)
      if (p == 0 && other > rank) above.push_back(other);
  }
  if (others) replace(b, places, configurations);
  return rank_counts(above);
}

}  // namespace

std::vector<std::vector<RankCount>> stay_on_branch(NumericSystem& numbers,
                                                   const std::vector<std::vector<ClosureEquation>>& equations,
                                                   std::vector<Configuration>& configurations) {
  const Topology& topology = numbers.topology();
  std::vector<std::vector<RankCount>> others(topology.blocks.size());
  for (std::size_t b = 0; b < topology.blocks.size(); ++b)
    if (!is_large(topology.blocks[b]) && configurations[0].closed[b])
      others[b] = keep_block(numbers, b, equations[b], configurations);
  return others;
}

}  // namespace mbgen
