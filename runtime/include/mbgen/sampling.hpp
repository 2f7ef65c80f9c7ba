#pragma once
// Instants at which sampled values are set: t = 0, period, 2 period, ... A step that begins at one sets them first.
// Steps of fixed size must meet the instants; variable steps are cut there (next_instant).

#include <cmath>

#include "mbgen/number.hpp"
#include "mbgen/status.hpp"

namespace mbgen {

/// Periods that differ by this part from a multiple of the step are one: people type periods as decimals.
constexpr double kSamePeriod = 1e-9;
/// A step begins at a multiple of its size where it is nearer to it than by this part of the size: times add up
/// roundings over many steps.
constexpr double kSameInstant = 0.25;

/// s around t that count as t, where steps are cut at the instants.
inline double same_instant(double t) noexcept { return 1e-9 + 1e-12 * std::abs(t); }

/// The next instant of any of `count` values after times equal to t, s; infinite without values.
inline double next_instant(const double* periods, int count, double t) noexcept {
  double next = HUGE_VAL;
  for (int i = 0; i < count; ++i)
    next = std::fmin(next, periods[i] * (std::floor((t + same_instant(t)) / periods[i]) + 1));
  return next;
}

/// Marks which of `count` values are due at the time t, for any steps that are cut at the instants: 1 in `due`, else 0.
template <class Real>
bool find_due_now(const double* periods, int count, double t, Real* due) noexcept {
  bool any = false;
  for (int i = 0; i < count; ++i) {
    const bool is_due = std::abs(t - periods[i] * std::nearbyint(t / periods[i])) <= same_instant(t);
    due[i] = is_due ? Real(1) : Real(0);
    any = any || is_due;
  }
  return any;
}

/// Which of `count` values are due at the start of a step of h seconds at the time t: 1 in `due`, else 0. With h = 0 it
/// is one of steps that are cut at the instants.
/// periods: s. first: index of the first value among the auxiliary states, for the status.
/// Fails: sample_inside_step where an instant may lie within a step: the period is no multiple of h, or t is not.
template <class Real>
Status find_due(const double* periods, int count, int first, double t, double h, Real* due, bool& any) noexcept {
  any = false;
  if (h == 0) {
    any = find_due_now(periods, count, t, due);
    return {};
  }
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
    if (!is_finite(held[i])) return {Code::auxiliary_not_a_number, first + i};
  }
  for (int i = 0; i < count; ++i) x[first + i] = held[i];
  return {};
}

}  // namespace mbgen
