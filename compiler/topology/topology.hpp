#pragma once
// Interface of the topology room: Model -> Topology. Graph facts only, no physics, no scalar type.

#include <algorithm>
#include <string>
#include <vector>

#include "compiler/model/model.hpp"
#include "mbgen/solver/ball.hpp"

namespace mbgen {

constexpr int kGround = -1;

/// A body of the spanning tree and the single-freedom joint to its parent: coordinate i, joint i and body i share the
/// index i. Parents have lower indices than their children; the paper's leaf-to-root number of body i is n - i
/// (1-based).
struct TreeBody {
  std::string name;        ///< the model body, or "<joint>_aux1".. for the massless bodies inside a joint
  std::string coordinate;  ///< name of the coordinate, for example "chassis_rz"
  int parent = kGround;    ///< tree index
  int model_body = -1;     ///< index into Model::bodies, -1 for an auxiliary body
  int joint = -1;          ///< index into Model::joints
  int component = 0;       ///< index into Joint::freedoms
  FreedomKind kind = FreedomKind::revolute;
  Vector3 axis{0, 0, 1};  ///< unit, global axes at the reference: direction of motion for a positive coordinate
  bool reversed = false;  ///< the tree runs from `to` to `from`: order and axis are already reversed
  bool massless = false;  ///< mass and inertia are exactly zero and not tunable, no rod end with mass is attached
};

enum class ClosureKind {
  spherical,
  revolute,
  prismatic,
  universal,
  cylindrical,
  planar,
  fixed,
  rod,
  point_on_line,
  point_on_plane,
  parallel_axes,
  orientation,
  homokinetic,
  coupling,
  rolling_disc,
  rolling_ball,
  knife_edge
};

/// Name in the model format.
const char* name_of(ClosureKind kind);

/// Kinds with nonholonomic rows, constraints on velocities only.
constexpr bool is_rolling(ClosureKind kind) { return kind >= ClosureKind::rolling_disc; }

/// A closure: a cut joint, a rod or a coupling. A cut joint of type free has no equations and is not listed.
struct Loop {
  std::string name;
  ClosureKind kind = ClosureKind::spherical;
  int joint = -1;     ///< index into Model::joints, or -1
  int rod = -1;       ///< index into Model::rods, or -1
  int coupling = -1;  ///< index into Model::couplings, or -1
  int length = -1;    ///< of a rod with prescribed length: tree index of this coordinate
  int body_from =
      kGround;  ///< tree indices of the two closed bodies, kGround for ground; of a coupling the bodies that its
  int body_to = kGround;   ///< first and last coordinates move
  int ancestor = kGround;  ///< lowest common ancestor (tree index), of a coupling: of the bodies they move on
  /// ascending tree joints above the ancestor: symmetric difference of two rows of T, of a coupling the union of its
  std::vector<int> joints;
  int equations = 0;              ///< number of closure_rows of the joint's type, 1 for a rod or coupling
  std::vector<std::string> rows;  ///< their names, closure_rows of the joint's type
};

/// A joint of the spanning tree, including fixed ones, as seen from ground.
struct TreeJoint {
  int joint = -1;  ///< index into Model::joints
  int parent = -1,
      child = -1;         ///< indices into Model::bodies: the body that was there, and the one that the joint holds
  bool reversed = false;  ///< the parent is the joint's `to` body
};

/// Loops connected by common joints, directly or through other loops.
struct LoopBlock {
  std::vector<int> loops;   ///< ascending indices into Topology::loops
  std::vector<int> joints;  ///< ascending tree indices
  int base = kGround;       ///< body that carries the block: lowest common ancestor of its loops
  int equations = 0;
  bool opened = false;  ///< the recursive form solves it joint by joint with multipliers of its loops, see mark_opened
};

/// A loop block or a single joint outside all blocks: the unit of projection and elimination.
struct JointGroup {
  int block = -1;           ///< index into Topology::blocks, -1 for a single joint
  std::vector<int> joints;  ///< ascending tree indices
  int base = kGround;       ///< body the group moves on
  int parent = -1;          ///< group of the base body's joint, -1 on ground; parents come before children
};

struct Topology {
  std::vector<TreeBody> bodies;            ///< n tree bodies, parents first
  std::vector<std::vector<int>> children;  ///< children[i], ascending
  std::vector<int> roots;                  ///< bodies whose parent is ground
  std::vector<int> tree_body;              ///< per model body: the tree index it moves with, kGround for ground
  std::vector<TreeJoint> tree_joints;      ///< one per model body but ground, parents before children
  std::vector<Loop> loops;                 ///< in order: cut joints as in the model, then rods, then couplings
  std::vector<LoopBlock> blocks;
  std::vector<JointGroup> groups;        ///< parents before children
  std::vector<int> group_of;             ///< per tree joint
  std::vector<Ball> balls;               ///< with two charts, see find_balls
  std::vector<std::string> cut_reasons;  ///< per cut joint, reason of the cut: "marked", or the rule
  int size() const { return static_cast<int>(bodies.size()); }

  // Defined in topology.cpp: every file that holds a topology would compile copies of all its lists.
  Topology();
  Topology(const Topology& other);
  Topology(Topology&& other) noexcept;
  Topology& operator=(const Topology& other);
  Topology& operator=(Topology&& other) noexcept;
  ~Topology();
};

/// Largest number of entries of a block Jacobian, and of its free directions Rz, for a new choice of the partition at
/// run time, by full pivoting of the dense matrix: 1 MB on the stack each. A larger block keeps its partition, and is
/// singular if this becomes ill-conditioned.
constexpr long kMostPivotedEntries = 131072;
/// Largest number of operations, about, of a block's share in the accelerations over a partition chosen at run time:
/// its mass matrix over dense free directions. 275 000 were counted for 49 joints with 47 freedoms, 19 000 for 19
/// with 17.
constexpr long kMostChosenOperations = 524288;

/// Freedoms of a block, at least.
inline long least_freedoms(const LoopBlock& block) {
  return std::max(0L, static_cast<long>(block.joints.size()) - block.equations);
}
inline bool chooses_again(const LoopBlock& block) {
  const long joints = static_cast<long>(block.joints.size()), free = least_freedoms(block);
  if (joints * std::max(static_cast<long>(block.equations), free) > kMostPivotedEntries) return false;
  return block.opened || 5 * joints * free * free / 2 <= kMostChosenOperations;
}

/// Finds the tree, the cuts, the loops and the blocks. Fails: a body with no path to ground, joints marked "cut": false
/// that form a cycle (two tree parents), a cut joint with a used coordinate (driven, sprung, named in an expression, an
/// output or a start value), a loop without moving bodies, a model without moving bodies, an output for a multiplier of
/// a joint in the tree; messages name the body or joint and its position. Source: theory.md sections 1 and 3.
Result<Topology> build_topology(const Model& model);

/// Ball joints (in spherical and free joints of the tree) with changeable charts: no law of the model, such as a
/// motion, a force, a spring or a coupling, is on one of their angles. None in a block that keeps its partition, see
/// chooses_again.
std::vector<Ball> find_balls(const Model& model, const Topology& topology);

/// Index of the ball joint that starts with a tree joint, or -1.
int ball_from(const Topology& topology, int joint);

/// True if joint j lies on the path from the root to body i, T_ij of (39). kGround is on no path.
bool on_path(const Topology& topology, int i, int j);

/// Dense path matrix T, row i and column j in the paper's leaf-to-root numbering (39).
std::vector<std::vector<int>> path_matrix(const Topology& topology);

/// Lowest common ancestor of two tree bodies, kGround if they are connected through ground only.
int lowest_common_ancestor(const Topology& topology, int a, int b);

/// Joint indices from body i (inclusive) towards `base` (exclusive), leaf first.
std::vector<int> path_to(const Topology& topology, int i, int base);

/// Tree index of a coordinate of the model, or -1 if its joint was cut.
int tree_coordinate(const Topology& topology, const CoordinateReference& reference);

/// Position in the model of the joint, rod or coupling that closes a loop.
const Where& where_of(const Model& model, const Loop& loop);

/// Rows of a loop that are nonholonomic (constraints on velocities only), in their order: they are never open.
bool holds_velocity_alone(const Model& model, const Loop& loop, int row);

/// Nonholonomic rows of a block, local, ascending.
std::vector<int> velocity_rows(const Model& model, const Topology& topology, const LoopBlock& block);

/// First loop with nonholonomic rows, or null.
const Loop* rolling_loop(const Topology& topology);

/// Number of equations of all loops, including redundant ones.
int equation_count(const Topology& topology);

/// Index of the coordinate of this name, or -1.
int find_coordinate(const Topology& topology, const std::string& name);

}  // namespace mbgen
