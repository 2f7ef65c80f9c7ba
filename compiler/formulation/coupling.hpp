#pragma once
// Couplings: relations between coordinates as equations of their loop block. A multiplier is the generalised force on a
// coordinate for a slope of one.

#include <map>

#include "compiler/formulation/kinematics.hpp"
#include "compiler/model/moving.hpp"

namespace mbgen {

/// The relation of a coupling and its derivatives.
template <class T>
struct CouplingEquation {
  T residual{0.0};
  std::map<int, T> slopes;  ///< by tree joint
  T acceleration{0.0};      ///< second time derivative at zero joint accelerations
};

/// The equation of a loop of kind coupling at the positions and velocities of the system. Cost: the relation once for
/// each of its coordinates and once more.
template <class T>
CouplingEquation<T> coupling_equation(const System<T>& system, const Loop& loop) {
  const auto heading = within_loop(system.annotator, index_in(system.topology.loops, loop));
  const Coupling& coupling = system.model.couplings[loop.coupling];
  std::vector<int> joints;
  std::vector<T> positions;
  std::vector<Jet<T>> moving;
  for (const CoordinateReference& coordinate : coupling.coordinates) {
    const int joint = tree_coordinate(system.topology, coordinate);
    joints.push_back(joint);
    positions.push_back(system.z(joint));
    moving.emplace_back(system.z(joint), system.zd(joint), T(0.0));
  }
  const std::vector<T> slopes = relation_slopes(system.model, coupling, positions, system.environment);
  const Jet<T> moved = evaluate_relation(system.model, coupling, moving, system.environment);
  CouplingEquation<T> equation{moved.value, {}, moved.second};
  for (std::size_t i = 0; i < joints.size(); ++i) {
    system.annotator.name(slopes[i], "J_", loop.name, "_", system.topology.bodies[joints[i]].coordinate);
    equation.slopes[joints[i]] = slopes[i];
  }
  return equation;
}

}  // namespace mbgen
