// Ball joints with changeable charts.

#include <algorithm>
#include <cmath>

#include "compiler/topology/coordinate_uses.hpp"
#include "compiler/topology/poles.hpp"
#include "compiler/topology/topology.hpp"

namespace mbgen {
namespace {

double triple_product(const Vector3& a, const Vector3& b, const Vector3& c) {
  return c[0] * (a[1] * b[2] - a[2] * b[1]) + c[1] * (a[2] * b[0] - a[0] * b[2]) + c[2] * (a[0] * b[1] - a[1] * b[0]);
}

/// The three rotations of a tree joint from `first` on; empty for another number of rotations.
std::vector<int> turns_from(const Topology& topology, int first) {
  std::vector<int> turns;
  for (int i = first; i < topology.size() && topology.bodies[i].joint == topology.bodies[first].joint; ++i)
    if (topology.bodies[i].kind == FreedomKind::revolute) turns.push_back(i);
  return turns;
}

}  // namespace

std::vector<Ball> find_balls(const Model& model, const Topology& topology) {
  std::vector<Ball> balls;
  if (!std::all_of(topology.blocks.begin(), topology.blocks.end(), [](const auto& b) { return chooses_again(b); }))
    return balls;
  const std::vector<CoordinateUse> laws = coordinates_of_laws(model);
  const auto in_a_law = [&](int joint) {
    const TreeBody& body = topology.bodies[joint];
    return std::any_of(laws.begin(), laws.end(), [&](const CoordinateUse& use) {
      return use.coordinate.joint == body.joint && use.coordinate.component == body.component;
    });
  };
  for (int i = 0; i < topology.size(); ++i) {
    const TreeBody& body = topology.bodies[i];
    const bool is_first = body.kind == FreedomKind::revolute && (i == 0 || topology.bodies[i - 1].joint != body.joint ||
                                                                 topology.bodies[i - 1].kind != FreedomKind::revolute);
    if (!is_first || !is_ball(model.joints[body.joint].type)) continue;
    const std::vector<int> turns = turns_from(topology, i);
    if (turns.size() != 3 || std::any_of(turns.begin(), turns.end(), in_a_law)) continue;
    const double hand = triple_product(body.axis, topology.bodies[turns[1]].axis, topology.bodies[turns[2]].axis);
    balls.push_back({{turns[0], turns[1], turns[2]}, hand > 0 ? 1 : -1});
  }
  return balls;
}

std::vector<RealPole> real_poles(const Model& model, const Topology& topology) {
  std::vector<RealPole> poles;
  for (const CoordinateUse& use : coordinates_of_laws(model)) {
    const int i = tree_coordinate(topology, use.coordinate);
    if (i < 0 || topology.bodies[i].kind != FreedomKind::revolute) continue;
    const int joint = use.coordinate.joint;
    const bool is_named =
        std::any_of(poles.begin(), poles.end(), [joint](const RealPole& pole) { return pole.joint == joint; });
    if (is_ball(model.joints[joint].type) && !is_named)
      poles.push_back({joint, topology.bodies[i].coordinate, use.user});
  }
  return poles;
}

int ball_from(const Topology& topology, int joint) {
  for (std::size_t b = 0; b < topology.balls.size(); ++b)
    if (topology.balls[b].coordinate[0] == joint) return static_cast<int>(b);
  return -1;
}

}  // namespace mbgen
