#include "bench/compare/rounds.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>

namespace mbgen::compare {
namespace {

/// Time of the processor, not of the clock on the wall: other programs get their share between two of our instructions.
double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

double seconds_for(const Contestant& contestant, const std::vector<LoadedState>& states, int repetitions) {
  const double start = processor_seconds();
  contestant.engine.time_accelerations(states, repetitions);
  return processor_seconds() - start;
}

/// Repetitions that take about `seconds`; the contestant is warm after it.
int repetitions_for(const Contestant& contestant, const std::vector<LoadedState>& states, double seconds) {
  contestant.engine.time_accelerations(states, 0);
  int repetitions = 1;
  for (double taken = 0; (taken = seconds_for(contestant, states, repetitions)) < seconds;) {
    const double factor = std::clamp(1.1 * seconds / std::max(taken, 1e-9), 1.1, 100.0);
    repetitions = static_cast<int>(std::ceil(repetitions * factor));
  }
  return repetitions;
}

Spread spread_of(std::vector<double> values) {
  if (values.empty()) return {};
  std::sort(values.begin(), values.end());
  return {values.front(), values[values.size() / 2], values.back()};
}

}  // namespace

std::vector<Timing> time_in_turns(const std::vector<Contestant>& contestants, const std::vector<LoadedState>& states,
                                  int rounds, double seconds) {
  std::vector<int> repetitions;
  for (const Contestant& c : contestants)
    repetitions.push_back(c.absent.empty() ? repetitions_for(c, states, seconds) : 0);
  std::vector<std::vector<double>> microseconds(contestants.size()), ratios(contestants.size());
  for (int round = 0; round < rounds; ++round) {
    for (std::size_t c = 0; c < contestants.size(); ++c) {
      if (repetitions[c] == 0) continue;
      const double count = static_cast<double>(repetitions[c]) * static_cast<double>(states.size());
      microseconds[c].push_back(1e6 * seconds_for(contestants[c], states, repetitions[c]) / count);
      ratios[c].push_back(microseconds[c].back() / microseconds[0].back());
    }
  }
  std::vector<Timing> timings;
  for (std::size_t c = 0; c < contestants.size(); ++c) {
    const int evaluations = repetitions[c] * static_cast<int>(states.size()) * rounds;
    timings.push_back({spread_of(microseconds[c]), spread_of(ratios[c]), evaluations});
  }
  return timings;
}

}  // namespace mbgen::compare
