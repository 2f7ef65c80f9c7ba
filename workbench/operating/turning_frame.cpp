#include "workbench/operating/turning_frame.hpp"

#include <algorithm>
#include <cmath>

#include "compiler/model/vectors.hpp"

namespace mbgen {
namespace {

constexpr double kAlong = 1e-9;  // tolerance of directions

/// Whether gravity and roads are invariant under rotation about an axis.
bool is_upright(const Model& model, const Vector3& axis) {
  const auto is_along = [&](const Vector3& up) {
    return std::abs(dot(axis, up)) >= (1 - kAlong) * norm(up);
  };
  const Vector3 gravity{model.gravity[0].value, model.gravity[1].value, model.gravity[2].value};
  return is_along(gravity) && (model.tyres.empty() || is_along({0, 0, 1}));
}

/// Translations across the axis of a rotating coordinate; none if anything else carries it.
std::vector<int> translations_across(const Topology& topology, int turning) {
  std::vector<int> across;
  const Vector3& axis = topology.bodies[static_cast<std::size_t>(turning)].axis;
  for (int p = topology.bodies[static_cast<std::size_t>(turning)].parent; p != kGround;
       p = topology.bodies[static_cast<std::size_t>(p)].parent) {
    const TreeBody& carrier = topology.bodies[static_cast<std::size_t>(p)];
    if (carrier.kind != FreedomKind::prismatic) return {};
    if (std::abs(dot(carrier.axis, axis)) < kAlong) across.push_back(p);
  }
  return across;
}

}  // namespace

std::vector<TurningFrame> turning_frames(const Model& model, const Topology& topology,
                                         const std::vector<int>& independent) {
  std::vector<TurningFrame> frames;
  const auto is_free = [&](int i) { return std::ranges::find(independent, i) != independent.end(); };
  const auto axis_of = [&](int i) -> const Vector3& { return topology.bodies[static_cast<std::size_t>(i)].axis; };
  for (const int i : independent) {
    if (topology.bodies[static_cast<std::size_t>(i)].kind != FreedomKind::revolute) continue;
    const std::vector<int> across = translations_across(topology, i);
    if (across.size() != 2 || !std::ranges::all_of(across, is_free) || !is_upright(model, axis_of(i))) continue;
    const bool in_order = dot(axis_of(i), cross(axis_of(across[0]), axis_of(across[1]))) > 0;
    frames.push_back({i, {across[in_order ? 0 : 1], across[in_order ? 1 : 0]}});
  }
  return frames;
}

}  // namespace mbgen
