#pragma once
// Scalar force laws over a scalar T: air springs and joint friction. Springs and dampers are linear or tables
// (table.hpp).

#include "mbgen/scalar.hpp"

namespace mbgen {

/// Least velocity, rad/s or m/s, over which friction is smoothed.
inline constexpr double kLeastFrictionVelocity = 1e-9;
/// Least volume of an air spring over its reference volume: beyond it the pressure stays.
inline constexpr double kLeastVolume = 1e-3;

/// Force of an air spring, N, positive when it pushes its ends apart: (p - ambient) area, p V^exponent constant.
/// pressure: Pa absolute, at reference_volume; ambient: Pa absolute; exponent: 1 isothermal to 1.4 adiabatic for air;
/// reference_volume, volume: m^3, the volume held above kLeastVolume of the reference; area: m^2, effective.
/// Requires: reference_volume > 0. Source: polytropic change of state of an ideal gas.
template <class T>
T air_spring_force(const T& pressure, const T& ambient, const T& exponent, const T& reference_volume, const T& volume,
                   const T& area) {
  using std::pow;
  const T compression = reference_volume / max(volume, T(kLeastVolume * reference_volume));
  return (pressure * pow(compression, exponent) - ambient) * area;
}

/// Friction force on a coordinate moving at `rate`, N m or N, always against the motion:
/// -(coulomb + (stiction - coulomb) exp(-(rate / stribeck_velocity)^2)) tanh(rate / velocity) - viscous rate.
/// coulomb, stiction: N m or N; viscous: N m s/rad or N s/m; velocity, stribeck_velocity: rad/s or m/s, held above
/// kLeastFrictionVelocity. Source: Stribeck's curve in the form of L. C. Bo, D. Pavelescu, "The friction-speed relation
/// and its influence on the critical velocity of stick-slip motion", Wear 82(3), 1982, with a smooth sign.
template <class T>
T friction_force(const T& coulomb, const T& stiction, const T& viscous, const T& velocity, const T& stribeck_velocity,
                 const T& rate) {
  using std::exp;
  using std::tanh;
  const T ratio = rate / max(stribeck_velocity, T(kLeastFrictionVelocity));
  const T level = coulomb + (stiction - coulomb) * exp(-(ratio * ratio));
  return -(level * tanh(rate / max(velocity, T(kLeastFrictionVelocity)))) - viscous * rate;
}

}  // namespace mbgen
