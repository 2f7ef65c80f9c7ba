#include "workbench/cost/bench_states.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <random>

#include "compiler/text/user_error.hpp"
#include "workbench/start/initial_state.hpp"

namespace mbgen {
namespace {

constexpr int kStates = 20;
constexpr int kTries = 20 * kStates;      // random states that may fail to close before the model is given up
constexpr double kPositionSpread = 0.05;  // rad or m around the initial state
constexpr double kVelocitySpread = 0.5;   // rad/s or m/s
constexpr double kForceSpread = 100;      // N or N m

/// Uniform in [-1, 1), the same numbers on every machine.
double uniform(std::mt19937& generator) { return static_cast<double>(generator()) / 2147483648.0 - 1.0; }

std::vector<double> accelerations_at(const Engine& engine, const Compilation& compilation, const LoadedState& at) {
  GenericDerivative derivative;
  const Status status = engine.accelerations(at, derivative);
  if (!status.ok()) {
    throw UserError(
        fmt::format("bench: engine {} has no accelerations: {}\n", engine.name, describe(compilation, status)));
  }
  return derivative.zdd;
}

}  // namespace

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

void complete(std::vector<FileState>& states, const Engine& reference, const Compilation& compilation) {
  for (FileState& state : states) {
    if (state.zdd.empty()) state.zdd = accelerations_at(reference, compilation, state.at);
  }
}

std::vector<LoadedState> timed_states(const std::vector<FileState>& states, int lanes) {
  const std::size_t batch = static_cast<std::size_t>(std::max(lanes, 1));
  const std::size_t count = (states.size() + batch - 1) / batch * batch;
  std::vector<LoadedState> timed;
  for (std::size_t k = 0; k < count; ++k) timed.push_back(states[k % states.size()].at);
  return timed;
}

double largest_error(const Engine& engine, const Compilation& compilation, const std::vector<FileState>& states) {
  double largest = 0;
  for (const FileState& state : states) {
    std::vector<double> difference = accelerations_at(engine, compilation, state.at);
    for (std::size_t i = 0; i < difference.size(); ++i) difference[i] -= state.zdd[i];
    const double scale = largest_absolute(state.zdd);
    largest = std::max(largest, scale > 0 ? largest_absolute(difference) / scale : largest_absolute(difference));
  }
  return largest;
}

}  // namespace mbgen
