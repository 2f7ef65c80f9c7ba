#include "workbench/motion/simulation_arguments.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "compiler/reader/read_model.hpp"
#include "compiler/text/user_error.hpp"
#include "mbgen/sampling.hpp"
#include "mbgen/solver/step_time.hpp"

namespace mbgen {
namespace {

constexpr double kMostSteps = 1e12;

Interpolation interpolation_of(const std::string& name) {
  if (name.empty() || name == "pchip") return Interpolation::pchip;
  if (name == "linear") return Interpolation::linear;
  if (name == "spline") return Interpolation::spline;
  if (name == "hold") return Interpolation::hold;
  throw UserError(
      fmt::format("--interpolation: no interpolation \"{}\"; there are: pchip, linear, spline, hold\n", name));
}

/// Whether a period is a whole number of steps, both s.
bool is_multiple(double period, double step) {
  const double ratio = period / step, whole = std::nearbyint(ratio);
  return whole >= 1 && std::abs(ratio - whole) <= kSamePeriod * whole;
}

/// The longest step up to `step`, s, of which every period is a multiple; none among the first parts of one period.
std::optional<double> whole_step(const Model& model, double step) {
  constexpr int kMostParts = 10000;
  const double period = model.sampled.front().period;
  const int fewest = static_cast<int>(std::clamp(std::ceil(period / step), 1.0, static_cast<double>(kMostParts)));
  for (int parts = fewest; parts <= kMostParts; ++parts) {
    const auto is_whole = [&](const SampledValue& value) { return is_multiple(value.period, period / parts); };
    if (std::ranges::all_of(model.sampled, is_whole)) return period / parts;
  }
  return {};
}

}  // namespace

SolverSettings::Integrator integrator_of(const std::string& name, SolverSettings::Integrator of_model,
                                         const std::string& engine) {
  using Integrator = SolverSettings::Integrator;
  if (name.empty()) return is_cartesian(engine) ? Integrator::rk4 : of_model;
  if (name == "rk4") return Integrator::rk4;
  if (name == "auto") throw UserError("--integrator: auto looks at one motion: name rk4, abm4 or rosenbrock here\n");
  if (name != "abm4" && name != "rosenbrock") {
    throw UserError(fmt::format("--integrator: no integrator \"{}\"; there are: rk4, abm4, rosenbrock\n", name));
  }
  if (is_cartesian(engine)) {
    throw UserError(
        fmt::format("--integrator: engine \"{}\" works in Cartesian coordinates and integrates by rk4 only\n", engine));
  }
  return name == "abm4" ? Integrator::abm4 : Integrator::rosenbrock;
}

InputsOverTime inputs_of(const Model& model, const std::vector<std::string>& assignments,
                         const SimulationArguments& arguments) {
  const Interpolation interpolation = interpolation_of(arguments.interpolation);
  if (arguments.input_table.empty() && !arguments.interpolation.empty()) {
    throw UserError("--interpolation: goes with --input-table, found none\n");
  }
  return inputs_over_time(model, assignments, arguments.input_table, interpolation);
}

InputsOverTime inputs_of(const Model& model, const std::vector<std::string>& assignments, const InputTable& table,
                         const std::string& interpolation) {
  return inputs_over_time(model, assignments, table, interpolation_of(interpolation));
}

SimulationSettings settings_of(const SimulationArguments& arguments, const SolverSettings& by_default) {
  const double duration = arguments.duration.value_or(by_default.duration);
  const double step = arguments.step.value_or(by_default.step);
  if (!(duration > 0) || !std::isfinite(duration)) {
    throw UserError(fmt::format("--duration: must be positive and finite, found {}\n", duration));
  }
  if (!(step > 0) || !std::isfinite(step)) {
    throw UserError(fmt::format("--step: must be positive and finite, found {}\n", step));
  }
  const double steps = steps_in(duration, step).count;
  if (!(steps < kMostSteps)) {
    throw UserError(fmt::format("--step: {} s is too small for a duration of {} s\n", step, duration));
  }
  SimulationSettings settings{static_cast<long>(steps), duration / steps};
  settings.is_error_controlled = arguments.integrator.starts_with("cvode");
  return settings;
}

/// Whether elements have bristles or ropes in grooves.
bool has_lags(const Model& model) {
  bool has_some = false;
  each_element(model, [&](const auto& element) {
    if constexpr (requires { element.lag; }) has_some = true;
  });
  return has_some;
}

void follow_step(const SimulationSettings& settings, std::vector<VariedParameter>& set, Model& model) {
  const auto is_load = [](const SampledValue& value) { return value.load.has_value(); };
  const bool has_loads = std::any_of(model.sampled.begin(), model.sampled.end(), is_load);
  const bool lengthens = settings.step > model.solver.step && !settings.is_error_controlled && has_lags(model);
  if (settings.step == model.solver.step || !(has_loads || lengthens)) return;
  set.push_back({kStepOfMotion, settings.step});
  const Model again = expect(read_varied_model(model.file, set));
  for (std::size_t i = 0; i < model.sampled.size(); ++i) model.sampled[i].period = again.sampled[i].period;
  if (!lengthens) return;
  each_kind([&](auto kind) {
    for (std::size_t i = 0; i < kind.list(model).size(); ++i)
      if constexpr (requires { kind.list(model)[i].lag; }) kind.list(model)[i].lag = kind.list(again)[i].lag;
  });
}

void require_whole_periods(const SimulationSettings& settings, const Model& model) {
  for (const SampledValue& value : model.sampled) {
    if (is_multiple(value.period, settings.step)) continue;
    const std::optional<double> fitting = whole_step(model, settings.step);
    throw UserError(
        fmt::format("--step: \"{}\" is set every {:g} s, which is no multiple of the step {:g} s\n  hint: {}\n",
                    value.name, value.period, settings.step,
                    fitting ? fmt::format("--step {}, and a duration of whole periods", *fitting)
                            : "a step of which every \"period\" is a multiple, and a duration of whole periods"));
  }
}

}  // namespace mbgen
