#include "compiler/topology/graph.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <queue>

namespace mbgen {
namespace {

/// Disjoint sets of clusters.
struct Sets {
  std::vector<int> parent;
  explicit Sets(int n) : parent(n) { std::iota(parent.begin(), parent.end(), 0); }
  int find(int a) {
    while (parent[a] != a) a = parent[a] = parent[parent[a]];
    return a;
  }
  bool join(int a, int b) {
    a = find(a);
    b = find(b);
    if (a == b) return false;
    parent[std::max(a, b)] = std::min(a, b);
    return true;
  }
};

struct Edge {
  int joint, from, to;
};

/// Joints on the tree path between two clusters, empty when there is none.
std::vector<int> tree_path(const std::vector<Edge>& edges, const std::vector<bool>& in_tree, int clusters, int a, int b) {
  std::vector<int> by(clusters, -1), previous(clusters, -1);
  std::queue<int> open;
  open.push(a);
  previous[a] = a;
  while (!open.empty()) {
    const int here = open.front();
    open.pop();
    for (const Edge& e : edges) {
      if (!in_tree[e.joint] || (e.from != here && e.to != here)) continue;
      const int next = e.from == here ? e.to : e.from;
      if (previous[next] >= 0) continue;
      previous[next] = here;
      by[next] = e.joint;
      open.push(next);
    }
  }
  std::vector<int> path;
  if (previous[b] < 0) return path;
  for (int c = b; c != a; c = previous[c]) path.push_back(by[c]);
  return path;
}

/// Joints that must not be cut come first, then those whose cut costs most.
int keeping_value(const Model& model, const std::vector<bool>& used, int joint) {
  const Joint& j = model.joints[joint];
  if (j.cut == CutMark::tree) return 1000;
  return closure_equations(j.type) + (used[joint] ? 100 : 0);
}

/// Swaps cuts with tree joints of equal value while the loops get shorter.
void shorten_loops(const Model& model, const std::vector<Edge>& edges, int clusters, const std::vector<bool>& used,
                   std::vector<bool>& in_tree) {
  const auto total = [&](const std::vector<bool>& tree) {
    std::size_t sum = 0;
    for (const Edge& e : edges)
      if (!tree[e.joint]) sum += tree_path(edges, tree, clusters, e.from, e.to).size();
    return sum;
  };
  std::size_t best = total(in_tree);
  for (bool improved = true; improved;) {
    improved = false;
    for (const Edge& e : edges) {
      if (in_tree[e.joint] || model.joints[e.joint].cut == CutMark::cut) continue;
      for (int other : tree_path(edges, in_tree, clusters, e.from, e.to)) {
        if (model.joints[other].cut == CutMark::tree || keeping_value(model, used, other) != keeping_value(model, used, e.joint)) continue;
        std::vector<bool> trial = in_tree;
        trial[other] = false;
        trial[e.joint] = true;
        if (const std::size_t length = total(trial); length < best) {
          best = length;
          in_tree = trial;
          improved = true;
          break;
        }
      }
    }
  }
}

}  // namespace

int closure_equations(JointType type) {
  switch (type) {
    case JointType::revolute: case JointType::prismatic: return 5;
    case JointType::cylindrical: case JointType::universal: return 4;
    case JointType::spherical: case JointType::planar: return 3;
    case JointType::fixed: return 6;
    case JointType::free: return 0;
  }
  return 0;
}

std::vector<bool> joints_in_use(const Model& model) {
  std::vector<bool> used(model.joints.size(), false);
  const auto use = [&](const CoordinateReference& c) {
    if (c.joint >= 0) used[c.joint] = true;
  };
  for (const Expression& expression : model.expressions)
    for (const ExpressionNode& node : expression.nodes)
      if (node.kind == ExpressionNode::Kind::position || node.kind == ExpressionNode::Kind::velocity) use(node.coordinate);
  for (const JointSpring& spring : model.joint_springs) {
    use(spring.joint);
    if (spring.relative_to) use(*spring.relative_to);
  }
  for (const JointFriction& friction : model.frictions) use(friction.joint);
  for (const JointForce& force : model.joint_forces) use(force.joint);
  for (const Motion& motion : model.motions) use(motion.joint);
  for (const Output& output : model.outputs)
    if (const auto* c = std::get_if<CoordinateOutput>(&output.source)) use(c->coordinate);
  for (const InitialValue& value : model.initial.positions) use(value.coordinate);
  for (const InitialValue& value : model.initial.velocities) use(value.coordinate);
  return used;
}

Clusters merge_fixed(const Model& model) {
  const int n = static_cast<int>(model.bodies.size());
  Sets sets(n + 1);   // n stands for ground when no body is named so
  Clusters clusters;
  clusters.fixed_in_tree.assign(model.joints.size(), false);
  for (std::size_t j = 0; j < model.joints.size(); ++j) {
    const Joint& joint = model.joints[j];
    if (joint.type == JointType::fixed && joint.cut != CutMark::cut)
      clusters.fixed_in_tree[j] = sets.join(joint.from.body, joint.to.body);
  }
  std::vector<int> number(n + 1, -1);
  for (int b = 0; b <= n; ++b) {
    int& mine = number[sets.find(b)];
    if (mine < 0) mine = clusters.count++;
    if (b < n) clusters.cluster.push_back(mine);
    if (b == (model.ground >= 0 ? model.ground : n)) clusters.ground = mine;
  }
  return clusters;
}

Result<TreeChoice> choose_tree(const Model& model, const Clusters& clusters) {
  TreeChoice choice;
  choice.in_tree.assign(model.joints.size(), false);
  choice.reasons.assign(model.joints.size(), "");
  const std::vector<bool> used = joints_in_use(model);
  std::vector<Edge> edges;
  for (std::size_t j = 0; j < model.joints.size(); ++j)
    if (!clusters.fixed_in_tree[j])
      edges.push_back({static_cast<int>(j), clusters.cluster[model.joints[j].from.body], clusters.cluster[model.joints[j].to.body]});
  std::vector<Edge> ranked = edges;
  std::stable_sort(ranked.begin(), ranked.end(), [&](const Edge& a, const Edge& b) {
    return keeping_value(model, used, a.joint) > keeping_value(model, used, b.joint);
  });
  Sets sets(clusters.count);
  Diagnostics problems;
  for (const Edge& e : ranked) {
    const Joint& joint = model.joints[e.joint];
    if (joint.cut == CutMark::cut) continue;
    choice.in_tree[e.joint] = sets.join(e.from, e.to);
    if (!choice.in_tree[e.joint] && joint.cut == CutMark::tree)
      problems.push_back({joint.where,
                          fmt::format("body \"{}\" has two tree parents: joint \"{}\" closes a loop of joints marked \"cut\": false",
                                      model.bodies[joint.to.body].name, joint.name),
                          "mark one joint of the loop \"cut\": true, or leave the choice to mbgen", {}});
  }
  if (!problems.empty()) return problems;
  shorten_loops(model, edges, clusters.count, used, choice.in_tree);
  for (const Edge& e : edges)
    if (!choice.in_tree[e.joint])
      choice.reasons[e.joint] = model.joints[e.joint].cut == CutMark::cut ? "marked" : "fewest equations, then shortest loops";
  return choice;
}

}  // namespace mbgen
