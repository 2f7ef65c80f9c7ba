#pragma once
// Motions with error control: steps of variable size and order by CVODE of SUNDIALS, where mbgen is built with it.

#include <memory>
#include <optional>
#include <string>

#include "workbench/engines/engine.hpp"
#include "workbench/motion/error_control.hpp"
#include "workbench/motion/inputs_over_time.hpp"

namespace mbgen {

/// The control that an integrator of this name has; none for names of others. Fails: UserError for a tolerance that is
/// not between 1e-14 and 0.1, a tolerance with another integrator, and where mbgen is built without SUNDIALS.
std::optional<ErrorControl> error_control_of(const std::string& integrator, std::optional<double> tolerance,
                                             const Model& model);

/// An engine whose steps are those of `engine` with error control: `step` gives the motion at the end of each by
/// interpolation. All of z, zd and x are integrated; every evaluation closes the loops first. It starts anew at rows of
/// the inputs' table, at instants of sampled values, where a ball changes its chart, where the loops have come open and
/// at corners of laws.
/// inputs: outlive the engine. record: the facts, also of a step that fails.
Engine with_error_control(const Compilation& compilation, const Engine& engine, const InputsOverTime& inputs,
                          const ErrorControl& control, const std::shared_ptr<ErrorControlRecord>& record);

}  // namespace mbgen
