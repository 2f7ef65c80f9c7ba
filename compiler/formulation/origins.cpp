#include "compiler/formulation/origins.hpp"

#include <algorithm>
#include <cmath>

#include "compiler/formulation/layout.hpp"

namespace mbgen {
namespace {

/// Numbers of a body along the axis of its joint.
struct AlongAxis {
  double own = 0;               ///< of the joint's point
  double mass = 0, moment = 0;  ///< of all parts and of rotors on it, rods as two point masses at their ends
  std::vector<double> points;   ///< of elements and cut joints that hold on to the body
  std::vector<double> joints;   ///< of the bodies on it
  bool turns_alone = false;     ///< in a loop block or an arm, and no other unit moves on it: its inertia is constant
  double below = 0;             ///< origin of the body below
  bool has_below = false;
};

/// Every attachment of a rod, force element or cut joint, those between two bodies first: of equal origins the first
/// counts.
template <class Use>
void for_attachments(const Model& model, const Topology& topology, const Use& use) {
  for (const Rod& rod : model.rods) use(rod.from), use(rod.to);
  for (const bool on_one : {false, true})
    each_element(model, [&](const auto& element) {
      const Connection connection = connection_of(element);
      if (std::holds_alternative<OnBody>(connection) == on_one) each_attachment(connection, use);
    });
  for (const Loop& loop : topology.loops)
    if (loop.joint >= 0) use(model.joints[loop.joint].from), use(model.joints[loop.joint].to);
}

/// The coordinate axis that a vector lies along, or -1.
int coordinate_axis(const Vector3& axis) {
  for (int k = 0; k < 3; ++k)
    if (std::abs(axis[k]) == 1.0) return k;
  return -1;
}

/// Rotors have their centre of mass on the axis as it is.
bool may_slide(const Topology& topology, const Layout& layout, int body) {
  const TreeBody& tree = topology.bodies[body];
  if (layout.bodies[body].rotor) return false;
  if (tree.kind != FreedomKind::revolute || tree.massless || coordinate_axis(tree.axis) < 0) return false;
  return tree.parent == kGround || !topology.bodies[tree.parent].massless;
}

Vector3 joint_point(const Model& model, const TreeBody& body) {
  return reference_position(model, model.joints[body.joint].from);
}

Vector3 centre_of_mass(const Body& body) {
  Vector3 at = body.pose.origin;
  for (int row = 0; row < 3; ++row)
    for (int k = 0; k < 3; ++k) at[row] += body.pose.rotation[3 * row + k] * body.com[k].value;
  return at;
}

/// Constants of each body along its axis; empty points of bodies that do not slide.
std::vector<AlongAxis> numbers_along_axes(const Model& model, const Topology& topology, const Layout& layout) {
  std::vector<AlongAxis> numbers(topology.bodies.size());
  const auto component = [&](int body) {
    return may_slide(topology, layout, body) ? coordinate_axis(topology.bodies[body].axis) : -1;
  };
  const auto add_mass = [&](int body, double mass, const Vector3& at) {
    if (body == kGround || component(body) < 0) return;
    numbers[body].mass += mass;
    numbers[body].moment += mass * at[component(body)];
  };
  const auto add_point = [&](int body, const Vector3& at) {
    if (body != kGround && component(body) >= 0) numbers[body].points.push_back(at[component(body)]);
  };
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    const int body = topology.tree_body[b];
    const Vector3 at = centre_of_mass(model.bodies[b]);
    add_mass(body, model.bodies[b].mass.value, at);
    if (body != kGround && layout.bodies[body].rotor)
      add_mass(topology.bodies[body].parent, model.bodies[b].mass.value, at);
  }
  for (const Rod& rod : model.rods)
    for (const Attachment& end : {rod.from, rod.to})
      add_mass(topology.tree_body[end.body], rod.mass.value / 2, reference_position(model, end));
  for_attachments(model, topology,
                  [&](const Attachment& at) { add_point(topology.tree_body[at.body], reference_position(model, at)); });
  for (int i = 0; i < topology.size(); ++i) {
    const Vector3 point = joint_point(model, topology.bodies[i]);
    const int p = topology.bodies[i].parent;
    if (p != kGround && component(p) >= 0) numbers[p].joints.push_back(point[component(p)]);
    if (component(i) < 0) continue;
    const int group = topology.group_of[i];
    const auto& children = topology.children[i];
    numbers[i].own = point[component(i)];
    const bool in_block = topology.groups[group].block >= 0;
    numbers[i].turns_alone = (in_block || p != kGround) && std::all_of(children.begin(), children.end(), [&](int c) {
                               return (in_block && topology.group_of[c] == group) || layout.bodies[c].rotor;
                             });
  }
  return numbers;
}

/// Weight of the numbers that an origin at a place leaves: the first moment and two second moments, the step from the
/// body below, places on the body. A constant inertia that is turned is worth most in a block and of an arm; elsewhere
/// it is added to a full one, and the steps by which full ones are shifted count.
int cost_of(const AlongAxis& n, double place) {
  const int of_mass = n.turns_alone ? 6 : 2, of_step = n.turns_alone ? 2 : 6;
  const auto differs = [&](double other) { return std::abs(other - place) > 1e-14 * std::max(1.0, std::abs(place)); };
  int cost = n.mass > 0 && differs(n.moment / n.mass) ? of_mass : 0;
  if (n.has_below && differs(n.below)) cost += of_step;
  for (double point : n.joints) cost += differs(point) ? of_step : 0;
  for (double point : n.points) cost += differs(point) ? 1 : 0;
  return cost;
}

}  // namespace

std::vector<SlidOrigin> slid_origins(const Model& model, const Topology& topology) {
  const Layout layout = choose_layout(model, topology, Frames::own);
  std::vector<AlongAxis> numbers = numbers_along_axes(model, topology, layout);
  std::vector<SlidOrigin> slid(topology.bodies.size());
  for (int i = 0; i < topology.size(); ++i) {
    if (!may_slide(topology, layout, i)) continue;
    const int k = coordinate_axis(topology.bodies[i].axis), p = topology.bodies[i].parent;
    AlongAxis& n = numbers[i];
    if (p != kGround) {
      n.has_below = true;
      n.below = slid[p].component == k ? slid[p].value : joint_point(model, topology.bodies[p])[k];
    }
    double best = n.own;
    std::vector<double> places = n.points;
    places.insert(places.end(), n.joints.begin(), n.joints.end());
    places.push_back(n.below);
    if (n.mass > 0) places.insert(places.begin(), n.moment / n.mass);
    for (double place : places)
      if (cost_of(n, place) < cost_of(n, best)) best = place;
    if (best != n.own) slid[i] = {k, best};
  }
  return slid;
}

}  // namespace mbgen
