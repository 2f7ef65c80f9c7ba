#pragma once
// The steps of a run: how many fit into a time, and the time after each. Times are the start and a multiple of the
// step, not a sum of steps, so that rounding does not add up.

#include <cmath>

namespace mbgen {

/// Equal steps.
struct Steps {
  double count, size;
};

/// Steps of the given size where a whole number of them fits up to 1e-6 of one, or 1e-9 of all; else of the next
/// smaller equal ones. Requires: both positive and finite.
inline Steps steps_in(double interval, double step) noexcept {
  const double exact = interval / step, nearest = std::floor(exact + 0.5);
  if (nearest >= 1 && std::abs(exact - nearest) <= std::fmax(1e-6, 1e-9 * nearest)) return {nearest, step};
  const double count = std::floor(exact) + 1;
  return {count, interval / count};
}

/// Time after so many steps from the start.
inline double time_after(double start, double count, double step) noexcept { return start + count * step; }

/// A time that is a whole number of steps from the start but for rounding (1e-6 of a step): that multiple; else t.
inline double at_whole_steps(double start, double t, double step) noexcept {
  const double whole = time_after(start, std::floor((t - start) / step + 0.5), step);
  return std::abs(whole - t) <= 1e-6 * step ? whole : t;
}

}  // namespace mbgen
