#pragma once
// Couplings: relations between coordinates as equations of their loop block. A multiplier is the generalised force on a
// coordinate for a slope of one.

#include <map>

#include "compiler/formulation/kinematics.hpp"
#include "compiler/model/jet.hpp"

namespace mbgen {

/// The relation of a coupling and its derivatives.
template <class T>
struct CouplingEquation {
  T residual{0.0};
  std::map<int, T> slopes;  ///< by tree joint
  T acceleration{0.0};      ///< second time derivative at zero joint accelerations
};

namespace detail {

/// Positions that move at given rates, parameters that stand still. rate_of: of a tree coordinate.
template <class T, class RateOf>
struct RelationEnvironment {
  const Environment<T>& environment;
  RateOf rate_of;

  Jet<T> parameter(int index) const { return Jet<T>(environment.parameter(index)); }
  Jet<T> position(const CoordinateReference& c) const {
    return {environment.position(c), rate_of(tree_coordinate(*environment.topology, c)), T(0.0)};
  }
  // read_model refuses the others in a relation.
  Jet<T> input(int) const { return {}; }
  Jet<T> time() const { return {}; }
  Jet<T> velocity(const CoordinateReference&) const { return {}; }
  Jet<T> local(int) const { return {}; }
};

template <class T, class RateOf>
Jet<T> relation_along(const System<T>& system, const Loop& loop, RateOf rate_of) {
  const Model& model = system.model;
  return evaluate<Jet<T>>(model.expressions[model.couplings[loop.coupling].relation.expression],
                          RelationEnvironment<T, RateOf>{system.environment, rate_of});
}

}  // namespace detail

/// The equation of a loop of kind coupling at the positions and velocities of the system. Cost: the relation once for
/// each of its coordinates and once more.
template <class T>
CouplingEquation<T> coupling_equation(const System<T>& system, const Loop& loop) {
  const auto heading = system.scribe.within(OwnerKind::loop, index_in(system.topology.loops, loop));
  CouplingEquation<T> equation;
  for (const CoordinateReference& coordinate : system.model.couplings[loop.coupling].coordinates) {
    const int joint = tree_coordinate(system.topology, coordinate);
    T& slope = equation.slopes[joint];
    slope = detail::relation_along(system, loop, [&](int j) { return T(j == joint ? 1.0 : 0.0); }).first;
    system.scribe.name(slope, "J_", loop.name, "_", system.topology.bodies[joint].coordinate);
  }
  const Jet<T> moved = detail::relation_along(system, loop, [&](int j) { return system.zd(j); });
  equation.residual = moved.value;
  equation.acceleration = moved.second;
  return equation;
}

}  // namespace mbgen
