#pragma once
// Driven coordinates: position, velocity and acceleration from the motion's expression of time (theory.md section 4).

#include "compiler/formulation/kinematics.hpp"
#include "compiler/model/jet.hpp"

namespace mbgen {

/// A prescribed coordinate and its derivatives.
template <class T>
struct Drive {
  int coordinate = -1;  ///< tree index
  T position{0.0}, velocity{0.0}, acceleration{0.0};
};

/// All motions of the model at the time of the system's environment.
template <class T>
std::vector<Drive<T>> drives(const System<T>& system) {
  const auto steady = [](const std::vector<T>& values) {
    std::vector<Jet<T>> jets;
    for (const T& value : values) jets.push_back(Jet<T>{value, T(0.0), T(0.0)});
    return jets;
  };
  Environment<Jet<T>> environment;
  environment.topology = &system.topology;
  environment.parameters = steady(system.environment.parameters);
  environment.inputs = steady(system.environment.inputs);
  environment.t = Jet<T>{system.environment.t, T(1.0), T(0.0)};
  std::vector<Drive<T>> result;
  for (const Motion& motion : system.model.motions) {
    system.scribe.place(motion.name);
    const Jet<T> z = value_of(system.model, motion.position, environment);
    result.push_back({tree_coordinate(system.topology, motion.joint), z.value, z.first, z.second});
  }
  return result;
}

}  // namespace mbgen
