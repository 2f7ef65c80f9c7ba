#pragma once
// Forces on the tree of a model at rest, over the scalars of the formulation.

#include <vector>

#include "runtime/generic/equations.hpp"

namespace mbgen {

/// A state at rest: its kinematics and inertias, the forces of the tree's coordinates and the directions in which the
/// loops let them move, frozen partition.
template <class T>
struct RestForces {
  Kinematics<T> kinematics;
  Inertias<T> inertias;
  AppliedForces<T> applied;
  std::vector<T> tree;  ///< per coordinate, N or N m
  std::vector<GroupProjection<T>> directions;
};

/// Requires: velocities of the system's state are zero, its loops closed.
template <class T>
RestForces<T> rest_forces(System<T>& system, const Analysis& analysis) {
  RestForces<T> rest;
  rest.kinematics = kinematics(system);
  const Velocities<T> v = velocities(system, rest.kinematics);
  rest.inertias = inertias(system, rest.kinematics);
  rest.applied = applied_forces(system, rest.kinematics, v);
  const std::vector<T> still(system.environment.z.size(), T(0.0));
  rest.tree = tree_forces(system, rest.kinematics, rest.inertias, v,
                          mbgen::accelerations(system, rest.kinematics, v, still), rest.applied, still);
  rest.directions = frozen_directions(system, rest.kinematics, analysis.blocks, analysis.driven);
  return rest;
}

}  // namespace mbgen
