#pragma once
// The functions of emitted programs and of steps over numbers with derivatives. Where a function has a kink (abs, min,
// max, select, floor) the derivative is of the branch that the value takes.

#include <cmath>
#include <cstddef>

#include "mbgen/elementary.hpp"
#include "mbgen/math/tangent_numbers.hpp"
#include "mbgen/sample.hpp"
#include "mbgen/scalar.hpp"
#include "mbgen/turns.hpp"

namespace mbgen {

namespace tangent_detail {

/// f(x) with slope df/dx. A slope without bound counts where x moves only.
template <int N>
[[gnu::always_inline]] inline Tangents<N> chain(const Tangents<N>& x, double value, double slope) noexcept {
  if (std::isfinite(slope)) return {value, slope * x.tangent};
  Tangents<N> result(value);
  for (int k = 0; k < N; ++k) result.tangent[k] = x.tangent[k] == 0 ? 0 : slope * x.tangent[k];
  return result;
}

/// Angle of the point (x, y). At the origin it does not move.
template <int N, class A, class B>
[[gnu::always_inline]] inline Tangents<N> direction(const A& y, const B& x) noexcept {
  using Vector = typename DirectionTypes<N>::Vector;
  const double b = value_of(y), a = value_of(x), square = a * a + b * b;
  const double value = mbgen::arc_tangent(b, a);
  if (square == 0) return Tangents<N>(value);
  return {value, plus(plus(Vector{}, a / square, y), -b / square, x)};
}

/// base to the power of exponent.
template <int N, class A, class B>
[[gnu::always_inline]] inline Tangents<N> raised(const A& base, const B& exponent) noexcept {
  const double b = value_of(base), e = value_of(exponent), value = mbgen::power(b, e);
  Tangents<N> result = Tangents<N>(value);
  if constexpr (kDirectionsOf < A >> 0) {
    // The slope of a power with exponent 0 is 0 at a base of 0 too.
    result = chain(base, value, e == 0 ? 0.0 : e * mbgen::power(b, e - 1));
  }
  if constexpr (kDirectionsOf < B >> 0) {
    // A power of 0 does not change with its exponent.
    result.tangent += chain(exponent, value, value == 0 ? 0.0 : value * mbgen::logarithm(b)).tangent;
  }
  return result;
}

}  // namespace tangent_detail

/// a where condition >= 0, else b (b for NaN).
template <class A, class B, int N>
[[gnu::always_inline]] inline Tangents<N> select(const Tangents<N>& condition, const A& a, const B& b) noexcept {
  return condition.value >= 0 ? Tangents<N>(a) : Tangents<N>(b);
}
template <class A, class B, int N = tangent_detail::most_directions<A, B>(), class = std::enable_if_t<(N > 0)>>
[[gnu::always_inline]] inline Tangents<N> select(double condition, const A& a, const B& b) noexcept {
  return condition >= 0 ? Tangents<N>(a) : Tangents<N>(b);
}
template <class A, class B, int N = tangent_detail::most_directions<A, B>(), class = std::enable_if_t<(N > 0)>>
[[gnu::always_inline]] inline Tangents<N> min(const A& a, const B& b) noexcept {
  using tangent_detail::value_of;
  return value_of(b) < value_of(a) ? Tangents<N>(b) : Tangents<N>(a);
}
template <class A, class B, int N = tangent_detail::most_directions<A, B>(), class = std::enable_if_t<(N > 0)>>
[[gnu::always_inline]] inline Tangents<N> max(const A& a, const B& b) noexcept {
  using tangent_detail::value_of;
  return value_of(a) < value_of(b) ? Tangents<N>(b) : Tangents<N>(a);
}
template <int N>
[[gnu::always_inline]] inline Tangents<N> abs(const Tangents<N>& x) noexcept {
  return magnitude(x);
}
template <int N>
[[gnu::always_inline]] inline Tangents<N> floor(const Tangents<N>& x) noexcept {
  return std::floor(x.value);
}
template <int N>
[[gnu::always_inline]] inline Tangents<N> sqrt(const Tangents<N>& x) noexcept {
  const double root = std::sqrt(x.value);
  return tangent_detail::chain(x, root, 0.5 / root);
}

template <int N>
[[gnu::always_inline]] inline void sincos(const Tangents<N>& angle, Tangents<N>& sine, Tangents<N>& cosine) noexcept {
  double s, c;
  mbgen::sincos(angle.value, s, c);
  const typename Tangents<N>::Vector rate = angle.tangent;
  sine = {s, c * rate};
  cosine = {c, -s * rate};
}
template <int N>
[[gnu::always_inline]] inline Tangents<N> sine(const Tangents<N>& angle) noexcept {
  Tangents<N> s, c;
  mbgen::sincos(angle, s, c);
  return s;
}
template <int N>
[[gnu::always_inline]] inline Tangents<N> cosine(const Tangents<N>& angle) noexcept {
  Tangents<N> s, c;
  mbgen::sincos(angle, s, c);
  return c;
}
template <int N>
[[gnu::always_inline]] inline Tangents<N> tangent(const Tangents<N>& angle) noexcept {
  const double value = mbgen::tangent(angle.value);
  return {value, (1 + value * value) * angle.tangent};
}
template <int N>
[[gnu::always_inline]] inline Tangents<N> arc_tangent(const Tangents<N>& x) noexcept {
  return {mbgen::arc_tangent(x.value), x.tangent * (1 / (1 + x.value * x.value))};
}
template <class A, class B, int N = tangent_detail::most_directions<A, B>(), class = std::enable_if_t<(N > 0)>>
[[gnu::always_inline]] inline Tangents<N> arc_tangent(const A& y, const B& x) noexcept {
  return tangent_detail::direction<N>(y, x);
}
template <int N>
[[gnu::always_inline]] inline Tangents<N> arc_tangent(const Tangents<N>& y, const Tangents<N>& x) noexcept {
  return tangent_detail::direction<N>(y, x);
}
template <int N>
[[gnu::always_inline]] inline Tangents<N> arc_sine(const Tangents<N>& x) noexcept {
  return tangent_detail::chain(x, mbgen::arc_sine(x.value), 1 / std::sqrt((1 - x.value) * (1 + x.value)));
}
template <int N>
[[gnu::always_inline]] inline Tangents<N> arc_cosine(const Tangents<N>& x) noexcept {
  return tangent_detail::chain(x, mbgen::arc_cosine(x.value), -1 / std::sqrt((1 - x.value) * (1 + x.value)));
}
template <int N>
[[gnu::always_inline]] inline Tangents<N> exponential(const Tangents<N>& x) noexcept {
  const double value = mbgen::exponential(x.value);
  return tangent_detail::chain(x, value, value);
}
template <int N>
[[gnu::always_inline]] inline Tangents<N> logarithm(const Tangents<N>& x) noexcept {
  return tangent_detail::chain(x, mbgen::logarithm(x.value), 1 / x.value);
}
template <int N>
[[gnu::always_inline]] inline Tangents<N> hyperbolic_tangent(const Tangents<N>& x) noexcept {
  const double value = mbgen::hyperbolic_tangent(x.value);
  return {value, (1 - value) * (1 + value) * x.tangent};
}
template <class A, class B, int N = tangent_detail::most_directions<A, B>(), class = std::enable_if_t<(N > 0)>>
[[gnu::always_inline]] inline Tangents<N> power(const A& base, const B& exponent) noexcept {
  return tangent_detail::raised<N>(base, exponent);
}
template <int N>
[[gnu::always_inline]] inline Tangents<N> power(const Tangents<N>& base, const Tangents<N>& exponent) noexcept {
  return tangent_detail::raised<N>(base, exponent);
}

/// Numbers of a table are constants between places.
template <int N, std::size_t Count>
[[gnu::always_inline]] inline Tangents<N> sample(const double (&samples)[Count], const Tangents<N>& index) noexcept {
  return mbgen::sample(samples, index.value);
}

// --- several arguments in one call ---

template <int N, std::size_t Count>
inline void sincos(const Tangents<N> (&angles)[Count], Tangents<N> (&sines)[Count],
                   Tangents<N> (&cosines)[Count]) noexcept {
  double angle[Count], s[Count], c[Count];
  for (std::size_t i = 0; i < Count; ++i) angle[i] = angles[i].value;
  mbgen::sincos(angle, s, c);
  for (std::size_t i = 0; i < Count; ++i) {
    sines[i] = {s[i], c[i] * angles[i].tangent};
    cosines[i] = {c[i], -s[i] * angles[i].tangent};
  }
}

namespace tangent_detail {

template <int N, std::size_t Count, class Function>
[[gnu::always_inline]] inline void each(const Tangents<N> (&from)[Count], Tangents<N> (&to)[Count],
                                        Function function) noexcept {
  for (std::size_t i = 0; i < Count; ++i) to[i] = function(from[i]);
}

}  // namespace tangent_detail

template <int N, std::size_t Count>
inline void sines(const Tangents<N> (&angles)[Count], Tangents<N> (&values)[Count]) noexcept {
  tangent_detail::each(angles, values, [](const Tangents<N>& x) { return mbgen::sine(x); });
}
template <int N, std::size_t Count>
inline void cosines(const Tangents<N> (&angles)[Count], Tangents<N> (&values)[Count]) noexcept {
  tangent_detail::each(angles, values, [](const Tangents<N>& x) { return mbgen::cosine(x); });
}
template <int N, std::size_t Count>
inline void bounded_sines(const Tangents<N> (&angles)[Count], Tangents<N> (&values)[Count]) noexcept {
  sines(angles, values);
}
template <int N, std::size_t Count>
inline void bounded_cosines(const Tangents<N> (&angles)[Count], Tangents<N> (&values)[Count]) noexcept {
  cosines(angles, values);
}
template <int N, std::size_t Count>
inline void exponentials(const Tangents<N> (&arguments)[Count], Tangents<N> (&values)[Count]) noexcept {
  tangent_detail::each(arguments, values, [](const Tangents<N>& x) { return mbgen::exponential(x); });
}
template <int N, std::size_t Count>
inline void hyperbolic_tangents(const Tangents<N> (&arguments)[Count], Tangents<N> (&values)[Count]) noexcept {
  tangent_detail::each(arguments, values, [](const Tangents<N>& x) { return mbgen::hyperbolic_tangent(x); });
}
template <int N, std::size_t Count>
inline void arc_tangents(const Tangents<N> (&tangents)[Count], Tangents<N> (&angles)[Count]) noexcept {
  tangent_detail::each(tangents, angles, [](const Tangents<N>& x) { return mbgen::arc_tangent(x); });
}
template <int N, std::size_t Count>
inline void powers(const Tangents<N> (&bases)[Count], const Tangents<N> (&exponents)[Count],
                   Tangents<N> (&values)[Count]) noexcept {
  for (std::size_t i = 0; i < Count; ++i) values[i] = mbgen::power(bases[i], exponents[i]);
}

/// As of doubles, by the values.
template <int K, std::size_t N>
inline Status with_turns(Status stepped, const Tangents<K> (&zd)[N], const double (&turning)[N], double h,
                         double largest) noexcept {
  double rates[N];
  for (std::size_t i = 0; i < N; ++i) rates[i] = zd[i].value;
  return with_turns(stepped, rates, turning, h, largest);
}

}  // namespace mbgen
