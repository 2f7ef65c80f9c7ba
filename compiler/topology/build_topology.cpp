// The spanning tree joint by joint, its loops, and the bodies that move together.

#include <algorithm>
#include <functional>
#include <iterator>
#include <numeric>
#include <queue>
#include <set>

#include "compiler/topology/opened_blocks.hpp"
#include "compiler/topology/spanning_tree.hpp"
#include "compiler/topology/topology.hpp"

namespace mbgen {
namespace {

ClosureKind closure_kind(JointType type) {
  switch (type) {
    case JointType::revolute:
      return ClosureKind::revolute;
    case JointType::prismatic:
      return ClosureKind::prismatic;
    case JointType::universal:
      return ClosureKind::universal;
    case JointType::cylindrical:
      return ClosureKind::cylindrical;
    case JointType::planar:
      return ClosureKind::planar;
    case JointType::fixed:
      return ClosureKind::fixed;
    case JointType::point_on_line:
      return ClosureKind::point_on_line;
    case JointType::point_on_plane:
      return ClosureKind::point_on_plane;
    case JointType::parallel_axes:
      return ClosureKind::parallel_axes;
    case JointType::orientation:
      return ClosureKind::orientation;
    case JointType::homokinetic:
      return ClosureKind::homokinetic;
    case JointType::rolling_disc:
      return ClosureKind::rolling_disc;
    case JointType::rolling_ball:
      return ClosureKind::rolling_ball;
    case JointType::knife_edge:
      return ClosureKind::knife_edge;
    case JointType::spherical:
    case JointType::free:
      break;
  }
  return ClosureKind::spherical;
}

bool is_zero(const Quantity& quantity) { return quantity.expression < 0 && quantity.value == 0; }

Vector3 negated(const Vector3& axis) {
  const auto minus = [](double x) { return x == 0 ? 0.0 : -x; };  // no -0 in printed axes
  return {minus(axis[0]), minus(axis[1]), minus(axis[2])};
}

// Adds the tree bodies of one joint from the placed body to the new one; returns the tree index that the new body moves
// with.
int place_joint(Topology& topology, const Model& model, int index, bool reversed) {
  const Joint& joint = model.joints[index];
  const int parent_body = reversed ? joint.to.body : joint.from.body;
  const int child_body = reversed ? joint.from.body : joint.to.body;
  const int count = static_cast<int>(joint.freedoms.size());
  int parent = topology.tree_body[parent_body];
  for (int k = 0; k < count; ++k) {
    const int component = reversed ? count - 1 - k : k;
    const Freedom& freedom = joint.freedoms[component];
    TreeBody body;
    body.name = k + 1 == count ? model.bodies[child_body].name : joint.name + "_aux" + std::to_string(k + 1);
    body.coordinate = freedom.name;
    body.parent = parent;
    body.model_body = k + 1 == count ? child_body : -1;
    body.joint = index;
    body.component = component;
    body.kind = freedom.kind;
    body.axis = reversed ? negated(freedom.axis) : freedom.axis;
    body.reversed = reversed;
    parent = topology.size();
    topology.bodies.push_back(std::move(body));
  }
  return parent;
}

// Stable topological order: always the first declared joint at a placed body.
void place_bodies(Topology& topology, const Model& model, const std::vector<bool>& in_tree) {
  topology.tree_body.assign(model.bodies.size(), kGround);
  if (model.ground < 0) return;
  std::vector<std::vector<int>> joints_of(model.bodies.size());
  for (std::size_t j = 0; j < model.joints.size(); ++j) {
    if (!in_tree[j]) continue;
    joints_of[model.joints[j].from.body].push_back(static_cast<int>(j));
    joints_of[model.joints[j].to.body].push_back(static_cast<int>(j));
  }
  std::vector<bool> placed(model.bodies.size());
  std::priority_queue<int, std::vector<int>, std::greater<>> ready;
  const auto open = [&](int body) {
    placed[body] = true;
    for (int j : joints_of[body]) ready.push(j);
  };
  open(model.ground);
  while (!ready.empty()) {
    const int index = ready.top();
    ready.pop();
    const Joint& joint = model.joints[index];
    if (placed[joint.from.body] && placed[joint.to.body]) continue;
    const bool reversed = !placed[joint.from.body];
    const int child = reversed ? joint.from.body : joint.to.body;
    topology.tree_body[child] = place_joint(topology, model, index, reversed);
    topology.tree_joints.push_back({index, reversed ? joint.to.body : joint.from.body, child, reversed});
    open(child);
  }
  topology.children.resize(topology.bodies.size());
  for (int i = 0; i < topology.size(); ++i) {
    const int parent = topology.bodies[i].parent;
    (parent == kGround ? topology.roots : topology.children[parent]).push_back(i);
  }
}

void mark_massless(Topology& topology, const Model& model) {
  for (TreeBody& body : topology.bodies) body.massless = true;
  const auto give_mass = [&](int model_body) {
    const int index = topology.tree_body[model_body];
    if (index != kGround) topology.bodies[index].massless = false;
  };
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    const Body& body = model.bodies[b];
    const bool no_inertia = std::all_of(body.inertia.begin(), body.inertia.end(), is_zero);
    if (!is_zero(body.mass) || !no_inertia) give_mass(static_cast<int>(b));
  }
  for (const Rod& rod : model.rods) {
    if (is_zero(rod.mass)) continue;
    give_mass(rod.from.body);
    give_mass(rod.to.body);
  }
}

// Checks that something moves between the bodies of a loop.
bool check_loop(const Model& model, const Loop& loop, const Attachment& from, const Attachment& to, const Where& where,
                Diagnostics& problems) {
  if (loop.body_from != loop.body_to) return true;
  const std::string what = (loop.rod >= 0 ? "rod " : "joint ") + quoted(loop.name);
  const std::string &a = model.bodies[from.body].name, &b = model.bodies[to.body].name;
  const bool same = from.body == to.body;
  problems.push_back({where,
                      what + (same ? " has both ends on body " + quoted(a)
                                   : " closes a loop in which nothing moves: bodies " + quoted(a) + " and " +
                                         quoted(b) + " are fixed to each other"),
                      same ? "connect two bodies" : "remove it, or one of the fixed joints between them", ""});
  return false;
}

void add_loop(Topology& topology, Loop loop) {
  loop.ancestor = lowest_common_ancestor(topology, loop.body_from, loop.body_to);
  for (int end : {loop.body_from, loop.body_to}) {
    const std::vector<int> path = path_to(topology, end, loop.ancestor);
    loop.joints.insert(loop.joints.end(), path.begin(), path.end());
  }
  if (loop.length >= 0) loop.joints.push_back(loop.length);
  std::sort(loop.joints.begin(), loop.joints.end());
  topology.loops.push_back(std::move(loop));
}

/// A coupling is no closure in space: its loop consists of the joints between the bodies of its coordinates.
Loop coupling_loop(const Topology& topology, const Model& model, std::size_t index) {
  const Coupling& coupling = model.couplings[index];
  Loop loop;
  loop.name = coupling.name;
  loop.kind = ClosureKind::coupling;
  loop.coupling = static_cast<int>(index);
  loop.rows = {std::string(kCouplingRow.name)};
  loop.equations = 1;
  std::vector<int> coupled;
  for (const CoordinateReference& c : coupling.coordinates) coupled.push_back(tree_coordinate(topology, c));
  loop.body_from = coupled.front();
  loop.body_to = coupled.back();
  loop.ancestor = topology.bodies[coupled.front()].parent;
  for (const int joint : coupled)
    loop.ancestor = lowest_common_ancestor(topology, loop.ancestor, topology.bodies[joint].parent);
  std::set<int> joints;
  for (const int joint : coupled) {
    const std::vector<int> path = path_to(topology, joint, loop.ancestor);
    joints.insert(path.begin(), path.end());
  }
  loop.joints.assign(joints.begin(), joints.end());
  return loop;
}

void find_loops(Topology& topology, const Model& model, const SpanningTree& tree, Diagnostics& problems) {
  for (std::size_t j = 0; j < model.joints.size(); ++j) {
    const Joint& joint = model.joints[j];
    if (tree.in_tree[j] || joint.type == JointType::free) continue;
    Loop loop;
    loop.name = joint.name;
    loop.kind = closure_kind(joint.type);
    loop.joint = static_cast<int>(j);
    loop.body_from = topology.tree_body[joint.from.body];
    loop.body_to = topology.tree_body[joint.to.body];
    for (const ClosureRow& row : closure_rows(joint.type)) loop.rows.emplace_back(row.name);
    loop.equations = static_cast<int>(loop.rows.size());
    if (!check_loop(model, loop, joint.from, joint.to, joint.where, problems)) continue;
    add_loop(topology, std::move(loop));
    topology.cut_reasons.push_back(tree.cut_reason[j]);
  }
  for (std::size_t r = 0; r < model.rods.size(); ++r) {
    const Rod& rod = model.rods[r];
    Loop loop;
    loop.name = rod.name;
    loop.kind = ClosureKind::rod;
    loop.rod = static_cast<int>(r);
    if (rod.drive >= 0) loop.length = tree_coordinate(topology, {rod.drive, 0});
    loop.body_from = topology.tree_body[rod.from.body];
    loop.body_to = topology.tree_body[rod.to.body];
    loop.rows = {std::string(kRodRow.name)};
    loop.equations = 1;
    if (check_loop(model, loop, rod.from, rod.to, rod.where, problems)) add_loop(topology, std::move(loop));
  }
  for (std::size_t c = 0; c < model.couplings.size(); ++c) topology.loops.push_back(coupling_loop(topology, model, c));
}

// Checks requests for multipliers: only cut joints, rods and couplings have them.
void check_multipliers(const Topology& topology, const Model& model, Diagnostics& problems) {
  for (const Output& output : model.outputs) {
    const auto* source = std::get_if<MultiplierOutput>(&output.source);
    if (!source || source->joint < 0) continue;
    const auto in_tree = [&](const TreeJoint& placed) { return placed.joint == source->joint; };
    if (std::none_of(topology.tree_joints.begin(), topology.tree_joints.end(), in_tree)) continue;
    const int closure = model.joints[source->joint].closure;
    problems.push_back({output.where,
                        "output " + quoted(output.name) + " asks for a multiplier of joint " +
                            quoted(model.joints[source->joint].name) + ", which is in the tree and has none",
                        closure < 0 ? "ask for its \"reaction\", or mark the joint \"cut\": true"
                                    : "ask for its \"reaction\", or for a multiplier of " +
                                          quoted(model.joints[closure].name) + ", which closes its loop",
                        ""});
  }
}

// Joints of one loop belong to one block; `leader` points from a joint towards the lowest joint of its block.
std::vector<int> joint_leaders(const Topology& topology) {
  std::vector<int> leader(topology.bodies.size());
  std::iota(leader.begin(), leader.end(), 0);
  const auto find = [&](int joint) {
    while (leader[joint] != joint) joint = leader[joint] = leader[leader[joint]];
    return joint;
  };
  for (const Loop& loop : topology.loops) {
    for (int joint : loop.joints) {
      const int a = find(loop.joints.front()), b = find(joint);
      leader[std::max(a, b)] = std::min(a, b);
    }
  }
  for (int joint = 0; joint < topology.size(); ++joint) leader[joint] = find(joint);
  return leader;
}

// Blocks are sorted by their lowest joints, so that a block follows the block of its base body.
void find_blocks(Topology& topology, const std::vector<int>& leader) {
  std::vector<int> block_of_leader(topology.bodies.size(), -1);
  std::vector<bool> closed(topology.bodies.size());
  for (const Loop& loop : topology.loops) closed[leader[loop.joints.front()]] = true;
  for (int joint = 0; joint < topology.size(); ++joint) {
    if (!closed[leader[joint]]) continue;
    int& block = block_of_leader[leader[joint]];
    if (block < 0) {
      block = static_cast<int>(topology.blocks.size());
      topology.blocks.emplace_back();
    }
    topology.blocks[block].joints.push_back(joint);
  }
  for (std::size_t l = 0; l < topology.loops.size(); ++l) {
    const Loop& loop = topology.loops[l];
    LoopBlock& block = topology.blocks[block_of_leader[leader[loop.joints.front()]]];
    block.base = block.loops.empty() ? loop.ancestor : lowest_common_ancestor(topology, block.base, loop.ancestor);
    block.loops.push_back(static_cast<int>(l));
    block.equations += loop.equations;
  }
}

void find_groups(Topology& topology) {
  std::vector<int> block_of(topology.bodies.size(), -1);
  for (std::size_t b = 0; b < topology.blocks.size(); ++b) {
    for (int joint : topology.blocks[b].joints) block_of[joint] = static_cast<int>(b);
  }
  topology.group_of.assign(topology.bodies.size(), -1);
  for (int joint = 0; joint < topology.size(); ++joint) {
    if (topology.group_of[joint] >= 0) continue;
    const int block = block_of[joint];
    JointGroup group;
    group.block = block;
    group.joints = block < 0 ? std::vector<int>{joint} : topology.blocks[block].joints;
    group.base = block < 0 ? topology.bodies[joint].parent : topology.blocks[block].base;
    group.parent = group.base == kGround ? -1 : topology.group_of[group.base];
    for (int member : group.joints) topology.group_of[member] = static_cast<int>(topology.groups.size());
    topology.groups.push_back(std::move(group));
  }
}

}  // namespace

Result<Topology> build_topology(const Model& model) {
  const Result<SpanningTree> tree = choose_spanning_tree(model);
  if (!tree) return tree.problems();
  Topology topology;
  place_bodies(topology, model, tree->in_tree);
  Diagnostics problems;
  find_loops(topology, model, *tree, problems);
  check_multipliers(topology, model, problems);
  if (topology.bodies.empty() && problems.empty()) {
    Where whole_file;
    whole_file.file = model.file;
    problems.push_back({whole_file, "the model has no joint that moves a body", "add a body and a joint", ""});
  }
  if (!problems.empty()) return problems;
  mark_massless(topology, model);
  find_blocks(topology, joint_leaders(topology));
  find_groups(topology);
  mark_opened(model, topology);
  topology.balls = find_balls(model, topology);
  return topology;
}

}  // namespace mbgen
