#include "workbench/motion/simulation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>

#include "compiler/text/user_error.hpp"
#include "mbgen/solver/step_time.hpp"

namespace mbgen {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

/// A clock, s, that stands while the engine loads a solver.
double solver_clock(const Engine& engine) {
  const double now = std::chrono::duration<double>(Clock::now().time_since_epoch()).count();
  return engine.loading_seconds ? now - engine.loading_seconds() : now;
}

/// Integral of samples at equal distances: Simpson's rule over pairs of steps, the trapezoidal rule for an odd last
/// one.
class Integral {
 public:
  void add(double value, double h) {
    if (count_ > 0) {
      const bool closes_a_pair = count_ % 2 == 0;
      if (closes_a_pair) pairs_ += h / 3 * (before_ + 4 * last_ + value);
      rest_ = closes_a_pair ? 0 : h / 2 * (last_ + value);
    }
    before_ = last_;
    last_ = value;
    ++count_;
  }
  /// The value jumps before the next row.
  void restart() {
    done_ = value();
    pairs_ = rest_ = 0;
    count_ = 0;
  }
  double value() const { return done_ + pairs_ + rest_; }

 private:
  long count_ = 0;  // of samples
  double before_ = 0, last_ = 0;
  double done_ = 0, pairs_ = 0, rest_ = 0;
};

void widen(std::vector<Range>& ranges, const std::vector<double>& values) {
  if (ranges.empty()) {
    for (const double value : values) ranges.push_back({value, value, value});
  }
  for (std::size_t i = 0; i < values.size(); ++i) {
    ranges[i] = {std::min(ranges[i].smallest, values[i]), std::max(ranges[i].largest, values[i]), values[i]};
  }
}

/// Data that the summary collects at each point.
class Collector {
 public:
  explicit Collector(double h) : h_(h) {}

  void add(const Sample& sample, const std::vector<double>& inputs, SimulationSummary& summary) {
    const GenericOutputs& outputs = sample.outputs;
    const double energy = outputs.kinetic_energy + outputs.potential_energy;
    if (sample.step == 0) first_energy_ = energy;
    work_.add(outputs.applied_power, h_);
    EnergyBalance& balance = summary.energy;
    balance.level = std::max(balance.level, std::abs(energy));
    balance.change = energy - first_energy_;
    balance.work = work_.value();
    balance.net = std::max({balance.net, std::abs(balance.change), std::abs(balance.work)});
    balance.scale = std::max({balance.scale, balance.net, outputs.kinetic_energy});
    summary.largest.position = std::max(summary.largest.position, sample.residuals.position);
    summary.largest.velocity = std::max(summary.largest.velocity, sample.residuals.velocity);
    widen(summary.outputs, outputs.y);
    widen(summary.inputs, inputs);
    for (std::size_t i = 0; i < sample.state.zd.size(); ++i) {
      if (std::abs(sample.state.zd[i]) <= summary.largest_velocity) continue;
      summary.largest_velocity = std::abs(sample.state.zd[i]);
      summary.fastest = static_cast<int>(i);
    }
    summary.steps = sample.step;
    summary.end_time = sample.state.t;
  }

  /// Power just before the next point, if it jumps there.
  void add_before_jump(double power) {
    work_.add(power, h_);
    work_.restart();
  }

  /// Power just after the last point, if it jumped there.
  void add_after_jump(double power) {
    work_.restart();
    work_.add(power, h_);
  }

 private:
  double h_;
  double first_energy_ = 0;
  Integral work_;
};

/// Sorts the notices of steps by loop block. Several successive steps near a singular position are one passage.
class Notices {
 public:
  explicit Notices(double h) : h_(h) {}

  /// t: s, at the end of the step.
  void add(Status status, double t, std::vector<BlockEvents>& blocks) {
    // TurnWatch handles turns: it checks whether forces turn with them.
    if (status.code == Code::turned_far) status = {};
    if (status.code >= kFirstNotice && status.index >= static_cast<int>(blocks.size())) {
      blocks.resize(status.index + 1);
      entered_.resize(blocks.size());
    }
    for (std::size_t b = 0; b < blocks.size(); ++b) {
      const Code code = status.index == static_cast<int>(b) ? status.code : Code::ok;
      blocks[b].chosen_again += code == Code::chosen_again ? 1 : 0;
      blocks[b].near_singular += code == Code::near_singular || code == Code::singular_met ? 1 : 0;
      if (code == Code::singular_met) {
        if (!entered_[b]) entered_[b] = t - h_;
      } else {
        leave(b, t - h_, blocks[b]);
      }
    }
  }

  void finish(double t, std::vector<BlockEvents>& blocks) {
    for (std::size_t b = 0; b < blocks.size(); ++b) leave(b, t, blocks[b]);
  }

 private:
  void leave(std::size_t b, double t, BlockEvents& block) {
    if (!entered_[b]) return;
    if (block.singular_times.size() < kSingularTimes) block.singular_times.push_back((*entered_[b] + t) / 2);
    ++block.singular_met;
    entered_[b].reset();
  }

  double h_;
  std::vector<std::optional<double>> entered_;  ///< s, per block: when a singular position was entered that is not left
};

/// Fills in a sample for a state of a motion with steps of h seconds.
Status observe(const Engine& engine, double h, const GenericState& state, Sample& sample, LoadedState& at,
               GenericDerivative& derivative) {
  at.state = sample.moving = state;
  sample.state = in_users_angles(engine.balls, state);
  Status status = engine.accelerations_in_motion(state, h, derivative);
  if (status.ok()) status = engine.outputs(at, derivative, sample.outputs);
  if (status.ok()) status = engine.residuals(state, sample.residuals);
  return status;
}

/// A step in parts: each starts with its own inputs, so that a multistep method starts anew.
Status step_in_parts(const Engine& engine, const InputsOverTime& inputs, const std::vector<StepPart>& parts,
                     GenericState& state) {
  Status met;
  for (const StepPart& part : parts) {
    engine.set_inputs(inputs.is_constant ? inputs.at(part.start) : inputs.of_step(part.start, part.end - part.start));
    state.t = part.start;
    const Status status = engine.step(state, part.end - part.start);
    if (!status.ok()) return status;
    met = graver(met, status);
  }
  return met;
}

/// Power just before the end of a step with a row of a table, where accelerations of inputs jump, and with them the
/// power of driven joints; or of one made in parts, at whose end a law of time may jump.
std::optional<double> power_before_jump(const Engine& engine, const InputsOverTime& inputs, double h, double start,
                                        GenericState state, bool in_parts) {
  if (!in_parts && !inputs.has_row(start, state.t)) return {};
  constexpr double kJustBefore = 1e-9;  // of a step
  const double end = state.t;
  Sample sample;
  LoadedState at{state, std::vector<double>(state.z.size(), 0.0)};
  GenericDerivative derivative;
  state.t = end - kJustBefore * h;
  engine.set_inputs(inputs.at(state.t));
  const Status status = observe(engine, h, state, sample, at, derivative);
  engine.set_inputs(inputs.at(end));
  return status.ok() ? std::optional(sample.outputs.applied_power) : std::nullopt;
}

/// Power at the start of a step after sampled values are set, if some are due: forces jump with them.
std::optional<double> power_after_samples(const Engine& engine, double h, const GenericState& state) {
  if (!engine.sample) return {};
  bool any = false;
  Sample sample;
  LoadedState at{state, std::vector<double>(state.z.size(), 0.0)};
  GenericState sampled = state;
  GenericDerivative derivative;
  if (!engine.sample(sampled, h, any).ok() || !any) return {};
  if (!observe(engine, h, sampled, sample, at, derivative).ok()) return {};
  return sample.outputs.applied_power;
}

/// Whether a step that is too long may be the cause of a status.
bool may_be_of_step(Status status) {
  return status.code == Code::not_a_number || status.code == Code::auxiliary_not_a_number ||
         status.code == Code::loop_not_closed || status.code == Code::loop_singular || status.code == kNotHeld;
}

/// The longest of h/10, h/100 and h/1000 with which the motion continues from `state` over h seconds, 0 for none.
double passable_step(const Engine& engine, const InputsOverTime& inputs, const GenericState& state, double h) {
  for (const int parts : {10, 100, 1000}) {
    const double part = h / parts;
    GenericState trial = state;
    engine.set_inputs(inputs.at(state.t));
    int k = 0;
    bool in_parts = false;
    while (k < parts && step_motion(engine, inputs, part, time_after(state.t, k + 1, part), trial, in_parts).ok()) ++k;
    if (k == parts) return part;
  }
  return 0;
}

/// Judges use angles and rates of the model, which do not exist for a ball at their pole.
void require_angles(const Engine& engine, const GenericState& state) {
  if (!engine.balls.empty() || largest_absolute(state.charts) == 0) return;
  throw UserError(
      fmt::format("engine {} starts from rates of angles, and a joint starts in their pole: give it another "
                  "\"sequence\", or take another engine\n",
                  engine.name));
}

}  // namespace

Status step_motion(const Engine& engine, const InputsOverTime& inputs, double h, double end, GenericState& state,
                   bool& in_parts) {
  const bool may_jump = !engine.sample && (!inputs.laws.is_empty() || !inputs.jumps.empty());
  const auto parts = may_jump ? inputs.laws.parts(state.t, end, inputs.jumps) : std::vector<StepPart>{};
  in_parts = !parts.empty();
  if (inputs.is_constant && !in_parts) {
    const Status status = engine.step(state, h);
    if (status.ok()) state.t = end;
    return status;
  }
  GenericState trial = state;
  if (!in_parts) engine.set_inputs(inputs.of_step(state.t, h));
  const Status stepped = in_parts ? step_in_parts(engine, inputs, parts, trial) : engine.step(trial, h);
  trial.t = end;
  engine.set_inputs(inputs.at(end));
  if (!stepped.ok()) return stepped;
  const Status status = engine.project(trial);
  if (!status.ok()) return status;
  state = std::move(trial);
  return graver(stepped, status);
}

SimulationSummary simulate(const Engine& engine, const GenericState& state, const InputsOverTime& given,
                           const SimulationSettings& settings, const std::function<void(const Sample&)>& on_sample,
                           const InputControl& control) {
  require_angles(engine, state);
  const Clock::time_point start = Clock::now();
  SimulationSummary summary;
  InputsOverTime inputs = given;
  inputs.is_constant = inputs.is_constant && !control;
  if (settings.is_error_controlled) inputs.laws = {}, inputs.jumps = {};  // its own steps end there
  Collector collector(settings.step);
  Notices notices(settings.step);
  Sample sample;
  GenericState moving = state;
  LoadedState at{state, std::vector<double>(state.z.size(), 0.0)};
  GenericDerivative derivative;
  engine.set_inputs(inputs.at(state.t));
  const bool has_all = !settings.is_sample;
  for (sample.step = 0;; ++sample.step) {
    if (!has_all) {
      summary.steps = sample.step;
      summary.end_time = moving.t;
    }
    const bool is_sample = has_all || sample.step == 0 || settings.is_sample(sample.step);
    if (is_sample) {
      summary.status = observe(engine, settings.step, moving, sample, at, derivative);
      // At the pole itself the angles have no accelerations; elsewhere steps change charts by themselves.
      if (!summary.status.ok() && sample.step == 0 && settle_charts(engine.balls, moving))
        summary.status = observe(engine, settings.step, moving, sample, at, derivative);
      if (summary.status.ok() && settings.has_multipliers)
        summary.status = engine.multipliers(at, derivative, sample.multipliers);
      if (!summary.status.ok()) break;
      sample.inputs = inputs.at(moving.t);
      if (has_all) collector.add(sample, sample.inputs, summary);
      summary.last = sample.state;
      on_sample(sample);
    }
    const bool goes_on = !control || control(sample, inputs);
    summary.is_stopped = sample.step < settings.steps && settings.is_stopped && settings.is_stopped();
    if (sample.step == settings.steps || !goes_on || summary.is_stopped) break;
    if (const auto power = has_all ? power_after_samples(engine, settings.step, moving) : std::nullopt)
      collector.add_after_jump(*power);
    const double before = solver_clock(engine);
    const double end = time_after(state.t, static_cast<double>(sample.step + 1), settings.step);
    bool in_parts = false;
    summary.status = step_motion(engine, inputs, settings.step, end, moving, in_parts);
    summary.solver_seconds += solver_clock(engine) - before;
    if (!summary.status.ok()) break;
    if (in_parts && ++summary.parted_steps == 1) summary.first_parted = end;
    notices.add(summary.status, moving.t, summary.blocks);
    if (!has_all) continue;
    const auto power = power_before_jump(engine, inputs, settings.step, summary.end_time, moving, in_parts);
    if (power) collector.add_before_jump(*power);
  }
  notices.finish(summary.end_time, summary.blocks);
  summary.wall_seconds = seconds_since(start);
  if (may_be_of_step(summary.status) && !settings.is_error_controlled) {
    summary.passable_step = passable_step(engine, inputs, moving, settings.step);
  }
  return summary;
}

}  // namespace mbgen
