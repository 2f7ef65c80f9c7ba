#pragma once
// Coordinates that turn farther within a step than the method's limit: the method then resolves too few directions of
// their forces.

#include <cmath>
#include <cstddef>

#include "mbgen/lanes/array_lanes.hpp"
#include "mbgen/number.hpp"
#include "mbgen/status.hpp"

namespace mbgen {

/// Largest rotation within a step, rad, of each method: forces that turn with a body then have an error of 0.1 %.
/// Measured with an unbalanced rotor on a spring, see docs/use/numerical_trouble.md and tests/cli/resolved_test.cpp.
constexpr double kRk4Turn = 0.5, kAbm4Turn = 0.3, kRosenbrockTurn = 0.3;

namespace turns_detail {

/// Sum of the squares of zd where turning is 1.
template <class Real, std::size_t N>
[[gnu::always_inline]] inline Real squares(const Real (&zd)[N], const Real (&turning)[N]) noexcept {
  using namespace array_detail;
  constexpr int width = width_for<Real>(N);
  constexpr int whole = static_cast<int>(N) / width * width;
  LanesOf<width, Real> lanes = {};
  for (int i = 0; i < whole; i += width) {
    const LanesOf<width, Real> rates = lanes_at<width>(zd + i) * lanes_at<width>(turning + i);
    lanes += rates * rates;
  }
  Real sum = 0;
  for (int lane = 0; lane < width; ++lane) sum += lane_of(lanes, lane);
  for (int i = whole; i < static_cast<int>(N); ++i) sum += turning[i] * zd[i] * zd[i];
  return sum;
}

}  // namespace turns_detail

/// Status of a step of h seconds that led to the rates zd, or turned_far in place of ok if a coordinate turns farther
/// in the step than `largest`, rad. turning: 1 for the coordinates to be checked, else 0.
template <class Real, std::size_t N>
[[gnu::always_inline]] inline Status with_turns(Status stepped, const Real (&zd)[N], const Real (&turning)[N], double h,
                                                double largest) noexcept {
  const auto rate = static_cast<Real>(largest / h);
  if (turns_detail::squares(zd, turning) <= rate * rate || stepped.code != Code::ok) return stepped;
  std::size_t fastest = 0;
  for (std::size_t i = 1; i < N; ++i) {
    if (magnitude(turning[i] * zd[i]) > magnitude(turning[fastest] * zd[fastest])) fastest = i;
  }
  if (!(magnitude(turning[fastest] * zd[fastest]) > rate)) return stepped;
  return {Code::turned_far, static_cast<int>(fastest)};
}

/// Turns of a coordinate, rad, at which accelerations are compared: no body looks the same at all of them but one that
/// is symmetric about the axis.
constexpr double kTriedTurns[] = {0.7, 1.9, 3.3};

/// Whether a rotation changes an acceleration by more than rounding, relative to all accelerations and the square of
/// the rate of the coordinate, 1/s. here, there: before and after it.
inline bool differ_by_turn(const double* here, const double* there, int count, double rate) noexcept {
  constexpr double kMatters = 1e-4, kRounding = 1e-9;
  double largest = 0;
  for (int i = 0; i < count; ++i) largest = std::fmax(largest, magnitude(here[i]));
  const double rounding = kRounding * (rate * rate + largest);
  for (int i = 0; i < count; ++i) {
    const double size = std::fmax(magnitude(here[i]), magnitude(there[i]));
    if (magnitude(here[i] - there[i]) > kMatters * size + rounding) return true;
  }
  return false;
}

}  // namespace mbgen
