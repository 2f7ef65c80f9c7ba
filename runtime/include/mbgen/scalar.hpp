#pragma once
// The scalar functions that force laws use beyond <cmath>, for double, float and long double (which checks use). The
// symbolic scalar of the compiler brings its own by argument-dependent lookup, so a law written with `using`
// declarations serves both.

#include <cmath>

namespace mbgen {

/// a where condition >= 0, else b (b for NaN). Laws use it in place of comparisons, which a symbolic scalar lacks.
constexpr double select(double condition, double a, double b) noexcept { return condition >= 0 ? a : b; }
constexpr float select(float condition, float a, float b) noexcept { return condition >= 0 ? a : b; }
constexpr long double select(long double condition, long double a, long double b) noexcept {
  return condition >= 0 ? a : b;
}

/// The smaller of two; the first when they are equal or not comparable.
constexpr double min(double a, double b) noexcept { return b < a ? b : a; }
constexpr float min(float a, float b) noexcept { return b < a ? b : a; }
constexpr long double min(long double a, long double b) noexcept { return b < a ? b : a; }

/// The larger of two; the first when they are equal or not comparable.
constexpr double max(double a, double b) noexcept { return a < b ? b : a; }
constexpr float max(float a, float b) noexcept { return a < b ? b : a; }
constexpr long double max(long double a, long double b) noexcept { return a < b ? b : a; }

/// Absolute value.
constexpr double abs(double a) noexcept { return a < 0 ? -a : (a == 0 ? 0.0 : a); }
constexpr float abs(float a) noexcept { return a < 0 ? -a : (a == 0 ? 0.0f : a); }
constexpr long double abs(long double a) noexcept { return a < 0 ? -a : (a == 0 ? 0.0L : a); }

}  // namespace mbgen
