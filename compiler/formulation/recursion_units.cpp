#include "compiler/formulation/recursion_units.hpp"

#include <algorithm>

namespace mbgen {
namespace {

/// Three joints of one kind that belong to one joint of the model, one after the other over bodies without mass.
bool is_triple(const Topology& topology, const std::vector<int>& joints, std::size_t first,
               const std::vector<bool>& driven) {
  if (first + 3 > joints.size()) return false;
  const TreeBody& start = topology.bodies[joints[first]];
  for (std::size_t k = first; k < first + 3; ++k) {
    const TreeBody& body = topology.bodies[joints[k]];
    if (driven[joints[k]] || body.joint != start.joint || body.kind != start.kind) return false;
    if (k > first && body.parent != joints[k - 1]) return false;
    if (k < first + 2 && (!body.massless || body.model_body >= 0 || topology.children[joints[k]].size() != 1))
      return false;
  }
  return true;
}

/// In a block prismatic triples gain nothing: their axes are those of the frame already.
std::vector<JointStep> steps_of(const Topology& topology, const std::vector<int>& joints,
                                const std::vector<bool>& driven, bool in_block) {
  const bool quasi = !in_block || joints.size() <= kLargestQuasiBlock;
  std::vector<JointStep> steps;
  for (std::size_t c = 0; c < joints.size();) {
    const bool revolute = topology.bodies[joints[c]].kind == FreedomKind::revolute;
    const std::size_t count = quasi && (revolute || !in_block) && is_triple(topology, joints, c, driven) ? 3 : 1;
    steps.push_back({{joints.begin() + c, joints.begin() + c + count}, revolute});
    c += count;
  }
  return steps;
}

}  // namespace

Recursion plan_recursion(const Model& model, const Topology& topology, const std::vector<bool>& driven,
                         RecursionChoices choices) {
  Recursion recursion{choices, choose_layout(model, topology, choices.rotors ? Frames::own : Frames::all), {}};
  for (const JointGroup& group : topology.groups) {
    RecursionUnit unit;
    const int last = group.joints.back();
    unit.block = group.block;
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
    unit.steps = steps_of(topology, unit.joints, driven, group.block >= 0);
    recursion.units.push_back(std::move(unit));
  }
  return recursion;
}

bool is_free(const RecursionUnit& unit) {
  return unit.block < 0 && unit.steps.size() == 2 && unit.steps[0].quasi() && unit.steps[1].quasi() &&
         unit.steps[0].revolute != unit.steps[1].revolute;
}

}  // namespace mbgen
