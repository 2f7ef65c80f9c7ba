#include "workbench/motion/controlled_engine.hpp"

#include <fmt/format.h>

#include "compiler/model/auxiliary_states.hpp"
#include "compiler/text/user_error.hpp"
#include "workbench/motion/cvode_steps.hpp"

namespace mbgen {
namespace {

constexpr double kLeastTolerance = 1e-14, kLargestTolerance = 0.1;

}  // namespace

std::optional<ErrorControl> error_control_of(const std::string& integrator, std::optional<double> tolerance,
                                             const Model& model) {
  ErrorControl control;
  if (integrator == "cvode-adams") {
    control.method = ErrorControl::Method::adams;
  } else if (integrator != "cvode") {
    if (tolerance) throw UserError("--tolerance: goes with --integrator cvode or cvode-adams\n");
    return {};
  }
  if (!has_cvode()) {
    throw UserError(
        fmt::format("--integrator: this mbgen is built without {}: install SUNDIALS 6 (Debian: libsundials-dev) and "
                    "build mbgen again, or use rk4 or abm4\n",
                    integrator));
  }
  for (const SampledValue& value : model.sampled) control.periods.push_back(value.period);
  control.tolerance = tolerance.value_or(control.tolerance);
  if (!(control.tolerance >= kLeastTolerance && control.tolerance <= kLargestTolerance)) {
    throw UserError(fmt::format("--tolerance: must be from {} to {}, found {}\n", kLeastTolerance, kLargestTolerance,
                                control.tolerance));
  }
  return control;
}

Engine with_error_control(const Compilation& compilation, const Engine& engine, const InputsOverTime& inputs,
                          const ErrorControl& control, const std::shared_ptr<ErrorControlRecord>& record) {
  record->control = control;
  std::vector<double> magnitudes;
  for (const AuxiliaryState& state : auxiliary_states(compilation.model)) magnitudes.push_back(magnitude_of(state));
  std::optional<Corners> corners;
  if (control.finds_corners) corners.emplace(compilation);
  ControlledMotion motion(engine, inputs, std::move(magnitudes), std::move(corners));
  const std::shared_ptr<Stepper> stepper =
      make_cvode_stepper(std::move(motion),
                         BranchGuard(
                             compilation, [&inputs](double t) { return inputs.at(t); }, 0),
                         control, *record);
  Engine controlled = engine;
  controlled.step = [stepper, record](GenericState& state, double h) { return stepper->step(state, h); };
  return controlled;
}

}  // namespace mbgen
