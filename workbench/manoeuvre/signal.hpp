#pragma once
// Signals over time as sums of parts with known first and second derivatives.

#include <array>
#include <functional>
#include <limits>
#include <vector>

namespace mbgen {

/// A value with its first and second time derivative.
struct Rates {
  double value = 0, rate = 0, acceleration = 0;
};

/// A sum of parts; without any it is zero.
struct Signal {
  struct Part {
    std::function<Rates(double t)> rates;
    double end = std::numeric_limits<double>::infinity();  ///< s: from there on it has the value `held`
    double held = 0;
  };
  std::vector<Part> parts;

  Rates at(double t) const;
  /// Adds a constant.
  void add(double value);
  /// Adds `change` from the instant `at` on, over some seconds as 10 u^3 - 15 u^4 + 6 u^5: the second derivative is
  /// continuous, and the largest rate is kSmoothRate change / over.
  void add_change(double change, double at, double over);
  /// Adds the change from the present value to a final one; earlier parts that still move end at its begin.
  void go_to(double value, double at, double over);
  /// Adds a change at a constant rate; it begins and ends within a second.
  void add_ramp(double change, double at, double rate);
  /// Adds cycles of a sine; the number need not be whole.
  void add_sine(double amplitude, double at, double frequency, double cycles);
  /// Adds one cycle of a sine that rests for `dwell` seconds at its second peak.
  void add_sine_with_dwell(double amplitude, double at, double frequency, double dwell);
  /// Adds a sine with exponentially growing frequency over `duration`; its amplitude grows during the first cycle and
  /// falls behind the last one, for the time of sweep_fade.
  void add_sweep(double amplitude, double at, double first_frequency, double last_frequency, double duration);
  /// Adds PCHIP interpolation of points, times since `at`; zero until then.
  void add_table(const std::vector<std::array<double, 2>>& points, double at);
};

constexpr double kSmoothRate = 1.875;

/// Time in which the amplitude of a sweep falls to zero, s: a cycle.
inline double sweep_fade(double last_frequency) { return 1 / last_frequency; }

/// 10 u^3 - 15 u^4 + 6 u^5 and its derivatives by u, constant outside 0 to 1.
Rates smooth_step(double u);

}  // namespace mbgen
