#pragma once
// Friction that sticks: bristles between two parts that slide on each other, over a scalar T.

#include "mbgen/scalar.hpp"
#include "mbgen/solver/forces.hpp"

namespace mbgen {

/// Least deflection, rad or m, at which bristles slide.
inline constexpr double kLeastBristle = 1e-15;
/// Least part of the deflection over which bristles go from elastic to sliding.
inline constexpr double kLeastBristleYield = 1e-3;
/// Parts that are slower on each other stand, rad/s or m/s.
inline constexpr double kSlidingBristle = 1e-9;
/// s, of bristles whose limit is 0 and whose friction has a lag of 0.
inline constexpr double kShortestBristleLag = 1e-3;

/// Properties of bristles; stiffness > 0.
template <class T>
struct Bristles {
  T coulomb, stiction;   ///< N m or N
  T stribeck_velocity;   ///< rad/s or m/s, held above kLeastFrictionVelocity
  T stiffness, damping;  ///< N m/rad or N/m, N m s/rad or N s/m
  T lag;                 ///< s: bristles follow no faster
};

/// Force of bristles and the rate of their deflection.
template <class T>
struct BristleResult {
  T force;  ///< N m or N, on the part whose velocity `rate` is, against the motion
  T rate;   ///< rad/s or m/s
};

/// Deflection of bristles that slide steadily, rad or m, over Stribeck's curve as friction_force has it.
template <class T>
T largest_deflection(const Bristles<T>& bristles, const T& velocity) {
  using std::exp;
  const T ratio = velocity / max(bristles.stribeck_velocity, T(kLeastFrictionVelocity));
  const T level = bristles.coulomb + (bristles.stiction - bristles.coulomb) * exp(-(ratio * ratio));
  return max(level / bristles.stiffness, T(kLeastBristle));
}

/// The velocity that bends bristles, rad/s or m/s: the velocity of the parts, limited to `largest` in the time `lag`.
template <class T>
T bristle_speed(const Bristles<T>& bristles, const T& largest, const T& velocity) {
  return velocity * (largest / max(largest, bristles.lag * abs(velocity)));
}

/// Parts that slide on each other at v deflect bristles by b, at most by g(v) / stiffness, g Stribeck's curve:
///   force = -(stiffness b + damping db/dt)   db/dt = w - yield |w| r   r = stiffness b / g(v)
///   w = v, or in its direction 1 / lag of the largest deflection a second where v is more
///   yield = 1 (LuGre)
///   yield = s^2 (3 - 2 s) where w r > 0, else 0; s = (|r| - elastic) / (1 - elastic) in 0 ... 1 (elasto-plastic)
/// An elasto-plastic bristle below `elastic` only bends: what vibrates under a load does not creep. elastic: 0 to below
/// 1; NaN-free for all finite arguments. lag keeps the bristles of fast parts within the reach of explicit steps.
/// Source: C. Canudas de Wit, H. Olsson, K. J. Astrom, P. Lischinsky, "A New Model for Control of Systems with
/// Friction", IEEE Trans. Automatic Control 40(3), 1995 (LuGre); P. Dupont, V. Hayward, B. Armstrong, F. Altpeter,
/// "Single State Elastoplastic Friction Models", IEEE Trans. Automatic Control 47(5), 2002, with a cubic for its sine.
template <class T>
BristleResult<T> lugre_friction(const Bristles<T>& bristles, const T& deflection, const T& velocity) {
  const T largest = largest_deflection(bristles, velocity);
  const T speed = bristle_speed(bristles, largest, velocity);
  const T rate = speed - abs(speed) * (deflection / largest);
  return {-(bristles.stiffness * deflection + bristles.damping * rate), rate};
}

/// See lugre_friction.
template <class T>
BristleResult<T> elasto_plastic_friction(const Bristles<T>& bristles, const T& elastic, const T& deflection,
                                         const T& velocity) {
  const T largest = largest_deflection(bristles, velocity);
  const T speed = bristle_speed(bristles, largest, velocity);
  const T bent = deflection / largest;
  const T part = (abs(bent) - elastic) / max(1.0 - elastic, T(kLeastBristleYield));
  const T s = min(max(part, T(0)), T(1));
  const T onwards = max(speed, T(0)) * max(bent, T(0)) - max(-speed, T(0)) * max(-bent, T(0));
  const T rate = speed - s * s * (3.0 - 2.0 * s) * onwards;
  return {-(bristles.stiffness * deflection + bristles.damping * rate), rate};
}

/// Bristles with the limit 0, for derivatives. The laws above are springs within kLeastBristle even then, so that their
/// derivatives at rest belong to a brake that holds. For sliding parts the limit acts against the motion, so that the
/// derivative by a brake's load is the derivative of closing it; parts at rest feel nothing.
template <class T>
BristleResult<T> open_bristle(const Bristles<T>& bristles, double lag, const T& deflection, const T& velocity) {
  const T against = select(velocity, T(-1.0), T(1.0));
  const T slides = abs(velocity) - T(kSlidingBristle);
  return {select(slides, against * bristles.coulomb, T(0.0)), -deflection / T(lag > 0 ? lag : kShortestBristleLag)};
}

}  // namespace mbgen
