#include "compiler/topology/graph.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace mbgen {
namespace {

/// The tree in the making: clusters get a tree body as their joints are placed.
struct Builder {
  const Model& model;
  const Clusters& clusters;
  const TreeChoice& choice;
  Topology topology;
  std::vector<int> tree_of_cluster;   // kGround for ground, kUnplaced before it is reached
  static constexpr int kUnplaced = -2;

  Builder(const Model& m, const Clusters& c, const TreeChoice& t)
      : model(m), clusters(c), choice(t), tree_of_cluster(c.count, kUnplaced) {
    tree_of_cluster[c.ground] = kGround;
  }
  int cluster_of(const Attachment& at) const { return clusters.cluster[at.body]; }
};

/// Adds a joint's freedoms as tree bodies; the last one carries the child.
void place_joint(Builder& b, int index) {
  const Joint& joint = b.model.joints[index];
  const bool reversed = b.tree_of_cluster[b.cluster_of(joint.from)] == Builder::kUnplaced;
  int parent = b.tree_of_cluster[b.cluster_of(reversed ? joint.to : joint.from)];
  const Attachment& child = reversed ? joint.from : joint.to;
  const int count = static_cast<int>(joint.freedoms.size());
  for (int k = 0; k < count; ++k) {
    const int component = reversed ? count - 1 - k : k;
    const Freedom& freedom = joint.freedoms[component];
    TreeBody body;
    body.name = k + 1 == count ? b.model.bodies[child.body].name : fmt::format("{}_aux{}", joint.name, k + 1);
    body.coordinate = freedom.name;
    body.parent = parent;
    body.model_body = k + 1 == count ? child.body : -1;
    body.joint = index;
    body.component = component;
    body.kind = freedom.kind;
    body.axis = freedom.axis;
    if (reversed)
      for (double& value : body.axis) value = value == 0 ? 0 : -value;
    body.reversed = reversed;
    parent = b.topology.size();
    b.topology.bodies.push_back(std::move(body));
  }
  b.tree_of_cluster[b.cluster_of(child)] = parent;
}

/// Places joints in file order, each as soon as one of its bodies is reached.
void place_joints(Builder& b) {
  std::vector<bool> placed(b.model.joints.size(), false);
  for (bool progress = true; progress;) {
    progress = false;
    for (std::size_t j = 0; j < b.model.joints.size(); ++j) {
      if (placed[j] || !b.choice.in_tree[j]) continue;
      const int from = b.tree_of_cluster[b.cluster_of(b.model.joints[j].from)], to = b.tree_of_cluster[b.cluster_of(b.model.joints[j].to)];
      if (from == Builder::kUnplaced && to == Builder::kUnplaced) continue;
      place_joint(b, static_cast<int>(j));
      placed[j] = true;
      progress = true;
      break;   // earlier joints may have become reachable: file order is kept as far as it goes
    }
  }
}

Diagnostics unreached(const Builder& b) {
  Diagnostics problems;
  std::vector<bool> said(b.clusters.count, false);
  for (std::size_t i = 0; i < b.model.bodies.size(); ++i) {
    const int cluster = b.clusters.cluster[i];
    if (b.tree_of_cluster[cluster] != Builder::kUnplaced || said[cluster]) continue;
    said[cluster] = true;
    problems.push_back({b.model.bodies[i].where, fmt::format("body \"{}\" has no path to ground", b.model.bodies[i].name),
                        "connect it by a joint, for example one of type \"free\" from \"ground\"", {}});
  }
  return problems;
}

bool is_exactly_zero(const Quantity& q) { return q.expression < 0 && q.value == 0; }

void mark_massless(Builder& b) {
  for (TreeBody& body : b.topology.bodies) body.massless = true;
  for (std::size_t i = 0; i < b.model.bodies.size(); ++i) {
    const int tree = b.topology.tree_body[i];
    if (tree == kGround) continue;
    const Body& body = b.model.bodies[i];
    const bool zero = is_exactly_zero(body.mass) && std::all_of(body.inertia.begin(), body.inertia.end(), is_exactly_zero);
    if (!zero) b.topology.bodies[tree].massless = false;
  }
  for (const Rod& rod : b.model.rods)
    if (!is_exactly_zero(rod.mass))
      for (const Attachment& end : {rod.from, rod.to})
        if (const int tree = b.topology.tree_body[end.body]; tree != kGround) b.topology.bodies[tree].massless = false;
}

ClosureKind closure_kind(JointType type) {
  switch (type) {
    case JointType::revolute: return ClosureKind::revolute;
    case JointType::prismatic: return ClosureKind::prismatic;
    case JointType::cylindrical: return ClosureKind::cylindrical;
    case JointType::universal: return ClosureKind::universal;
    case JointType::planar: return ClosureKind::planar;
    case JointType::fixed: return ClosureKind::fixed;
    case JointType::spherical: case JointType::free: break;
  }
  return ClosureKind::spherical;
}

Loop make_loop(const Topology& topology, std::string name, ClosureKind kind, int equations, const Attachment& from, const Attachment& to) {
  Loop loop;
  loop.name = std::move(name);
  loop.kind = kind;
  loop.equations = equations;
  loop.body_from = topology.tree_body[from.body];
  loop.body_to = topology.tree_body[to.body];
  loop.ancestor = lowest_common_ancestor(topology, loop.body_from, loop.body_to);
  for (int end : {loop.body_from, loop.body_to})
    for (int j : path_to(topology, end, loop.ancestor)) loop.joints.push_back(j);
  std::sort(loop.joints.begin(), loop.joints.end());
  return loop;
}

Diagnostics find_loops(Builder& b) {
  Diagnostics problems;
  Topology& t = b.topology;
  for (std::size_t j = 0; j < b.model.joints.size(); ++j) {
    const Joint& joint = b.model.joints[j];
    if (b.clusters.fixed_in_tree[j] || b.choice.in_tree[j] || joint.type == JointType::free) continue;
    Loop loop = make_loop(t, joint.name, closure_kind(joint.type), closure_equations(joint.type), joint.from, joint.to);
    loop.joint = static_cast<int>(j);
    if (loop.joints.empty())
      problems.push_back({joint.where, fmt::format("joint \"{}\" closes a loop without moving joints: both bodies move as one", joint.name),
                          "remove the joint", {}});
    t.cut_reasons.push_back(b.choice.reasons[j]);
    t.loops.push_back(std::move(loop));
  }
  for (std::size_t r = 0; r < b.model.rods.size(); ++r) {
    const Rod& rod = b.model.rods[r];
    Loop loop = make_loop(t, rod.name, ClosureKind::rod, 1, rod.from, rod.to);
    loop.rod = static_cast<int>(r);
    if (loop.joints.empty())
      problems.push_back({rod.where, fmt::format("rod \"{}\" has both ends on bodies that move as one", rod.name), "remove the rod", {}});
    t.loops.push_back(std::move(loop));
  }
  return problems;
}

void find_blocks(Topology& t) {
  std::vector<int> block_of_joint(t.bodies.size(), -1), owner(t.loops.size());
  std::vector<std::vector<int>> members(t.loops.size());
  for (std::size_t l = 0; l < t.loops.size(); ++l) {
    owner[l] = static_cast<int>(l);
    members[l] = {static_cast<int>(l)};
    for (int j : t.loops[l].joints) {
      const int other = block_of_joint[j] < 0 ? -1 : owner[block_of_joint[j]];
      if (other >= 0 && other != owner[l]) {
        const int keep = std::min(other, owner[l]), gone = std::max(other, owner[l]);
        for (int m : members[gone]) owner[m] = keep, members[keep].push_back(m);
        members[gone].clear();
      }
      block_of_joint[j] = static_cast<int>(l);
    }
  }
  for (std::vector<int>& loops : members) {
    if (loops.empty()) continue;
    LoopBlock block;
    std::sort(loops.begin(), loops.end());
    block.loops = loops;
    block.base = t.loops[loops[0]].ancestor;
    for (int l : loops) {
      block.base = lowest_common_ancestor(t, block.base, t.loops[l].ancestor);
      block.equations += t.loops[l].equations;
      block.joints.insert(block.joints.end(), t.loops[l].joints.begin(), t.loops[l].joints.end());
    }
    std::sort(block.joints.begin(), block.joints.end());
    block.joints.erase(std::unique(block.joints.begin(), block.joints.end()), block.joints.end());
    t.blocks.push_back(std::move(block));
  }
}

void find_groups(Topology& t) {
  t.group_of.assign(t.bodies.size(), -1);
  std::vector<int> block_of(t.bodies.size(), -1);
  for (std::size_t b = 0; b < t.blocks.size(); ++b)
    for (int j : t.blocks[b].joints) block_of[j] = static_cast<int>(b);
  for (int i = 0; i < t.size(); ++i) {
    if (t.group_of[i] >= 0) continue;
    JointGroup group;
    group.block = block_of[i];
    group.joints = group.block < 0 ? std::vector<int>{i} : t.blocks[group.block].joints;
    group.base = group.block < 0 ? t.bodies[i].parent : t.blocks[group.block].base;
    group.parent = group.base == kGround ? -1 : t.group_of[group.base];
    for (int j : group.joints) t.group_of[j] = static_cast<int>(t.groups.size());
    t.groups.push_back(std::move(group));
  }
}

}  // namespace

Result<Topology> build_topology(const Model& model) {
  const Clusters clusters = merge_fixed(model);
  const Result<TreeChoice> choice = choose_tree(model, clusters);
  if (!choice) return choice.problems();
  Builder builder(model, clusters, *choice);
  place_joints(builder);
  if (Diagnostics problems = unreached(builder); !problems.empty()) return problems;
  Topology& topology = builder.topology;
  topology.children.resize(topology.bodies.size());
  for (int i = 0; i < topology.size(); ++i) {
    const int p = topology.bodies[i].parent;
    (p == kGround ? topology.roots : topology.children[p]).push_back(i);
  }
  for (std::size_t b = 0; b < model.bodies.size(); ++b) topology.tree_body.push_back(builder.tree_of_cluster[clusters.cluster[b]]);
  mark_massless(builder);
  Diagnostics problems = find_loops(builder);
  const std::vector<bool> used = joints_in_use(model);
  for (const Loop& loop : topology.loops)
    if (loop.joint >= 0 && used[loop.joint])
      problems.push_back({model.joints[loop.joint].where,
                          fmt::format("joint \"{}\" is cut, but its coordinate is driven, loaded or named elsewhere in the model",
                                      model.joints[loop.joint].name),
                          "mark another joint of its loop \"cut\": true", {}});
  if (!problems.empty()) return problems;
  find_blocks(topology);
  find_groups(topology);
  return std::move(builder.topology);
}

}  // namespace mbgen
