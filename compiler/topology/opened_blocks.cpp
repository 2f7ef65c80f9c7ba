#include "compiler/topology/opened_blocks.hpp"

#include <algorithm>

#include "compiler/model/vectors.hpp"

namespace mbgen {
namespace {

/// Blocks of more joints have one partition, over joint rates.
constexpr std::size_t kLargestClosedBlock = 40;
constexpr double kRounding = 1e-12;

/// Inertia of a model body along a joint: kg, or kg m^2. axis, pin: of the joint at the reference.
double inertia_along(const Body& body, FreedomKind kind, const Vector3& axis, const Vector3& pin) {
  const double mass = body.mass.value;
  if (kind == FreedomKind::prismatic) return mass;
  Vector3 arm = to_global(body.pose, {body.com[0].value, body.com[1].value, body.com[2].value});
  for (std::size_t k = 0; k < 3; ++k) arm[k] -= pin[k];
  const Vector3 across = cross(axis, arm), a = to_body_axes(body.pose, axis);
  const auto& j = body.inertia;
  return mass * dot(across, across) + j[0].value * a[0] * a[0] + j[1].value * a[1] * a[1] + j[2].value * a[2] * a[2] +
         2 * (j[3].value * a[0] * a[1] + j[4].value * a[0] * a[2] + j[5].value * a[1] * a[2]);
}

/// Per tree body: its inertia along its own joint, of its model bodies alone.
std::vector<double> own_inertias(const Model& model, const Topology& topology) {
  std::vector<double> inertias(topology.bodies.size(), 0.0);
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    const int i = topology.tree_body[b];
    if (i == kGround) continue;
    const TreeBody& moved = topology.bodies[i];
    inertias[i] += inertia_along(model.bodies[b], moved.kind, moved.axis,
                                 reference_position(model, model.joints[moved.joint].from));
  }
  return inertias;
}

bool has_rod_with_mass(const Model& model, const Topology& topology, const LoopBlock& block) {
  return std::any_of(block.loops.begin(), block.loops.end(), [&](int l) {
    const int rod = topology.loops[l].rod;
    return rod >= 0 && (model.rods[rod].mass.value != 0 || model.rods[rod].mass.expression >= 0);
  });
}

/// Whether the mass matrix of the tree has full rank in the block, whatever the position: articulated inertias are at
/// least those of the bodies themselves.
bool has_inertia(const Topology& topology, const std::vector<double>& inertias, const LoopBlock& block) {
  double largest = 0;
  for (const int i : block.joints) largest = std::max(largest, inertias[i]);
  return std::all_of(block.joints.begin(), block.joints.end(),
                     [&](int i) { return !topology.bodies[i].massless && inertias[i] > kRounding * largest; });
}

}  // namespace

void mark_opened(const Model& model, Topology& topology) {
  const std::vector<double> inertias = own_inertias(model, topology);
  for (LoopBlock& block : topology.blocks)
    block.opened = block.joints.size() > kLargestClosedBlock && least_freedoms(block) > block.equations &&
                   !has_rod_with_mass(model, topology, block) && has_inertia(topology, inertias, block);
}

}  // namespace mbgen
