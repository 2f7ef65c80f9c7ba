#pragma once
// Forces of actuators for accelerations of any coordinates that determine a motion.

#include <vector>

#include "workbench/engines/engine.hpp"

namespace mbgen {

/// Forces of the actuators at a state, and all accelerations in the derivative. given: per coordinate, NaN where there
/// is none. Accelerations of the independent coordinates are taken as they are; where one is missing, those with the
/// least squared differences from the given ones. Requires: the engine has inverse dynamics. Fails: as
/// Engine::inverse_dynamics; UserError where the given accelerations leave others open.
Status actuator_forces(const Engine& engine, const Compilation& compilation, const LoadedState& at,
                       const std::vector<double>& given, GenericDerivative& derivative, std::vector<double>& force);

}  // namespace mbgen
