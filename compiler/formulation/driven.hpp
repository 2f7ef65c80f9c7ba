#pragma once
// Driven coordinates: position, velocity and acceleration from a motion's expression of time and of inputs (theory.md
// section 4).

#include "compiler/formulation/kinematics.hpp"
#include "compiler/model/moving.hpp"

namespace mbgen {

/// A prescribed coordinate and its derivatives.
template <class T>
struct Drive {
  int coordinate = -1;  ///< tree index
  T position{0.0}, velocity{0.0}, acceleration{0.0};
};

/// All motions of the model at the time and the inputs of the system's environment.
template <class T>
std::vector<Drive<T>> drives(const System<T>& system) {
  std::vector<Drive<T>> result;
  for (const Motion& motion : system.model.motions) {
    const auto heading = system.annotator.within(OwnerKind::motion, index_in(system.model.motions, motion));
    const Jet<T> z = evaluate_motion<T>(system.model, motion, system.environment);
    result.push_back({tree_coordinate(system.topology, motion.joint), z.value, z.first, z.second});
  }
  return result;
}

}  // namespace mbgen
