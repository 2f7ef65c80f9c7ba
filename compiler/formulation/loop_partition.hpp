#pragma once
// How a loop block is split and solved: which coordinates depend on which, and in what order they are eliminated.

#include <vector>

namespace mbgen {

/// One step of the frozen elimination of a block's dependent Jacobian.
struct Pivot {
  int equation = 0;      ///< row, local to the block
  int coordinate = 0;    ///< column, local: index into LoopBlock::joints
  double reference = 1;  ///< median |pivot| over the sampled configurations; the monitor watches |pivot| / reference
};

/// Partition of a block's coordinates (local columns: indices into LoopBlock::joints, ascending).
struct LoopPartition {
  std::vector<int> dependent;    ///< as many as the rank
  std::vector<int> independent;  ///< driven ones left out
  std::vector<int> driven;       ///< prescribed by motions
  std::vector<Pivot> pivots;     ///< frozen elimination order, block-triangular then Markowitz
};

/// The directions that actuators move in inverse dynamics: the free ones, and those of motions that actuators give.
struct ActuatedDirections {
  std::vector<LoopPartition> partitions;  ///< one per block, coordinates of such motions independent
  std::vector<bool> held;                 ///< per tree coordinate: by other motions
};

}  // namespace mbgen
