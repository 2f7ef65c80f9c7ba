#include "workbench/cost/step_time.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <limits>

#include "compiler/text/user_error.hpp"
#include "mbgen/worst_case.hpp"
#include "workbench/cost/paper_tables.hpp"
#include "workbench/describe/names.hpp"
#include "workbench/engines/engine.hpp"
#include "workbench/host/assignments.hpp"
#include "workbench/start/initial_state.hpp"

namespace mbgen {
namespace {

constexpr int kTurnsOfMotion = 7;
constexpr int kMostStepsOfMotion = 1000;
constexpr double kLongestTurn = 0.2;  // s
constexpr int kTimedStates = 16;
constexpr int kShortTurns = 101;  // odd, for the median
constexpr int kRepetitions = 4;   // of all timed states in a short turn

/// One engine from one state on.
struct TimedMotion {
  Engine engine;
  GenericState start;
  std::vector<double> inputs;
  double h;
};

/// One turn: the time of each step in microseconds goes to `shortest` where it is shorter, states along the way to
/// `states`. Ends early after kLongestTurn seconds. Fails: UserError when the first step does.
void run_turn(const TimedMotion& motion, const Compilation& compilation, std::vector<double>& shortest,
              std::vector<LoadedState>& states) {
  using Clock = std::chrono::steady_clock;
  motion.engine.set_inputs(motion.inputs);
  GenericState state = motion.start;
  const Clock::time_point begin = Clock::now();
  for (std::size_t k = 0; k < shortest.size(); ++k) {
    states.push_back({state, std::vector<double>(state.z.size(), 0.0)});
    const Clock::time_point before = Clock::now();
    const Status status = motion.engine.step(state, motion.h);
    const Clock::time_point after = Clock::now();
    if (!status.ok() && k == 0) {
      throw UserError(fmt::format("generate: --measure: the first step of {} s fails: {}\n", motion.h,
                                  describe(compilation, status)));
    }
    const bool is_over = std::chrono::duration<double>(after - begin).count() > kLongestTurn;
    if (status.ok())
      shortest[k] = std::min(shortest[k], std::chrono::duration<double, std::micro>(after - before).count());
    if (!status.ok() || is_over) shortest.resize(k + (status.ok() ? 1 : 0));
  }
}

/// Every so many-th state, kTimedStates of them or fewer.
std::vector<LoadedState> some_of(const std::vector<LoadedState>& states) {
  const std::size_t stride = (states.size() + kTimedStates - 1) / kTimedStates;
  std::vector<LoadedState> some;
  for (std::size_t k = 0; k < states.size(); k += stride) some.push_back(states[k]);
  return some;
}

/// Microseconds of one evaluation of the accelerations: the shortest of many short turns.
double evaluation_time(const Engine& engine, const std::vector<LoadedState>& states) {
  using Clock = std::chrono::steady_clock;
  double shortest = std::numeric_limits<double>::infinity();
  for (int turn = 0; turn < kShortTurns; ++turn) {
    const Clock::time_point before = Clock::now();
    engine.time_accelerations(states, kRepetitions);
    const std::chrono::duration<double, std::micro> time = Clock::now() - before;
    shortest = std::min(shortest, time.count() / (kRepetitions * static_cast<double>(states.size())));
  }
  return shortest;
}

/// Shares of the nine steps in an evaluation, their sum 1: medians over many short turns, as an interrupt makes the
/// share of the step that it falls into large.
std::array<double, kSteps> step_shares(const Engine& engine, const std::vector<LoadedState>& states) {
  std::array<std::vector<double>, kSteps> seen;
  for (int turn = 0; turn < kShortTurns; ++turn) {
    const std::array<double, kSteps> shares = engine.step_shares(states, kRepetitions);
    for (int step = 0; step < kSteps; ++step) seen[step].push_back(shares[step]);
  }
  std::array<double, kSteps> medians{};
  double sum = 0;
  for (int step = 0; step < kSteps; ++step) {
    std::nth_element(seen[step].begin(), seen[step].begin() + kShortTurns / 2, seen[step].end());
    sum += medians[step] = seen[step][kShortTurns / 2];
  }
  for (double& share : medians) share /= sum > 0 ? sum : 1.0;
  return medians;
}

/// Steps 1 to 9 of all evaluations in a step, and the rest of the whole. Microseconds.
std::vector<SectionTime> sections_of(const Engine& engine, const std::vector<LoadedState>& states, int evaluations,
                                     double whole) {
  const double accelerations = std::min(whole, evaluations * evaluation_time(engine, states));
  const std::array<double, kSteps> shares = step_shares(engine, states);
  std::vector<SectionTime> sections;
  for (int step = 0; step < kSteps; ++step) {
    sections.push_back({fmt::format("accelerations: {}", kStepTitles[step]), accelerations * shares[step]});
  }
  sections.push_back({"closing the loops, integration and checks", whole - accelerations});
  return sections;
}

}  // namespace

StepTime measure_step(const Compilation& compilation) {
  const SolverSettings& settings = compilation.model.solver;
  EngineChoice choice;
  choice.integrator = settings.integrator;
  choice.use = SolverUse::timing_steps;
  choice.form = compilation.form();
  const std::vector<double> inputs = input_values(compilation.model, {});
  const GenericState start = initial_state(compilation, inputs);
  const TimedMotion motion{make_engine(compilation, choice), start, inputs, settings.step};

  std::vector<double> shortest(kMostStepsOfMotion, std::numeric_limits<double>::infinity());
  std::vector<LoadedState> states;
  for (int turn = 0; turn < kTurnsOfMotion; ++turn) {
    states.clear();
    run_turn(motion, compilation, shortest, states);
  }

  StepTime time;
  time.integrator = name_of(settings.integrator);
  time.h = settings.step;
  time.steps = static_cast<int>(shortest.size());
  time.slowest = *std::max_element(shortest.begin(), shortest.end());
  std::nth_element(shortest.begin(), shortest.begin() + time.steps / 2, shortest.end());
  time.median = shortest[time.steps / 2];
  time.evaluations = (settings.is_multistep() ? kAbm4Calls : kRk4Calls).regular.accelerations;
  time.sections = sections_of(motion.engine, some_of(states), time.evaluations, time.median);
  return time;
}

const SectionTime& leading_section(const StepTime& time) {
  return *std::max_element(time.sections.begin(), time.sections.end(),
                           [](const SectionTime& a, const SectionTime& b) { return a.microseconds < b.microseconds; });
}

}  // namespace mbgen
