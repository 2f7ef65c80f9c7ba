#pragma once
// Forces of actuators for positions and accelerations of any coordinates that determine a motion.

#include <string>
#include <vector>

#include "workbench/engines/engine.hpp"

namespace mbgen {

/// Forces of the actuators at a state.
struct InverseMotion {
  Status status;
  std::vector<std::string> open;  ///< coordinates whose accelerations would determine the motion, where others do not
  std::vector<double> force;      ///< N or N m
  GenericDerivative derivative;   ///< all accelerations
  bool ok() const { return status.ok() && open.empty(); }
};

/// The forces for accelerations. given: per coordinate, NaN where there is none. Accelerations of the independent
/// coordinates are taken as they are; where one is missing, those with the least squared differences from the given
/// ones. Where these do not determine the others, the generic engine finds the forces with coordinates chosen for the
/// state. inputs: that the engine has. Requires: the engine has inverse dynamics. Fails: as Engine::inverse_dynamics.
InverseMotion actuator_forces(const Engine& engine, const Compilation& compilation, const std::vector<double>& inputs,
                              const LoadedState& at, const std::vector<double>& given);

/// Words for its status: "ok", "loop singular: ...", "the given accelerations leave others open".
std::string describe(const Compilation& compilation, const InverseMotion& motion);

/// Accelerations to give in place of those which leave others open, "" else.
std::string hint_of(const InverseMotion& motion);

/// Closes the loops around the coordinates with given accelerations, all of a state whose accelerations are all given:
/// their positions and rates stay, the others move to the nearest. Fails: as GenericSolver::assemble.
Status close_around(const GenericSolver& poses, const Compilation& compilation, const std::vector<double>& given,
                    GenericState& state);

/// How far forces are beyond the limits of their actuators, N or N m, at least 0.
std::vector<double> beyond_limits(const Model& model, const std::vector<double>& force);

}  // namespace mbgen
