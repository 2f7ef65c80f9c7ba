#pragma once
// Products in sums, rounded once where the processor can: code that calls these has the same bits on every compiler.
// Without such an instruction product and sum are rounded each, for lanes as for doubles. Names as of the instructions.

namespace mbgen {

/// a b + c. clang 14 does not define the macro that g++ has for this.
inline double fma(double a, double b, double c) noexcept {
#if defined(__FP_FAST_FMA) || defined(__FMA__) || defined(__aarch64__)
  return __builtin_fma(a, b, c);
#else
  return a * b + c;
#endif
}

/// a b - c.
inline double fms(double a, double b, double c) noexcept { return mbgen::fma(a, b, -c); }

/// c - a b.
inline double fnma(double a, double b, double c) noexcept { return mbgen::fma(-a, b, c); }

}  // namespace mbgen
