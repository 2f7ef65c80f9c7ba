#include "compiler/analysis/misalignment.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace mbgen {
namespace {

constexpr double kParallel = 1e-12;  // rad; typed directions that are meant to agree agree to rounding

struct Axis {
  int joint = -1;
  FreedomKind kind = FreedomKind::revolute;
  Vector3 direction{};
};

/// The joints of the loops, in the tree or cut.
std::set<int> joints_of(const Topology& topology, const std::vector<int>& loops) {
  std::set<int> joints;
  for (int l : loops) {
    if (topology.loops[l].joint >= 0) joints.insert(topology.loops[l].joint);
    for (int i : topology.loops[l].joints) joints.insert(topology.bodies[i].joint);
  }
  return joints;
}

/// Pins and slides: joints of one freedom.
std::vector<Axis> axes_of(const Model& model, const std::set<int>& joints) {
  std::vector<Axis> axes;
  for (int j : joints) {
    const Joint& joint = model.joints[j];
    if (joint.freedoms.size() == 1) axes.push_back({j, joint.freedoms[0].kind, joint.freedoms[0].axis});
  }
  return axes;
}

/// Angle by which an axis misses a shared pin direction: a pin lies along it, a slide across it. rad
double miss(const Axis& axis, const Vector3& shared) {
  const Vector3& a = axis.direction;
  const double along = std::abs(a[0] * shared[0] + a[1] * shared[1] + a[2] * shared[2]);
  if (axis.kind == FreedomKind::prismatic) return std::asin(std::min(along, 1.0));
  const double across = std::hypot(a[1] * shared[2] - a[2] * shared[1], a[2] * shared[0] - a[0] * shared[2],
                                   a[0] * shared[1] - a[1] * shared[0]);
  return std::atan2(across, along);
}

}  // namespace

std::optional<Misalignment> misaligned_joint(const Model& model, const Topology& topology,
                                             const std::vector<int>& loops) {
  // Gears turn about axes of any directions.
  const auto is_coupling = [&](int l) { return topology.loops[l].kind == ClosureKind::coupling; };
  if (std::ranges::any_of(loops, is_coupling)) return std::nullopt;
  const std::set<int> joints = joints_of(topology, loops);
  const std::vector<Axis> axes = axes_of(model, joints);
  for (const Axis& candidate : axes) {
    if (candidate.kind != FreedomKind::revolute) continue;
    std::vector<const Axis*> off;
    int pins = 0;
    for (const Axis& axis : axes) {
      if (miss(axis, candidate.direction) > kParallel)
        off.push_back(&axis);
      else if (axis.kind == FreedomKind::revolute)
        ++pins;
    }
    if (pins >= 2 && off.size() == 1)
      return Misalignment{off[0]->joint, off[0]->kind, miss(*off[0], candidate.direction),
                          axes.size() == joints.size()};
  }
  return std::nullopt;
}

}  // namespace mbgen
