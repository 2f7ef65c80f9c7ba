#include "compiler/formulation/recursion/recursion_units.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "compiler/formulation/vector.hpp"

namespace mbgen {
namespace {

/// Whether the point of the next joint on a body equals the point of the body's own joint, for any parameters.
bool in_one_point(const Model& model, const Topology& topology, int body, int next) {
  const TreeBody &here = topology.bodies[body], &above = topology.bodies[next];
  if (here.joint == above.joint) return true;
  const Joint &own = model.joints[here.joint], &other = model.joints[above.joint];
  const Attachment &at = here.reversed ? own.from : own.to, &leaves = above.reversed ? other.to : other.from;
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    if (topology.tree_body[b] != body || (at.body == leaves.body && at.point == leaves.point)) continue;
    for (const Point& point : model.bodies[b].points)
      for (const Quantity& q : point.position)
        if (q.expression >= 0) return false;
  }
  const Vector3 first = reference_position(model, own.from), second = reference_position(model, other.from);
  double gap = 0, size = 1;
  for (int k = 0; k < 3; ++k) {
    gap = std::max(gap, std::abs(first[k] - second[k]));
    size = std::max(size, std::abs(first[k]));
  }
  return gap <= 1e-14 * size;
}

/// Per tree body: it does nothing but join two joints. It has no mass, and nothing but the next joint holds on to it.
std::vector<bool> mere_links(const Model& model, const Topology& topology) {
  std::vector<bool> link = loaded_bodies(model, topology);
  link.flip();
  for (int i = 0; i < topology.size(); ++i)
    if (!topology.bodies[i].massless || topology.children[i].size() != 1) link[i] = false;
  for (const Loop& loop : topology.loops)
    for (int end : {loop.body_from, loop.body_to})
      if (end != kGround) link[end] = false;
  return link;
}

/// Inputs of the choice of joints that are taken as one step.
struct StepRules {
  const Model& model;
  const Topology& topology;
  std::vector<bool> alone;  ///< per tree joint: a motion gives its rate, or a coupling asks for it
  std::vector<bool> link;   ///< see mere_links
};

std::vector<bool> joints_alone(const Model& model, const Topology& topology, std::vector<bool> driven) {
  for (const Coupling& coupling : model.couplings)
    for (const CoordinateReference& c : coupling.coordinates) driven[tree_coordinate(topology, c)] = true;
  return driven;
}

/// Whether three axes span the space with the joints at some angles: axes of successive turns are not parallel, those
/// of moves are perpendicular.
bool axes_span(const StepRules& rules, const std::vector<int>& joints) {
  const auto axis = [&](int c) { return constant<double>(rules.topology.bodies[joints[c]].axis); };
  constexpr double kNoise = 1e-15, kLeastAngle = 1e-3;
  if (rules.topology.bodies[joints[0]].kind == FreedomKind::revolute)
    return norm(cross(axis(0), axis(1))) > kLeastAngle && norm(cross(axis(1), axis(2))) > kLeastAngle;
  return std::abs(dot(axis(0), axis(1))) <= kNoise && std::abs(dot(axis(1), axis(2))) <= kNoise &&
         std::abs(dot(axis(2), axis(0))) <= kNoise;
}

/// The step that starts with a joint: three joints of one kind, one after the other over mere links, their axes through
/// one point when they turn; else the joint alone. joints: of the unit, ascending.
std::vector<int> joints_of_step(const StepRules& rules, const std::vector<int>& joints, int first) {
  std::vector<int> step{first};
  const Topology& topology = rules.topology;
  const FreedomKind kind = topology.bodies[first].kind;
  while (step.size() < 3 && !rules.alone[step.back()]) {
    const int last = step.back();
    if (!rules.link[last]) break;
    const int next = topology.children[last].front();
    if (topology.bodies[next].kind != kind || !std::binary_search(joints.begin(), joints.end(), next)) break;
    if (kind == FreedomKind::revolute && !in_one_point(rules.model, topology, last, next)) break;
    step.push_back(next);
  }
  if (step.size() < 3 || rules.alone[step.back()] || !axes_span(rules, step)) step.resize(1);
  return step;
}

/// In a block prismatic triples gain nothing: their axes are those of the frame already.
std::vector<JointStep> steps_of(const StepRules& rules, const std::vector<int>& joints, bool in_block) {
  const bool quasi = !in_block || joints.size() <= kLargestQuasiBlock;
  std::vector<JointStep> steps;
  std::set<int> taken;
  for (int joint : joints) {
    if (taken.contains(joint)) continue;
    const bool revolute = rules.topology.bodies[joint].kind == FreedomKind::revolute;
    const bool alone = !quasi || (in_block && !revolute);
    steps.push_back({alone ? std::vector<int>{joint} : joints_of_step(rules, joints, joint), revolute});
    taken.insert(steps.back().joints.begin(), steps.back().joints.end());
  }
  std::sort(steps.begin(), steps.end(), [](const JointStep& a, const JointStep& b) { return a.body() < b.body(); });
  return steps;
}

}  // namespace

Recursion plan_recursion(const Model& model, const Topology& topology, const std::vector<bool>& driven,
                         RecursionChoices choices) {
  Recursion recursion{choices, choose_layout(model, topology, choices.rotors ? Frames::own : Frames::all), {}, {}};
  const StepRules rules{model, topology, joints_alone(model, topology, driven), mere_links(model, topology)};
  for (const JointGroup& group : topology.groups) {
    RecursionUnit unit;
    const int last = group.joints.back();
    unit.block = group.block;
    unit.opened = group.block >= 0 && topology.blocks[group.block].opened;
    unit.base = group.base;
    unit.joints = group.joints;
    unit.rotor = group.block < 0 && recursion.layout.bodies[last].rotor;
    if (group.block < 0 && !unit.rotor) {
      const int start = recursion.layout.bodies[last].chain_start;
      if (start < 0) continue;  // inside a run: taken with its end
      unit.joints.clear();
      for (int j = last;; j = topology.bodies[j].parent) {
        unit.joints.insert(unit.joints.begin(), j);
        if (j == start) break;
      }
      unit.base = topology.bodies[start].parent;
    }
    unit.steps = steps_of(rules, unit.joints, group.block >= 0);
    recursion.units.push_back(std::move(unit));
  }
  recursion.on_body.resize(topology.bodies.size());
  for (std::size_t u = 0; u < recursion.units.size(); ++u)
    if (const int base = recursion.units[u].base; base != kGround)
      recursion.on_body[base].push_back(static_cast<int>(u));
  return recursion;
}

bool is_free(const RecursionUnit& unit) {
  return unit.block < 0 && unit.steps.size() == 2 && unit.steps[0].quasi() && unit.steps[1].quasi() &&
         unit.steps[0].revolute != unit.steps[1].revolute;
}

}  // namespace mbgen
