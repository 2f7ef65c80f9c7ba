#pragma once
// Products in sums, rounded once where the processor can: code that calls these has the same bits on every compiler.
// Without such an instruction product and sum are rounded each, for lanes as for doubles.

namespace mbgen {

/// a b + c. clang 14 does not define the macro that g++ has for this.
inline double multiply_add(double a, double b, double c) noexcept {
#if defined(__FP_FAST_FMA) || defined(__FMA__) || defined(__aarch64__)
  return __builtin_fma(a, b, c);
#else
  return a * b + c;
#endif
}

/// a b - c.
inline double multiply_subtract(double a, double b, double c) noexcept { return multiply_add(a, b, -c); }

/// c - a b.
inline double subtract_product(double c, double a, double b) noexcept { return multiply_add(-a, b, c); }

}  // namespace mbgen
