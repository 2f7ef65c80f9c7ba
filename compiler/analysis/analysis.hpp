#pragma once
// The door of the analysis room: what must be decided with numbers, offline, over many closed configurations.

#include "compiler/model/model.hpp"
#include "compiler/topology/topology.hpp"

#include <string>
#include <vector>

namespace mbgen {

/// One step of the frozen elimination of a block's dependent Jacobian.
struct Pivot {
  int equation = 0;        ///< row, local to the block
  int coordinate = 0;      ///< column, local: index into LoopBlock::joints
  double reference = 1;    ///< median |pivot| over the sampled configurations; the monitor watches |pivot| / reference
};

/// Decisions for one loop block.
struct BlockAnalysis {
  int rank = 0;                              ///< generic rank of the block Jacobian
  std::vector<int> dependent;                ///< local columns, ascending; as many as `rank`
  std::vector<int> independent;              ///< local columns, ascending, driven ones left out
  std::vector<int> driven;                   ///< local columns prescribed by motions
  std::vector<int> redundant_equations;      ///< local rows left out of the frozen path
  std::vector<std::string> redundant_names;  ///< the same by loop and component, for people
  std::vector<Pivot> pivots;                 ///< frozen elimination order, block-triangular then Markowitz
  std::vector<int> triangular_sizes;         ///< sizes of the diagonal blocks of the block-triangular form
  double worst_pivot_ratio = 0;              ///< smallest |pivot| / largest entry of its remaining row and column, over all samples
};

struct Analysis {
  int closed_configurations = 0;             ///< how many were found and used
  int independent_equations = 0;
  int degrees_of_freedom = 0;                ///< coordinates less independent equations (driven coordinates are still counted)
  std::vector<BlockAnalysis> blocks;         ///< one per Topology::blocks
  std::vector<bool> driven;                  ///< per tree coordinate
  std::vector<int> motion_of;                ///< per tree coordinate: index into Model::motions or -1
};

/// Decides rank, redundant equations, dependent coordinates and elimination order of each loop block.
/// Fails: a loop that cannot be closed near the reference, redundant equations that contradict (residual and joint named),
/// motions that over-constrain a block, a direction of motion without inertia (coordinate named). Source: theory.md 3, 4, (9).
Result<Analysis> analyse(const Model& model, const Topology& topology);

}  // namespace mbgen
