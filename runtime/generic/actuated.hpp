#pragma once
// Free directions of a mechanism at one state of the generic runtime, and what actuators see of them.

#include <vector>

#include "runtime/generic/equations.hpp"

namespace mbgen {

/// Factors and directions at one state, as ActuatedMotion of mbgen/solver/actuated_motion.hpp has them for generated
/// solvers.
struct GenericActuatedMotion {
  int coordinates = 0, directions = 0, actuators = 0;
  ActuatorsSeen<double> seen;
  std::vector<double> basis;   ///< coordinates x directions, orthonormal columns
  std::vector<double> speeds;  ///< actuators x directions, scaled by weights, orthonormal columns
  std::vector<double> r, scale;
  std::vector<int> order;
  PerBlock residual, acceleration;  ///< of the loops
  double smallest = 0;              ///< speed of the actuators along a free direction, over the typical one

  /// Requires: as many actuated as free directions. Fails: loop_singular.
  Status look(GenericEquations& equations, const GenericState& state);
  /// Fails: actuators_singular, with the direction whose coordinate moves most.
  Status actuators_status(const GenericEquations& equations) const;
  /// Adds to x the free motion that lets the actuators move by `along`, less what they move by x.
  void add_along(const std::vector<double>& along, std::vector<double>& x) const;
  /// Least weighted forces with the same virtual work as tau.
  std::vector<double> forces_for(const std::vector<double>& tau) const;
};

}  // namespace mbgen
