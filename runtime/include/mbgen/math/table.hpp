#pragma once
// Characteristics given by points: piecewise linear and monotone cubic, over a scalar T for the argument.
// Points are constants; the argument chooses its segment by a chain of selects, so that a symbolic T can pass.

#include "mbgen/scalar.hpp"

namespace mbgen {

/// y at the argument, straight between the points; the end segments continue as straight lines.
/// x, y: count points, any units. Requires: x strictly increasing, count >= 2. Cost: linear in count.
template <class T>
T interpolate_linear(const double* x, const double* y, int count, T argument) {
  T result = T(y[0]) + (y[1] - y[0]) / (x[1] - x[0]) * (argument - x[0]);
  for (int i = 1; i + 1 < count; ++i) {
    const double slope = (y[i + 1] - y[i]) / (x[i + 1] - x[i]);
    const T offset = argument - x[i];
    result = select(offset, T(y[i] + slope * offset), result);
  }
  return result;
}

/// Slopes for interpolate_monotone_cubic: of the parabola through three neighbours, of the end segments at the ends;
/// zero at a turn of the data, and at most three times the gentler neighbouring secant, so that the curve rises and
/// falls only where the points do. slopes: receives count values, units of y over units of x.
/// Requires: x strictly increasing, count >= 2.
/// Source: F. N. Fritsch, R. E. Carlson, "Monotone Piecewise Cubic Interpolation", SIAM J. Numer. Anal. 17(2), 1980,
/// with the square [0, 3] x [0, 3] of their monotonicity region.
constexpr void monotone_slopes(const double* x, const double* y, int count, double* slopes) noexcept {
  double width = x[1] - x[0];
  double secant = (y[1] - y[0]) / width;
  slopes[0] = secant;
  for (int i = 1; i + 1 < count; ++i) {
    const double next_width = x[i + 1] - x[i];
    const double next_secant = (y[i + 1] - y[i]) / next_width;
    const double limit = 3 * min(abs(secant), abs(next_secant));
    const double parabola = (next_width * secant + width * next_secant) / (width + next_width);
    const bool turns = (secant > 0) != (next_secant > 0);
    slopes[i] = turns ? 0.0 : max(-limit, min(parabola, limit));
    width = next_width;
    secant = next_secant;
  }
  slopes[count - 1] = secant;
}

/// y at the argument, by a cubic between neighbouring points with the given slopes; straight beyond the ends.
/// x, y, slopes: count points, slopes from monotone_slopes. Requires: x strictly increasing, count >= 2.
/// Continuous with its first derivative. Cost: linear in count.
template <class T>
T interpolate_monotone_cubic(const double* x, const double* y, const double* slopes, int count, T argument) {
  T result = T(y[0]) + slopes[0] * (argument - x[0]);
  for (int i = 0; i + 1 < count; ++i) {
    const double width = x[i + 1] - x[i];
    const double secant = (y[i + 1] - y[i]) / width;
    const double second = (3 * secant - 2 * slopes[i] - slopes[i + 1]) / width;
    const double third = (slopes[i] + slopes[i + 1] - 2 * secant) / (width * width);
    const T offset = argument - x[i];
    result = select(offset, T(y[i] + offset * (slopes[i] + offset * (second + offset * third))), result);
  }
  const T beyond = argument - x[count - 1];
  return select(beyond, T(y[count - 1] + slopes[count - 1] * beyond), result);
}

}  // namespace mbgen
