#include "workbench/motion/step_error_watch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compiler/text/number.hpp"
#include "workbench/engines/engine.hpp"

namespace mbgen {
namespace {

constexpr long kHalvedSteps = 5;  // of a motion
/// Steps after which errors are counted: those of stiff vibrations are damped by then, and do not add up.
constexpr long kLater = 64;
/// Rates are compared with their largest value, with this part of the largest of their unit, or with this one:
/// stretches of beams and bushings, whose vibrations an implicit step damps, are small.
constexpr double kSmallRate = 0.05, kLeastRate = 0.01;  // rad/s or m/s

}  // namespace

StepErrorWatch::StepErrorWatch(const Compilation& compilation, const Engine& engine,
                               SolverSettings::Integrator integrator, const SimulationSettings& settings,
                               const InputsOverTime* inputs)
    : compilation_(compilation),
      settings_(settings),
      inputs_(inputs),
      every_(std::max(1L, settings.steps / kHalvedSteps)) {
  if (integrator != SolverSettings::Integrator::rosenbrock || !inputs || settings.is_error_controlled) return;
  EngineChoice own;
  own.integrator = integrator;
  engine_ = engine.follows_motion ? make_generic_engine(compilation, own) : engine;
  errors_.assign(compilation.topology.bodies.size(), 0.0);
  rates_ = errors_;
}

bool StepErrorWatch::step(GenericState& state, double length, double end) {
  if (inputs_->is_constant) engine_->set_inputs(inputs_->at(state.t));
  bool in_parts = false;
  return step_motion(*engine_, *inputs_, length, end, state, in_parts).ok();
}

void StepErrorWatch::add(const Sample& sample) {
  if (!engine_) return;
  const GenericState& now = sample.moving;
  for (std::size_t i = 0; i < rates_.size(); ++i) rates_[i] = std::max(rates_[i], std::abs(now.zd[i]));
  if (halved_) {
    const double before = now.t - settings_.step, half = settings_.step / 2;
    const bool is_first = since_ == 0;
    const bool is_ok = is_first ? step(*halved_, half, before + half) && step(*halved_, half, now.t)
                                : step(*halved_, settings_.step, now.t);
    engine_->set_inputs(inputs_->at(now.t));
    if (!is_ok || halved_->charts != now.charts) return halved_.reset();
    if (++since_ < kLater) return;
    for (std::size_t i = 0; i < errors_.size(); ++i) errors_[i] += std::abs(now.zd[i] - halved_->zd[i]);
    ++looks_;
    halved_.reset();
  }
  if (sample.step % every_ == 0) halved_ = now, since_ = 0;
}

void StepErrorWatch::judge(const SimulationSummary& summary, StepVerdict& verdict) const {
  if (looks_ == 0 || !verdict.failure.empty() || !verdict.warnings.empty()) return;  // these told it
  double largest[2] = {kAtRest, kAtRest};  // rate of rotations, of translations
  const auto unit = [&](std::size_t i) {
    return compilation_.topology.bodies[i].kind == FreedomKind::revolute ? 0 : 1;
  };
  for (std::size_t i = 0; i < rates_.size(); ++i) largest[unit(i)] = std::max(largest[unit(i)], rates_[i]);
  double most = kRateError;
  std::size_t worst = rates_.size();
  for (std::size_t i = 0; i < rates_.size(); ++i) {
    const double size = std::max({rates_[i], kSmallRate * largest[unit(i)], kLeastRate});
    const double relative = errors_[i] / static_cast<double>(looks_) * static_cast<double>(summary.steps) / size;
    if (relative > most) most = relative, worst = i;
  }
  if (worst == rates_.size()) return;
  const double fitting = round_number_below(settings_.step * std::sqrt(kRateError / 2 / most));
  verdict.warnings.push_back(fmt::format(
      "steps of {:.6g} s err: by two half steps in place of one the rate of {} may be off by {:.2g} % over the motion; "
      "stiff parts that turn ask for shorter steps, or for coordinates that turn with them; --step {:.3g} would do",
      settings_.step, compilation_.topology.bodies[worst].coordinate, 100 * most, fitting));
  if (verdict.fitting_step == 0 || fitting < verdict.fitting_step) verdict.fitting_step = fitting;
}

}  // namespace mbgen
