#pragma once
// The door of the analysis room: what must be decided with numbers, offline, over many closed configurations.

#include <string>
#include <vector>

#include "compiler/formulation/loop_partition.hpp"
#include "compiler/model/model.hpp"
#include "compiler/topology/topology.hpp"

namespace mbgen {

/// Decisions for one loop block; local columns are indices into LoopBlock::joints.
struct BlockAnalysis : LoopPartition {
  int rank = 0;                              ///< generic rank of the block Jacobian
  std::vector<int> redundant_equations;      ///< local rows left out of the frozen path
  std::vector<std::string> redundant_names;  ///< the same by loop and component, for people
  std::vector<int> triangular_sizes;         ///< sizes of the diagonal blocks of the block-triangular form
  double typical_pivot = 0;      ///< smallest of full pivoting without the driven columns, median over all samples
  double worst_pivot_ratio = 0;  ///< smallest |pivot| / largest entry of its remaining row and column, over all samples
};

struct Analysis {
  int closed_configurations = 0;  ///< how many were found and used
  int independent_equations = 0;
  int degrees_of_freedom = 0;         ///< coordinates less independent equations (driven coordinates are still counted)
  std::vector<BlockAnalysis> blocks;  ///< one per Topology::blocks
  std::vector<bool> driven;           ///< per tree coordinate
  std::vector<int> motion_of;         ///< per tree coordinate: index into Model::motions or -1
};

/// Which coordinate names which free direction: the independent, undriven coordinates, group by group.
std::vector<int> free_coordinates(const Topology& topology, const Analysis& analysis);

/// Decides rank, redundant equations, dependent coordinates and elimination order of each loop block.
/// Fails: a loop that cannot be closed near the reference, redundant equations that contradict (residual and joint
/// named), motions that over-constrain a block, a direction of motion without inertia (coordinate named). Source:
/// theory.md 3, 4, (9).
Result<Analysis> analyse(const Model& model, const Topology& topology);

}  // namespace mbgen
