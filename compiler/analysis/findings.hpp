#pragma once
// The decisions of the analysis as data.

#include <string>
#include <vector>

#include "compiler/formulation/loop_partition.hpp"
#include "compiler/topology/topology.hpp"

namespace mbgen {

/// In how many closed configurations a rank was seen.
struct RankCount {
  int rank = 0;
  int configurations = 0;
};

/// A closed configuration in which a block has less than its generic rank.
struct SingularConfiguration {
  int rank = 0;
  int times = 1;          ///< how often it was met
  std::vector<double> z;  ///< positions of LoopBlock::joints, rad or m
};

/// An equation that the others of its block imply.
struct RedundantEquation {
  int equation = 0;      ///< row, local to the block
  int loop = 0;          ///< index into Topology::loops
  std::string name;      ///< `loop.row`
  std::string meaning;   ///< its condition, for example "position along x"
  double residual = -1;  ///< largest seen while the others alone were closed, m or 1; -1: the block cannot move
};

/// Findings on the redundancy of one loop block. Singular values are those of the block Jacobian free of units
/// (metres divided by the largest lever arm), relative to the largest of them, at least 1.
struct Certificate {
  int closed_configurations = 0;
  double reach = 0;                             ///< rad or m, largest change of a coordinate from the reference in them
  std::vector<RankCount> ranks;                 ///< highest rank first
  std::vector<SingularConfiguration> singular;  ///< those below the generic rank
  double smallest_kept = 0;                     ///< weakest singular value that counts as rank, over all configurations
  double largest_dropped = 0;                   ///< strongest one that does not
  int steps = 0;  ///< finite steps along the block's freedoms over which the redundant equations were watched
  std::vector<RedundantEquation> redundant;
  std::vector<int> immobile;   ///< local columns that move in no configuration
  int degrees_of_freedom = 0;  ///< joints less generic rank (driven joints are still counted)
};

/// A partition of a block that was looked at.
struct PartitionCandidate : LoopPartition {
  std::vector<int> triangular_sizes;  ///< sizes of the diagonal blocks of the block-triangular form
  double worst_pivot_ratio = 0;       ///< as BlockAnalysis::worst_pivot_ratio
  double score = 0;                   ///< how well it is conditioned over the samples; 1: as the best of all
  double estimate = 0;                ///< operations, about: of its elimination and projection
  long traced = 0;                    ///< operations of the block's share in the accelerations; 0: not counted
  long operations = 0;                ///< the same after the passes; 0: not counted, or nothing else came near
  bool symmetric = false;             ///< see is_symmetric
};

/// Equations of velocities alone, some of which are redundant. They get pivots after the position equations, so that
/// the latter are kept: only they can be closed.
struct LateRows {
  std::vector<int> equations;  ///< local, ascending; empty where none of them is redundant
  int early_rank = 0;          ///< pivots of the other rows
};

/// Decisions for one loop block; local columns are indices into LoopBlock::joints.
struct BlockAnalysis : LoopPartition {
  int rank = 0;  ///< generic rank of the block Jacobian
  LateRows late;
  std::vector<int> redundant_equations;      ///< local rows left out of the frozen path
  std::vector<std::string> redundant_names;  ///< the same by loop and component, for people
  std::vector<int> triangular_sizes;         ///< sizes of the diagonal blocks of the block-triangular form
  double typical_pivot = 0;      ///< smallest of full pivoting without the driven columns, median over all samples;
                                 ///< 0 when no partition is chosen again, see chooses_again
  double worst_pivot_ratio = 0;  ///< smallest |pivot| / largest entry of its remaining row and column, over all samples
  Certificate certificate;
  /// The partition of the recursive form, over quasi-velocities where joints are balls: one of `candidates`, all over
  /// the equations of this one, so that multipliers are the same. Other coordinates may be independent.
  LoopPartition quasi;
  /// First the best one by its estimate, which the analysis takes, then others, cheapest estimate first. Empty for a
  /// large block and one of rank 0.
  std::vector<PartitionCandidate> candidates;
  int chosen = 0;        ///< index into candidates
  int first_alike = -1;  ///< the first block of the same structure, itself where that is new
  int chosen_like = -1;  ///< block of the same structure whose candidates were counted for it, -1 for itself
};

struct Analysis {
  int closed_configurations = 0;  ///< how many were found and used
  int independent_equations = 0;
  std::vector<RankCount> ranks;  ///< of all blocks together in these configurations, highest first
  int degrees_of_freedom = 0;    ///< coordinates less independent equations (driven coordinates are still counted)
  /// coordinates less independent equations of positions: more than the degrees of freedom, those of velocities, where
  /// bodies roll or slide on blades
  int position_freedoms = 0;
  std::vector<BlockAnalysis> blocks;  ///< one per Topology::blocks
  std::vector<bool> driven;           ///< per tree coordinate
  std::vector<int> motion_of;         ///< per tree coordinate: index into Model::motions or -1
  ActuatedDirections directions;      ///< empty without actuators
  /// Pivots of Rz' B: equations are directions (actuated_coordinates), coordinates actuators. Its independent columns
  /// are actuators beyond the ones that move every direction.
  LoopPartition actuation;
  /// Smallest speed of the actuators, the root of its weighted sum of squares, for free motions with rates of which the
  /// root of the sum of squares is 1; the median over all configurations in which actuators move every direction.
  double typical_actuation = 0;
  std::vector<int> unactuated;  ///< tree coordinates that name directions which no actuator moves alone

  // Defined in findings.cpp: every file that holds an analysis would compile copies of all its lists.
  Analysis();
  Analysis(const Analysis& other);
  Analysis(Analysis&& other) noexcept;
  Analysis& operator=(const Analysis& other);
  Analysis& operator=(Analysis&& other) noexcept;
  ~Analysis();
};

}  // namespace mbgen
