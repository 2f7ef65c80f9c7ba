// mbgen bench: microseconds per evaluation of all accelerations, every engine in one process, taking turns.

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>
#include <random>

#include "compiler/cli/commands.hpp"
#include "compiler/cli/files.hpp"
#include "compiler/cli/initial_state.hpp"
#include "compiler/cli/options.hpp"
#include "compiler/cli/states_file.hpp"
#include "compiler/cli/user_error.hpp"

namespace mbgen::cli {
namespace {

constexpr int kStates = 16;
constexpr int kTries = 20 * kStates;  // random states that may fail to close before the model is given up
constexpr int kTurns = 21;
constexpr double kTurnSeconds = 0.02;
constexpr double kPositionSpread = 0.05;  // rad or m around the initial state
constexpr double kVelocitySpread = 0.5;   // rad/s or m/s
constexpr double kForceSpread = 100;      // N or N m

struct Options {
  std::string model, states;
  EngineArguments engine;
  bool json = false;
};

struct Measurement {
  const Engine* engine = nullptr;
  long long evaluations = 0;
  double microseconds = 0;   ///< median over the turns
  double spread = 0;         ///< distance of the quartiles over the median
  double largest_error = 0;  ///< of any acceleration over the largest of its state
};

/// Uniform in [-1, 1), the same numbers on every machine.
double uniform(std::mt19937& generator) { return static_cast<double>(generator()) / 2147483648.0 - 1.0; }

/// Consistent random states around the initial one.
std::vector<FileState> random_states(const Compilation& compilation, const Engine& engine,
                                     const std::vector<double>& inputs) {
  const GenericState centre = initial_state(compilation, inputs);
  std::mt19937 generator(1);
  std::vector<FileState> states;
  for (int k = 0; k < kTries && states.size() < kStates; ++k) {
    FileState state{{centre, centre.zd}, inputs, {}};
    for (double& z : state.at.state.z) z += kPositionSpread * uniform(generator);
    for (double& zd : state.at.state.zd) zd += kVelocitySpread * uniform(generator);
    for (double& tau : state.at.tau) tau = kForceSpread * uniform(generator);
    if (engine.project(state.at.state).ok()) states.push_back(state);
  }
  if (states.empty()) throw UserError("bench: found no closed configuration around the initial state\n");
  return states;
}

std::vector<double> accelerations_at(const Engine& engine, const Topology& topology, const LoadedState& at) {
  GenericDerivative derivative;
  const Status status = engine.accelerations(at, derivative);
  if (!status.ok()) {
    throw UserError(
        fmt::format("bench: engine {} has no accelerations: {}\n", engine.name, describe(topology, status)));
  }
  return derivative.zdd;
}

/// Fills in the accelerations to compare with, where the file has none, by the engine without specialised code.
void complete(std::vector<FileState>& states, const Engine& reference, const Topology& topology) {
  for (FileState& state : states) {
    if (state.zdd.empty()) state.zdd = accelerations_at(reference, topology, state.at);
  }
}

double largest_error(const Engine& engine, const Topology& topology, const std::vector<FileState>& states) {
  double largest = 0;
  for (const FileState& state : states) {
    std::vector<double> difference = accelerations_at(engine, topology, state.at);
    for (std::size_t i = 0; i < difference.size(); ++i) difference[i] -= state.zdd[i];
    const double scale = largest_absolute(state.zdd);
    largest = std::max(largest, scale > 0 ? largest_absolute(difference) / scale : largest_absolute(difference));
  }
  return largest;
}

double seconds_for(const Engine& engine, const std::vector<LoadedState>& states, int repetitions) {
  const auto start = std::chrono::steady_clock::now();
  engine.time_accelerations(states, repetitions);
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Repetitions that fill one turn.
int calibrate(const Engine& engine, const std::vector<LoadedState>& states) {
  int repetitions = 1;
  double seconds = seconds_for(engine, states, repetitions);
  while (seconds < kTurnSeconds / 4 && repetitions < 1 << 28) {
    repetitions *= 2;
    seconds = seconds_for(engine, states, repetitions);
  }
  return std::max(1, static_cast<int>(repetitions * kTurnSeconds / seconds));
}

/// The engines take turns, so that a slower moment of the machine meets all of them.
std::vector<Measurement> measure(const std::vector<Engine>& engines, const std::vector<LoadedState>& states) {
  std::vector<int> repetitions;
  std::vector<std::vector<double>> microseconds(engines.size());
  for (const Engine& engine : engines) repetitions.push_back(calibrate(engine, states));
  for (int turn = 0; turn < kTurns; ++turn) {
    for (std::size_t e = 0; e < engines.size(); ++e) {
      const double count = static_cast<double>(repetitions[e]) * static_cast<double>(states.size());
      microseconds[e].push_back(1e6 * seconds_for(engines[e], states, repetitions[e]) / count);
    }
  }
  std::vector<Measurement> measurements;
  for (std::size_t e = 0; e < engines.size(); ++e) {
    std::vector<double>& sorted = microseconds[e];
    std::sort(sorted.begin(), sorted.end());
    const double median = sorted[kTurns / 2];
    const double spread = (sorted[3 * kTurns / 4] - sorted[kTurns / 4]) / median;
    const long long evaluations =
        static_cast<long long>(repetitions[e]) * kTurns * static_cast<long long>(states.size());
    measurements.push_back({&engines[e], evaluations, median, spread, 0});
  }
  return measurements;
}

std::string to_json(const std::string& model, const std::vector<Measurement>& measurements) {
  using Json = nlohmann::ordered_json;
  Json engines = Json::array();
  long long evaluations = 0;
  for (const Measurement& measurement : measurements) {
    evaluations += measurement.evaluations;
    engines.push_back({{"name", measurement.engine->name},
                       {"form", measurement.engine->form},
                       {"linear_algebra", measurement.engine->linear_algebra},
                       {"batch", 1},
                       {"us_per_evaluation", measurement.microseconds},
                       {"spread", measurement.spread},
                       {"max_relative_error", measurement.largest_error}});
  }
  return Json({{"model", model}, {"evaluations", evaluations}, {"engines", engines}}).dump(2) + "\n";
}

std::string to_text(const std::string& model, const std::vector<Measurement>& measurements) {
  std::string text = fmt::format("{}: all accelerations of one state\n  {:<12}{:<10}{:<16}{:>14}{:>10}{:>14}\n", model,
                                 "engine", "form", "linear algebra", "microseconds", "spread", "largest error");
  for (const Measurement& measurement : measurements) {
    text += fmt::format("  {:<12}{:<10}{:<16}{:>14.3f}{:>8.1f} %{:>14.1e}\n", measurement.engine->name,
                        measurement.engine->form, measurement.engine->linear_algebra, measurement.microseconds,
                        100 * measurement.spread, measurement.largest_error);
  }
  return text;
}

int run(const Options& options) {
  const Compilation compilation = expect(compile(options.model));
  const std::vector<double> inputs = input_values(compilation.model, options.engine.inputs);
  std::vector<Engine> engines;
  for (const std::string& name : relative_engine_names()) {
    EngineChoice choice = options.engine.choice;
    choice.name = name;
    engines.push_back(make_engine(compilation, choice));
    engines.back().set_inputs(inputs);
  }
  const Engine& reference = engines.back();
  std::vector<FileState> states = options.states.empty() ? random_states(compilation, reference, inputs)
                                                         : read_states(options.states, compilation, inputs).states;
  if (states.empty()) throw UserError(fmt::format("{}: has no states\n", options.states));
  complete(states, reference, compilation.topology);
  std::vector<LoadedState> at;
  for (const FileState& state : states) at.push_back(state.at);
  std::vector<Measurement> measurements = measure(engines, at);
  for (Measurement& measurement : measurements) {
    measurement.largest_error = largest_error(*measurement.engine, compilation.topology, states);
  }
  const std::string& name = compilation.model.name;
  print(options.json ? to_json(name, measurements) : to_text(name, measurements));
  return kDone;
}

}  // namespace

void add_bench(CLI::App& application, int& exit_code) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = application.add_subcommand("bench", "measure the time of one evaluation, per engine");
  command->footer(fmt::format(
      "Example: mbgen bench models/coach_mechanism.json --json\n"
      "The engines take {} turns of {} ms at the same states; the time is the median, the spread the distance of the\n"
      "quartiles over it, the error that to the \"zdd\" of the states, or to the generic engine where there are none.",
      kTurns, 1000 * kTurnSeconds));
  add_model_argument(*command, options->model);
  command->add_option("--states", options->states, "file of states as for evaluate (default: random consistent ones)");
  add_run_options(*command, options->engine);
  add_json_option(*command, options->json);
  command->callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace mbgen::cli
