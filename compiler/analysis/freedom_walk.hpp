#pragma once
// Closed configurations of large loop blocks: a walk from the reference along their freedoms.

#include <random>
#include <vector>

#include "compiler/analysis/configuration.hpp"

namespace mbgen {

constexpr int kWalkLength = 4;  ///< configurations in one direction, before the walk turns round

/// The walk of one large block.
struct FreedomWalk {
  std::size_t block = 0;
  LoopPartition partition;      ///< by the pivots at the reference
  std::vector<double> weights;  ///< motion of the independent coordinates, per coordinate of the block
  std::mt19937_64 random{20120405};
};

/// One walk for each large block that is closed at the reference. equations: per block, those to close; of a large
/// block only those with a pivot at the reference stay.
std::vector<FreedomWalk> start_walks(const NumericSystem& numbers, const Configuration& reference,
                                     std::vector<std::vector<int>>& equations);

/// Puts the next position of a walk, to be closed, into `start`: a step from the last of `found` or, where the walk
/// turns, from the reference, which is the first.
void put_next_position(const Topology& topology, const std::vector<Configuration>& found, int attempt,
                       FreedomWalk& walk, std::vector<double>& start);

/// The motion of a large block whose independent coordinates move by `weights` (per coordinate): Phi_z x = 0.
std::vector<double> mixed_freedoms(const SparseRows& jacobian, const LoopPartition& partition,
                                   const std::vector<double>& weights);

}  // namespace mbgen
