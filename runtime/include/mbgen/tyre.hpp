#pragma once
// A tyre on a flat road: load, slips with relaxation down to rest, forces and moments at the contact point.

#include "mbgen/magic_formula.hpp"

namespace mbgen {

/// Properties of a mounted tyre. Units as stated, of one tyre.
template <class T>
struct TyreProperties {
  T radius;                  ///< m, unloaded, > 0
  T stiffness, damping;      ///< N/m and N s/m, vertical
  T friction;                ///< scales the friction of the coefficient set, 1 is the measured one, >= 0
  T rolling_resistance;      ///< 1, moment over load and radius
  T relaxation_x, relaxation_y;  ///< m, relaxation lengths, > 0
  T low_speed;               ///< m/s, > 0: below it slip is damped, and the moments of rolling fade out
  double side = 1;           ///< -1 mirrors the coefficient set (tyre measured on the other side)
  double count = 1;          ///< tyres side by side; forces, moments and load times count
};

/// Motion of the wheel in its contact frame: origin at the contact point, x along the wheel's heading on the road,
/// y to the left, z the road's normal (up).
template <class T>
struct TyreContact {
  T deflection;              ///< m, unloaded radius less the distance of the wheel centre from the contact point
  T deflection_rate;         ///< m/s, its time derivative
  T vx;                      ///< m/s, velocity of the wheel centre along x
  T vy;                      ///< m/s, velocity of the contact point (moving with the wheel, without its spin) along y
  T spin;                    ///< rad/s, about the wheel's axis (the one to the left), positive when rolling forward
  T camber;                  ///< rad, rotation of the wheel plane from upright about x, top to the right positive
  T u, v;                    ///< m, deflection states along x and y, see TyreResult
};

/// What a tyre does to its wheel, at the contact point in contact axes, and the rates of its deflection states.
template <class T>
struct TyreResult {
  T load, fx, fy;            ///< N: along z, x, y; load >= 0
  T mx, my, mz;              ///< N m: overturning, rolling resistance, aligning
  T du, dv;                  ///< m/s, rates of u and v
  T kappa, alpha;            ///< slips behind the forces: 1, driving positive; rad, sliding left positive
};

/// Forces of a tyre on a flat road. Set: Pac2002<T> or Pac89<T>.
template <class T, class Set>
TyreResult<T> tyre_forces(const Set& set, const TyreProperties<T>& tyre, const TyreContact<T>& contact);

}  // namespace mbgen
