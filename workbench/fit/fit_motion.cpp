#include "workbench/fit/fit_motion.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "compiler/reader/read_model.hpp"
#include "compiler/text/user_error.hpp"
#include "workbench/host/assignments.hpp"
#include "workbench/host/message.hpp"
#include "workbench/motion/motion_end.hpp"
#include "workbench/motion/motion_judge.hpp"
#include "workbench/sensitivity/tangent_engine.hpp"
#include "workbench/start/initial_state.hpp"

namespace mbgen::fit {
namespace {

/// Sets values at the start of a run into the model.
void set_starts(const std::vector<Unknown>& unknowns, const std::vector<double>& values, int run, Model& model) {
  for (std::size_t u = 0; u < unknowns.size(); ++u) {
    const Unknown& unknown = unknowns[u];
    if (unknown.kind != Unknown::Kind::start || unknown.run != run) continue;
    const bool is_velocity = unknown.coordinate.starts_with("zd.");
    const std::string name = unknown.coordinate.substr(is_velocity ? 3 : 2);
    std::vector<InitialValue>& list = is_velocity ? model.initial.velocities : model.initial.positions;
    for (std::size_t j = 0; j < model.joints.size(); ++j)
      for (std::size_t f = 0; f < model.joints[j].freedoms.size(); ++f) {
        if (model.joints[j].freedoms[f].name != name) continue;
        const CoordinateReference coordinate{static_cast<int>(j), static_cast<int>(f)};
        std::erase_if(list, [&](const InitialValue& one) { return one.coordinate == coordinate; });
        list.push_back({coordinate, values[u], model.joints[j].where});
      }
  }
}

/// Whole steps up to the last row.
SimulationSettings settings_to(const FreeModel& model, double end) {
  SimulationArguments arguments = model.arguments.simulation;
  const double step = arguments.step.value_or(model.model.solver.step);
  constexpr double kRounding = 1e-9;
  arguments.duration = std::max(1.0, std::ceil(end / step - kRounding)) * step;
  return settings_of(arguments, model.model.solver);
}

/// Takes the matched outputs at every point, and their derivatives.
class SeriesRecorder {
 public:
  SeriesRecorder(const MeasuredFile& file, const std::vector<Channel>& channels, const TangentEngine& engine)
      : engine_(engine), series_(file.channels.size()) {
    for (const MeasuredChannel& one : file.channels)
      outputs_.push_back(static_cast<std::size_t>(channels[static_cast<std::size_t>(one.channel)].output));
    if (engine_.memory) derivatives_.assign(static_cast<std::size_t>(engine_.memory->parameters), series_);
  }
  void add(const Sample& sample) {
    add(sample.state.t, series_, [&](std::size_t output) { return sample.outputs.y[output]; });
    const std::vector<double> derivatives = output_derivatives(engine_);
    for (std::size_t p = 0; p < derivatives_.size(); ++p)
      add(sample.state.t, derivatives_[p],
          [&](std::size_t output) { return derivatives[output * derivatives_.size() + p]; });
  }
  void give(Outcome& outcome) {
    outcome.series = std::move(series_);
    outcome.derivatives = std::move(derivatives_);
  }

 private:
  template <class Value>
  void add(double time, std::vector<Series>& series, const Value& value) {
    for (std::size_t c = 0; c < outputs_.size(); ++c) {
      series[c].at.push_back(time);
      series[c].values.push_back(value(outputs_[c]));
    }
  }

  const TangentEngine& engine_;
  std::vector<std::size_t> outputs_;
  std::vector<Series> series_;
  std::vector<std::vector<Series>> derivatives_;
};

/// The points of a motion that the data need: those at their times, or three on each side for the cubic between two;
/// all of them where a channel has a delay.
std::vector<bool> needed_points(const MeasuredFile& file, const std::vector<Channel>& channels,
                                const SimulationSettings& settings) {
  std::vector<bool> needed(static_cast<std::size_t>(settings.steps) + 1, false);
  for (const MeasuredChannel& measured : file.channels) {
    if (channels[static_cast<std::size_t>(measured.channel)].delay >= 0) return {};
    for (const double instant : measured.at) {
      constexpr long kBeside = 3;
      const double place = instant / settings.step;
      const bool is_point = std::abs(place - std::round(place)) < kSamePoint;
      const long first = is_point ? std::lround(place) : static_cast<long>(place) + 1 - kBeside;
      const long last = is_point ? first : static_cast<long>(place) + kBeside;
      for (long k = std::max(0L, first); k <= std::min(last, settings.steps); ++k)
        needed[static_cast<std::size_t>(k)] = true;
    }
  }
  return needed;
}

Outcome moved(const FreeModel& model, const MeasuredFile& file, const std::vector<Channel>& channels,
              const std::vector<Unknown>& unknowns, const Compilation& compilation, Care care,
              const std::function<bool()>& is_stopped) {
  TangentEngine moving = engine_of(model, unknowns, compilation, care == Care::exact);
  const Engine& engine = moving.engine;
  const std::vector<std::string>& assignments = model.arguments.engine.inputs;
  const InputsOverTime inputs =
      file.inputs ? inputs_of(compilation.model, assignments, *file.inputs, model.arguments.simulation.interpolation)
                  : inputs_of(compilation.model, assignments, {});
  SimulationSettings settings = settings_to(model, file.end);
  settings.is_stopped = is_stopped;
  const Start start = initial_start(compilation, inputs.at(0));
  const GenericState state = initial_state(start, engine);
  start_motion(compilation, state, moving);
  SeriesRecorder recorder(file, channels, moving);
  Outcome outcome;
  JudgedMotion motion;
  const auto record = [&](const Sample& sample) { recorder.add(sample); };
  if (care == Care::judged) {
    motion = judged_motion({.compilation = compilation,
                            .engine = engine,
                            .integrator = model.choice.integrator,
                            .settings = settings,
                            .start = state,
                            .inputs = inputs},
                           record);
    outcome.warnings = motion.verdict.warnings;
    if (!motion.verdict.failure.empty()) outcome.failure = first_line(motion.verdict.failure);
  } else {
    const std::vector<bool> needed = needed_points(file, channels, settings);
    if (!needed.empty()) settings.is_sample = [&](long step) { return needed[static_cast<std::size_t>(step)]; };
    motion.summary = simulate(engine, state, inputs, settings, record);
  }
  if (motion.summary.is_stopped) outcome.failure = "interrupted";
  if (!motion.summary.status.ok()) outcome.failure = first_line(end_text(compilation, motion));
  recorder.give(outcome);
  return outcome;
}

}  // namespace

Outcome motion_of(const FreeModel& model, const MeasuredFile& file, int run, const std::vector<Channel>& channels,
                  const std::vector<Unknown>& unknowns, const std::vector<double>& values, Care care,
                  const std::function<bool()>& is_stopped) {
  try {
    Compilation compilation = compilation_at(model, unknowns, values);
    set_starts(unknowns, values, run, compilation.model);
    return moved(model, file, channels, unknowns, compilation, care, is_stopped);
  } catch (const UserError& error) {
    return {first_line(error.what()), {}, {}};
  }
}

}  // namespace mbgen::fit
