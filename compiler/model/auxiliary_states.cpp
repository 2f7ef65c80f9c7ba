#include "compiler/model/auxiliary_states.hpp"

namespace mbgen {
namespace {

const char* unit_of_coordinate(const Model& model, const CoordinateReference& coordinate) {
  const Joint& joint = model.joints[static_cast<std::size_t>(coordinate.joint)];
  return unit_of(joint.freedoms[static_cast<std::size_t>(coordinate.component)].kind);
}

/// Calls `each(name, unit)` for every auxiliary state in their order.
template <class Each>
void for_each_state(const Model& model, const Each& each) {
  for (const Tyre& tyre : model.tyres) {
    each(tyre.name + "_u", "m");
    each(tyre.name + "_v", "m");
  }
  for (const JointFriction& friction : model.frictions) {
    if (friction.has_bristle()) each(friction.name + "_bristle", unit_of_coordinate(model, friction.joint));
  }
  for (const SpringFriction& friction : model.spring_frictions) {
    if (friction.has_bristle()) each(friction.name + "_bristle", "m");
  }
}

}  // namespace

int auxiliary_state_count(const Model& model) {
  int count = 0;
  for_each_state(model, [&](const std::string&, const char*) { ++count; });
  return count;
}

std::vector<std::string> auxiliary_state_names(const Model& model) {
  std::vector<std::string> names;
  for_each_state(model, [&](const std::string& name, const char*) { names.push_back(name); });
  return names;
}

std::vector<std::string> auxiliary_state_units(const Model& model) {
  std::vector<std::string> units;
  for_each_state(model, [&](const std::string&, const char* unit) { units.emplace_back(unit); });
  return units;
}

}  // namespace mbgen
