#pragma once
// Motions with error control: steps of variable size and order by CVODE of SUNDIALS, if mbgen is built with it.

#include <memory>
#include <optional>
#include <string>

#include "workbench/engines/engine.hpp"
#include "workbench/motion/error_control.hpp"
#include "workbench/motion/inputs_over_time.hpp"

namespace mbgen {

/// Error control for an integrator of this name; none for other integrators. Fails: UserError for a tolerance that is
/// not between 1e-14 and 0.1, for a tolerance with another integrator, and if mbgen is built without SUNDIALS.
std::optional<ErrorControl> error_control_of(const std::string& integrator, std::optional<double> tolerance,
                                             const Model& model);

/// An engine whose `step` gives the motion of `engine` under error control at the end of each step, by interpolation.
/// All of z, zd and x are integrated; every evaluation closes the loops first. It restarts at rows of the inputs'
/// table, at instants of sampled values, at chart changes of balls, when the loops have drifted open, and at corners of
/// laws. inputs: outlive the engine. record: facts, also about a step that fails.
Engine with_error_control(const Compilation& compilation, const Engine& engine, const InputsOverTime& inputs,
                          const ErrorControl& control, const std::shared_ptr<ErrorControlRecord>& record);

}  // namespace mbgen
