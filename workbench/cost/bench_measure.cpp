#include "workbench/cost/bench_measure.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace mbgen {
namespace {

constexpr double kShortestTurn = 0.002;  // s; shorter ones drown in the clock and in interrupts
constexpr double kSlowBudget = 1;        // s for all turns of a slow engine
constexpr int kClockedTurns = 5;

double seconds_for(const Engine& engine, const std::vector<LoadedState>& states, int repetitions) {
  const auto start = std::chrono::steady_clock::now();
  engine.time_accelerations(states, repetitions);
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Work of one engine in each of its turns.
struct Plan {
  int turns = kTurns;
  std::size_t states = 0;  ///< of all states, going round from turn to turn
  int repetitions = 1;
};

Plan plan_for(const Engine& engine, const std::vector<LoadedState>& states, long long evaluations) {
  const std::vector<LoadedState> one(states.begin(), states.begin() + 1);
  seconds_for(engine, one, 1);  // warm
  const double each = seconds_for(engine, one, 1);
  if (each * static_cast<double>(evaluations) > kLongestMeasurement) {
    const double in_turn = std::floor(kSlowBudget / kTurnsOfSlowEngines / each);
    const double count = std::clamp(in_turn, 1.0, static_cast<double>(states.size()));
    return {kTurnsOfSlowEngines, static_cast<std::size_t>(count), 1};
  }
  const double round = static_cast<double>(states.size());
  const double wanted = std::ceil(static_cast<double>(evaluations) / (kTurns * round));
  const double measured = seconds_for(engine, states, 1);
  const double filling = std::ceil(kShortestTurn / std::max(measured, 1e-9));
  return {kTurns, states.size(), static_cast<int>(std::max(wanted, filling))};
}

std::vector<LoadedState> states_of_turn(const Plan& plan, const std::vector<LoadedState>& states, int turn) {
  std::vector<LoadedState> chosen;
  for (std::size_t i = 0; i < plan.states; ++i) {
    chosen.push_back(states[(static_cast<std::size_t>(turn) * plan.states + i) % states.size()]);
  }
  return chosen;
}

std::array<double, kSteps> steps_of(const Engine& engine, const Plan& plan, const std::vector<LoadedState>& states,
                                    double microseconds) {
  std::array<double, kSteps> steps{};
  for (int turn = 0; turn < kClockedTurns; ++turn) {
    const std::array<double, kSteps> shares =
        engine.step_shares(states_of_turn(plan, states, turn), std::max(1, plan.repetitions / kClockedTurns));
    for (int s = 0; s < kSteps; ++s) steps[s] += shares[s] * microseconds / kClockedTurns;
  }
  return steps;
}

}  // namespace

std::vector<Measurement> measure(const std::vector<Engine>& engines, const std::vector<LoadedState>& states,
                                 long long evaluations) {
  std::vector<Plan> plans;
  std::vector<std::vector<double>> microseconds(engines.size());
  for (const Engine& engine : engines) plans.push_back(plan_for(engine, states, evaluations));
  for (int turn = 0; turn < kTurns; ++turn) {
    for (std::size_t e = 0; e < engines.size(); ++e) {
      if (turn >= plans[e].turns) continue;
      const std::vector<LoadedState> at = states_of_turn(plans[e], states, turn);
      const double count = static_cast<double>(plans[e].repetitions) * static_cast<double>(at.size());
      microseconds[e].push_back(1e6 * seconds_for(engines[e], at, plans[e].repetitions) / count);
    }
  }
  std::vector<Measurement> measurements;
  for (std::size_t e = 0; e < engines.size(); ++e) {
    std::vector<double>& sorted = microseconds[e];
    std::sort(sorted.begin(), sorted.end());
    const std::size_t turns = sorted.size();
    Measurement m;
    m.engine = &engines[e];
    m.evaluations = static_cast<long long>(plans[e].states) * plans[e].repetitions * plans[e].turns;
    m.microseconds = sorted[turns / 2];
    m.spread = (sorted[3 * turns / 4] - sorted[turns / 4]) / m.microseconds;
    if (engines[e].step_shares) m.steps = steps_of(engines[e], plans[e], states, m.microseconds);
    measurements.push_back(m);
  }
  return measurements;
}

}  // namespace mbgen
