// The elementary functions in single precision against those of the C library in double precision: errors in units of
// the last place, as docs/method/arithmetic.md promises them.

#include "mbgen/elementary.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace {

constexpr int kCount = 400000;

double unit_of(double value) {
  int exponent = 0;
  std::frexp(value, &exponent);
  return std::ldexp(1.0, std::max(exponent - 24, -149));
}

/// Arguments from first to last at equal distances, or of equal quotients. least: errors below count as this unit.
template <class Function, class Right>
int check(const char* name, double bound, Function function, Right right, double first, double last, bool quotients,
          double least = 0) {
  double worst = 0;
  for (int i = 0; i <= kCount; ++i) {
    const double part = static_cast<double>(i) / kCount;
    const double argument = quotients ? first * std::pow(last / first, part) : first + part * (last - first);
    const float x = static_cast<float>(argument);
    const double value = right(static_cast<double>(x));
    const double error = std::abs(static_cast<double>(function(x)) - value) / std::max(unit_of(value), least);
    if (!(error <= worst)) worst = error;
  }
  if (!(worst <= bound)) std::printf("%s: %.3f units of the last place, %g are allowed\n", name, worst, bound);
  return worst <= bound ? 0 : 1;
}

}  // namespace

int main() {
  using F = float;
  const double nearly_zero = std::ldexp(1.0, -33);
  int wrong = 0;
  const auto sine = [](F x) { return mbgen::sine(x); };
  const auto cosine = [](F x) { return mbgen::cosine(x); };
  const auto right_sine = [](double x) { return std::sin(x); };
  const auto right_cosine = [](double x) { return std::cos(x); };
  wrong += check("sine", 1, sine, right_sine, -10, 10, false, nearly_zero);
  wrong += check("sine of large angles", 1, sine, right_sine, -32768, 32768, false, nearly_zero);
  wrong += check("cosine of large angles", 1, cosine, right_cosine, -32768, 32768, false, nearly_zero);
  wrong += check("sine beyond", 1, sine, right_sine, 40000, 1e9f, true);
  const auto arc = [](F x) { return mbgen::arc_tangent(x); };
  wrong += check(
      "arc tangent", 1.5, arc, [](double x) { return std::atan(x); }, 1e-30f, 1e30f, true);
  wrong += check(
      "direction", 2, [](F x) { return mbgen::arc_tangent(x, -0.75f); }, [](double x) { return std::atan2(x, -0.75); },
      -20, 20, false);
  wrong += check(
      "arc sine", 3, [](F x) { return mbgen::arc_sine(x); }, [](double x) { return std::asin(x); }, -1, 1, false);
  wrong += check(
      "exponential", 1, [](F x) { return mbgen::exponential(x); }, [](double x) { return std::exp(x); }, -103, 88.5f,
      false);
  wrong += check(
      "hyperbolic tangent", 1.5, [](F x) { return mbgen::hyperbolic_tangent(x); },
      [](double x) { return std::tanh(x); }, 1e-30f, 30, true);
  wrong += check(
      "logarithm", 1, [](F x) { return mbgen::logarithm(x); }, [](double x) { return std::log(x); }, 1e-37f, 1e37f,
      true);
  wrong += check(
      "power", 2, [](F x) { return mbgen::power(x, 1.25f); }, [](double x) { return std::pow(x, 1.25); }, 1e-5f, 1e5f,
      true);
  std::printf("elementary functions: 11 ranges, %d wrong\n", wrong);
  return wrong == 0 ? 0 : 1;
}
