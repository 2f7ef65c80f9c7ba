#include "compiler/formulation/layout.hpp"

#include <cmath>

namespace mbgen {
namespace {

bool in_block(const Topology& topology, int body) { return topology.groups[topology.group_of[body]].block >= 0; }

bool branches(const Topology& topology, int body) { return topology.children[body].size() != 1; }

std::vector<bool> block_bases(const Topology& topology) {
  std::vector<bool> base(topology.size(), false);
  for (const LoopBlock& block : topology.blocks)
    if (block.base != kGround) base[block.base] = true;
  return base;
}

/// Start of the run of massless joints that ends at an own body, all outside loop blocks.
int find_chain_start(const Topology& topology, const std::vector<bool>& carries, int end) {
  int start = end;
  for (int p = topology.bodies[start].parent; p != kGround; p = topology.bodies[start].parent) {
    if (carries[p] || in_block(topology, p)) break;
    start = p;
  }
  return start;
}

/// Per tree body, how many bodies of the model move with it as one, rods' ends counted as well.
std::vector<int> parts_of_bodies(const Model& model, const Topology& topology) {
  std::vector<int> parts(topology.size(), 0);
  const auto count = [&](int tree_body) {
    if (tree_body != kGround) ++parts[tree_body];
  };
  for (int tree_body : topology.tree_body) count(tree_body);
  for (const Rod& rod : model.rods)
    for (const Attachment& end : {rod.from, rod.to}) count(topology.tree_body[end.body]);
  return parts;
}

/// Inertia of the merged constant bodies is symmetric about the joint axis through the joint point. parts: of the body,
/// rods' ends counted as well.
bool is_rotor(const Model& model, const Topology& topology, int body, int parts) {
  const TreeBody& tree = topology.bodies[body];
  if (tree.kind != FreedomKind::revolute || !topology.children[body].empty() || tree.massless) return false;
  if (parts != 1 || tree.model_body < 0) return false;
  const Body& part = model.bodies[tree.model_body];
  const Joint& joint = model.joints[tree.joint];
  const Attachment& at = tree.reversed ? joint.from : joint.to;
  const Point& pin = part.points[at.point];
  for (const Quantity& q : part.inertia)
    if (q.expression >= 0) return false;
  Vector3 axis{};  // in body axes
  for (int k = 0; k < 3; ++k)
    for (int row = 0; row < 3; ++row) axis[k] += part.pose.rotation[3 * row + k] * tree.axis[row];
  Vector3 offset{};
  for (int k = 0; k < 3; ++k) {
    if (part.com[k].expression >= 0 || pin.position[k].expression >= 0) return false;
    offset[k] = part.com[k].value - pin.position[k].value;
  }
  const double along = offset[0] * axis[0] + offset[1] * axis[1] + offset[2] * axis[2];
  for (int k = 0; k < 3; ++k)
    if (std::abs(offset[k] - along * axis[k]) > 1e-12) return false;
  const double j[3][3] = {{part.inertia[0].value, part.inertia[3].value, part.inertia[4].value},
                          {part.inertia[3].value, part.inertia[1].value, part.inertia[5].value},
                          {part.inertia[4].value, part.inertia[5].value, part.inertia[2].value}};
  double polar = 0;
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 3; ++c) polar += axis[r] * j[r][c] * axis[c];
  const double trace = j[0][0] + j[1][1] + j[2][2], across = (trace - polar) / 2;
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 3; ++c) {
      const double expected = polar * axis[r] * axis[c] + across * ((r == c) - axis[r] * axis[c]);
      if (std::abs(j[r][c] - expected) > 1e-12 * trace) return false;
    }
  return true;
}

}  // namespace

std::vector<bool> loaded_bodies(const Model& model, const Topology& topology) {
  std::vector<bool> loaded(topology.size(), false);
  const auto load = [&](const Attachment& at) {
    if (const int body = topology.tree_body[at.body]; body != kGround) loaded[body] = true;
  };
  for (const Rod& rod : model.rods) load(rod.from), load(rod.to);
  each_element(model, [&](const auto& element) { each_attachment(connection_of(element), load); });
  return loaded;
}

Layout choose_layout(const Model& model, const Topology& topology, Frames frames) {
  const int n = topology.size();
  const std::vector<bool> loaded = loaded_bodies(model, topology);
  const std::vector<int> parts = parts_of_bodies(model, topology);
  std::vector<bool> own = block_bases(topology), carries(n), above_carrier(n);
  for (int i = 0; i < n; ++i) {
    const int p = topology.bodies[i].parent;
    carries[i] = own[i] || loaded[i] || !topology.bodies[i].massless || branches(topology, i);
    above_carrier[i] = p != kGround && (above_carrier[p] || carries[p] || in_block(topology, p));
    const bool first = !above_carrier[i];
    if (in_block(topology, i)) continue;
    const bool leaf = topology.children[i].empty();
    if (frames == Frames::few && carries[i] && (first || !leaf)) own[i] = true;
    if (frames == Frames::all) own[i] = carries[i] || leaf;
    if (frames == Frames::own && (carries[i] || leaf)) {
      const bool is_carried = p != kGround && (in_block(topology, p) || carries[p]);
      own[i] = !(is_carried && is_rotor(model, topology, i, parts[i]));
    }
  }
  Layout layout;
  layout.bodies.resize(n);
  for (int i = 0; i < n; ++i) {
    BodyLayout& body = layout.bodies[i];
    body.own_frame = own[i];
    const int p = topology.bodies[i].parent;
    if (in_block(topology, i))
      body.base = topology.groups[topology.group_of[i]].base;
    else
      body.base = p == kGround ? kGround : own[p] ? p : layout.bodies[p].base;
    body.joint_frame = body.base;
    body.rotor = !own[i] && is_rotor(model, topology, i, parts[i]);
  }
  for (int i = 0; i < n; ++i) {
    if (!own[i] || in_block(topology, i)) continue;
    layout.bodies[i].chain_start = find_chain_start(topology, carries, i);
    for (int j = i;; j = topology.bodies[j].parent) {
      layout.bodies[j].joint_frame = i;
      if (j == layout.bodies[i].chain_start) break;
    }
  }
  return layout;
}

}  // namespace mbgen
