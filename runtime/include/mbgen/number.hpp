#pragma once
// Questions to the numbers of a solver that its algorithms ask: double, float, or numbers with derivatives
// (tangents.hpp), which answer by their values.

#include <cmath>
#include <type_traits>

namespace mbgen {

/// Whether a type is one number, neither a vector of numbers nor a container.
template <class Real>
inline constexpr bool kIsNumber = std::is_floating_point_v<Real>;

/// Absolute value.
template <class Real, class = std::enable_if_t<kIsNumber<Real>>>
[[gnu::always_inline]] inline Real magnitude(const Real& x) noexcept {
  return std::abs(x);
}

template <class Real, class = std::enable_if_t<kIsNumber<Real>>>
[[gnu::always_inline]] inline bool is_finite(const Real& x) noexcept {
  return std::isfinite(x);
}

template <class Real, class = std::enable_if_t<kIsNumber<Real>>>
[[gnu::always_inline]] inline bool is_nan(const Real& x) noexcept {
  return std::isnan(x);
}

/// Whether a step of Newton's method leaves the derivatives of the coordinates as they are; plain numbers have none.
template <class Real>
constexpr bool keeps_derivatives(const Real* /*step*/, const Real* /*coordinates*/, int /*count*/) noexcept {
  return true;
}

}  // namespace mbgen
