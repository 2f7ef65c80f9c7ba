// The parts of the user's model that a rig removes.

#include "compiler/model/each_friction.hpp"
#include "workbench/kc/rig.hpp"

namespace mbgen::kc {
namespace {

/// Removes frictions, and their pressing loads, which are the last sampled values.
void take_frictions_away(Model& model) {
  std::size_t loads = 0;
  each_friction(model, [&loads](const FrictionLaw& friction) { loads += friction.load >= 0 ? 1 : 0; });
  model.frictions.clear();
  model.spring_frictions.clear();
  model.rod_frictions.clear();
  model.sampled.resize(model.sampled.size() - loads);
}

}  // namespace

void take_away(const Axle& axle, Model& model) {
  model.tyres.clear();
  take_frictions_away(model);
  model.outputs.clear();
  model.notes.clear();
  model.initial = {};
  for (const std::string& name : axle.without) {
    const auto each = [&](auto& list, const auto& silence) {
      for (auto& element : list) {
        if (element.name == name) silence(element);
      }
    };
    const auto silence_spring = [](auto& spring) {
      spring.stiffness.reset();
      spring.damping.reset();
      spring.force.reset();
      spring.preload = 0.0;
    };
    each(model.springs, silence_spring);
    each(model.joint_springs, silence_spring);
    each(model.air_springs, [](AirSpring& spring) { spring.area = Quantity(0.0), spring.volume.reset(); });
    each(model.forces, [](AppliedForce& force) { force.force = force.torque = {0.0, 0.0, 0.0}; });
    each(model.joint_forces, [](JointForce& force) { force.force = 0.0; });
  }
}

}  // namespace mbgen::kc
