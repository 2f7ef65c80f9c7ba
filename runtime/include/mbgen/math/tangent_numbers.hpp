#pragma once
// Numbers with derivatives in several directions at once, exact to rounding: a solver that computes with them gives the
// derivatives of everything that it computes, of whole motions too. Comparisons, and with them the way through
// iterations, pivoting and steps, are those of the values. Source: A. Griewank, A. Walther, Evaluating Derivatives,
// 2nd ed., SIAM 2008, section 3.1 (forward mode, vector mode).

#include <cmath>
#include <limits>
#include <type_traits>

#include "mbgen/fma.hpp"
#include "mbgen/number.hpp"

namespace mbgen {

/// Vector of N derivatives.
template <int N>
struct DirectionTypes {
  typedef double Vector __attribute__((vector_size(8 * N)));
};

/// A value, and its derivatives in N directions: by whatever the caller has set tangents of 1 in arguments. Aligned as
/// a vector of AVX-512 on every processor: no load meets two lines of a cache, and all code agrees on the layout.
template <int N>
struct alignas(8 * N) Tangents {
  using Vector = typename DirectionTypes<N>::Vector;

  double value;
  Vector tangent;

  Tangents() = default;
  /// A constant.
  constexpr Tangents(double number) noexcept : value(number), tangent{} {}  // NOLINT: as numbers convert
  constexpr Tangents(double number, const Vector& derivatives) noexcept : value(number), tangent(derivatives) {}

  explicit constexpr operator double() const noexcept { return value; }

  /// The value with a derivative of 1 in this direction, 0 <= direction < N.
  static Tangents along(double number, int direction) noexcept {
    Tangents result(number);
    result.tangent[direction] = 1;
    return result;
  }

  Tangents& operator+=(const Tangents& b) noexcept { return *this = *this + b; }
  Tangents& operator-=(const Tangents& b) noexcept { return *this = *this - b; }
  Tangents& operator*=(const Tangents& b) noexcept { return *this = *this * b; }
  Tangents& operator/=(const Tangents& b) noexcept { return *this = *this / b; }

  friend constexpr Tangents operator-(const Tangents& a) noexcept { return {-a.value, -a.tangent}; }
  friend constexpr Tangents operator+(const Tangents& a) noexcept { return a; }

  friend constexpr Tangents operator+(const Tangents& a, const Tangents& b) noexcept {
    return {a.value + b.value, a.tangent + b.tangent};
  }
  friend constexpr Tangents operator+(const Tangents& a, double b) noexcept { return {a.value + b, a.tangent}; }
  friend constexpr Tangents operator+(double a, const Tangents& b) noexcept { return {a + b.value, b.tangent}; }

  friend constexpr Tangents operator-(const Tangents& a, const Tangents& b) noexcept {
    return {a.value - b.value, a.tangent - b.tangent};
  }
  friend constexpr Tangents operator-(const Tangents& a, double b) noexcept { return {a.value - b, a.tangent}; }
  friend constexpr Tangents operator-(double a, const Tangents& b) noexcept { return {a - b.value, -b.tangent}; }

  friend constexpr Tangents operator*(const Tangents& a, const Tangents& b) noexcept {
    return {a.value * b.value, a.value * b.tangent + b.value * a.tangent};
  }
  friend constexpr Tangents operator*(const Tangents& a, double b) noexcept { return {a.value * b, a.tangent * b}; }
  friend constexpr Tangents operator*(double a, const Tangents& b) noexcept { return {a * b.value, a * b.tangent}; }

  friend constexpr Tangents operator/(const Tangents& a, const Tangents& b) noexcept {
    const double quotient = a.value / b.value;
    return {quotient, (a.tangent - quotient * b.tangent) * (1 / b.value)};
  }
  friend constexpr Tangents operator/(const Tangents& a, double b) noexcept { return {a.value / b, a.tangent / b}; }
  friend constexpr Tangents operator/(double a, const Tangents& b) noexcept {
    const double quotient = a / b.value;
    return {quotient, b.tangent * (-quotient / b.value)};
  }

  friend constexpr bool operator<(const Tangents& a, const Tangents& b) noexcept { return a.value < b.value; }
  friend constexpr bool operator>(const Tangents& a, const Tangents& b) noexcept { return a.value > b.value; }
  friend constexpr bool operator<=(const Tangents& a, const Tangents& b) noexcept { return a.value <= b.value; }
  friend constexpr bool operator>=(const Tangents& a, const Tangents& b) noexcept { return a.value >= b.value; }
  friend constexpr bool operator==(const Tangents& a, const Tangents& b) noexcept { return a.value == b.value; }
  friend constexpr bool operator!=(const Tangents& a, const Tangents& b) noexcept { return a.value != b.value; }
};

template <int N>
inline constexpr bool kIsNumber<Tangents<N>> = true;

template <int N>
[[gnu::always_inline]] inline Tangents<N> magnitude(const Tangents<N>& x) noexcept {
  return x.value < 0 ? -x : x;
}
/// Whether value and derivatives are.
template <int N>
[[gnu::always_inline]] inline bool is_finite(const Tangents<N>& x) noexcept {
  double total = x.value * 0;
  for (int k = 0; k < N; ++k) total += x.tangent[k] * 0;
  return total == 0;
}
template <int N>
[[gnu::always_inline]] inline bool is_nan(const Tangents<N>& x) noexcept {
  return std::isnan(x.value);
}

/// Share of the largest derivative of the coordinates in a direction that a step of Newton's method may still change:
/// the next step changes it by the square.
constexpr double kSettledDerivatives = 1e-9;

template <int N>
inline bool keeps_derivatives(const Tangents<N>* step, const Tangents<N>* coordinates, int count) noexcept {
  typename Tangents<N>::Vector change{}, largest{};
  for (int i = 0; i < count; ++i) {
    const typename Tangents<N>::Vector by = step[i].tangent, of = coordinates[i].tangent;
    const auto size_by = by < 0 ? -by : by, size_of = of < 0 ? -of : of;
    change = size_by > change ? size_by : change;
    largest = size_of > largest ? size_of : largest;
  }
  for (int k = 0; k < N; ++k)
    if (change[k] > kSettledDerivatives * largest[k]) return false;
  return true;
}

// --- products in sums ---

namespace tangent_detail {

constexpr double value_of(double a) noexcept { return a; }
template <int N>
constexpr double value_of(const Tangents<N>& a) noexcept {
  return a.value;
}

/// sum + factor times the derivatives of x; a plain number has none.
template <class Vector>
[[gnu::always_inline]] inline Vector plus(const Vector& sum, double /*factor*/, double /*x*/) noexcept {
  return sum;
}
template <class Vector, int N>
[[gnu::always_inline]] inline Vector plus(const Vector& sum, double factor, const Tangents<N>& x) noexcept {
  return lanes_detail::fused(lanes_detail::all<Vector>(factor), Vector(x.tangent), sum);
}

template <class Vector>
[[gnu::always_inline]] inline Vector derivatives(double /*x*/) noexcept {
  return Vector{};
}
template <class Vector, int N>
[[gnu::always_inline]] inline Vector derivatives(const Tangents<N>& x) noexcept {
  return x.tangent;
}

/// Directions of the numbers with derivatives among types, 0 for none.
template <class T>
inline constexpr int kDirectionsOf = 0;
template <int N>
inline constexpr int kDirectionsOf<Tangents<N>> = N;
template <class... Types>
constexpr int most_directions() noexcept {
  int most = 0;
  ((most = kDirectionsOf<Types> > most ? kDirectionsOf<Types> : most), ...);
  return most;
}

}  // namespace tangent_detail

/// a b + c.
template <class A, class B, class C, int N = tangent_detail::most_directions<A, B, C>(),
          class = std::enable_if_t<(N > 0)>>
[[gnu::always_inline]] inline Tangents<N> fma(const A& a, const B& b, const C& c) noexcept {
  using namespace tangent_detail;
  using Vector = typename DirectionTypes<N>::Vector;
  const double x = value_of(a), y = value_of(b);
  return {mbgen::fma(x, y, value_of(c)), plus(plus(derivatives<Vector>(c), x, b), y, a)};
}

/// a b - c.
template <class A, class B, class C, int N = tangent_detail::most_directions<A, B, C>(),
          class = std::enable_if_t<(N > 0)>>
[[gnu::always_inline]] inline Tangents<N> fms(const A& a, const B& b, const C& c) noexcept {
  return mbgen::fma(a, b, -c);
}

/// c - a b.
template <class A, class B, class C, int N = tangent_detail::most_directions<A, B, C>(),
          class = std::enable_if_t<(N > 0)>>
[[gnu::always_inline]] inline Tangents<N> fnma(const A& a, const B& b, const C& c) noexcept {
  using namespace tangent_detail;
  using Vector = typename DirectionTypes<N>::Vector;
  const double x = value_of(a), y = value_of(b);
  return {mbgen::fnma(x, y, value_of(c)), plus(plus(derivatives<Vector>(c), -x, b), -y, a)};
}

}  // namespace mbgen

/// As of double: limits are constants.
template <int N>
class std::numeric_limits<mbgen::Tangents<N>> : public std::numeric_limits<double> {};
