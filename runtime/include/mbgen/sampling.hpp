#pragma once
// Instants at which sampled values are set: t = 0, period, 2 period, ... A step that begins at one sets them first.

#include <cmath>

#include "mbgen/status.hpp"

namespace mbgen {

/// Periods that differ by this part from a multiple of the step are one: people type periods as decimals.
constexpr double kSamePeriod = 1e-9;
/// A step begins at a multiple of its size where it is nearer to it than by this part of the size: times add up
/// roundings over many steps.
constexpr double kSameInstant = 0.25;

/// Which of `count` values are due at the start of a step of h seconds at the time t: 1 in `due`, else 0.
/// periods: s. first: index of the first value among the auxiliary states, for the status.
/// Fails: sample_inside_step where an instant may lie within a step: the period is no multiple of h, or t is not.
template <class Real>
Status find_due(const double* periods, int count, int first, double t, double h, Real* due, bool& any) noexcept {
  any = false;
  const double steps = t / h, nearest = std::nearbyint(steps);
  const bool is_on_grid = std::abs(steps - nearest) <= kSameInstant;
  for (int i = 0; i < count; ++i) {
    const double ratio = periods[i] / h, whole = std::nearbyint(ratio);
    const bool is_multiple = whole >= 1 && std::abs(ratio - whole) <= kSamePeriod * whole;
    if (!is_on_grid || !is_multiple) return {Code::sample_inside_step, first + i};
    const bool is_due = std::fmod(nearest, whole) == 0;
    due[i] = is_due ? Real(1) : Real(0);
    any = any || is_due;
  }
  return {};
}

/// Puts the values that hold into the auxiliary states, from the first of them on.
/// Fails: auxiliary_not_a_number; the states are then unchanged.
template <class Real>
Status take_held(const Real* held, int count, int first, Real* x) noexcept {
  for (int i = 0; i < count; ++i) {
    if (!std::isfinite(held[i])) return {Code::auxiliary_not_a_number, first + i};
  }
  for (int i = 0; i < count; ++i) x[first + i] = held[i];
  return {};
}

}  // namespace mbgen
