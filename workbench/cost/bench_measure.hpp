#pragma once
// Fair times: the engines take turns at the same states, and the median of the turns counts.

#include <optional>
#include <vector>

#include "workbench/engines/engine.hpp"

namespace mbgen {

struct Measurement {
  const Engine* engine = nullptr;
  long long evaluations = 0;
  double microseconds = 0;   ///< of one evaluation, median over the turns
  double spread = 0;         ///< distance of the quartiles over the median
  double largest_error = 0;  ///< see largest_error
  /// Microseconds in each of the nine steps: the shares by the step clock of the whole as timed without it.
  std::optional<std::array<double, kSteps>> steps;
};

/// Turns that an engine takes, unless it is slow.
constexpr int kTurns = 20;
constexpr int kTurnsOfSlowEngines = 5;
/// An engine that would take longer than this for all evaluations gets fewer, in fewer turns.
constexpr double kLongestMeasurement = 8;  // s

/// Times every engine. evaluations: at least so many of each engine that is not slow. Result: in the engines' order.
std::vector<Measurement> measure(const std::vector<Engine>& engines, const std::vector<LoadedState>& states,
                                 long long evaluations);

}  // namespace mbgen
