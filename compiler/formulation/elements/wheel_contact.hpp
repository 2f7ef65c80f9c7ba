#pragma once
// A wheel on a plane road: from the motion of the wheel to the contact of its tyre, and from the tyre's forces to the
// wheel. All vectors in the axes of one frame, whichever.

#include "compiler/formulation/vector.hpp"
#include "mbgen/tyres/tyre.hpp"

namespace mbgen {

/// Motion of a wheel, as its tyre sees it.
template <class T>
struct WheelMotion {
  Vector<T> up, axis;           ///< unit: the road's normal, the wheel's axis (the one to the left)
  T height{0.0};                ///< of the wheel centre above the road, along its normal, m
  Vector<T> velocity, angular;  ///< of the wheel centre, m/s; of the wheel, rad/s
  T u{0.0}, v{0.0};             ///< deflection states of the tyre, m
  T turn{0.0};                  ///< deflection state of a tyre with turning, rad
};

/// Contact of a wheel: its axes, and its point from the wheel centre.
template <class T>
struct RoadContact {
  Vector<T> forward, left, up;  ///< unit
  Vector<T> down;               ///< m
  TyreContact<T> motion;
};

/// radius: of the unloaded tyre, m.
template <class T>
RoadContact<T> road_contact(const WheelMotion<T>& wheel, const T& radius) {
  using std::atan;
  const Vector<T> across = cross(wheel.axis, wheel.up);
  const T cosine = norm(across), sine = dot(wheel.axis, wheel.up);
  RoadContact<T> c;
  c.up = wheel.up;
  c.forward = (T(1.0) / cosine) * across;
  c.left = cross(wheel.up, c.forward);
  const T loaded_radius = wheel.height / cosine;
  c.down = (loaded_radius / cosine) * (sine * wheel.axis - wheel.up);
  const T spin = dot(wheel.angular, wheel.axis);
  const Vector<T> turning = wheel.angular - spin * wheel.axis;
  const T sine_rate = dot(cross(wheel.angular, wheel.axis), wheel.up);
  c.motion.deflection = radius - loaded_radius;
  c.motion.deflection_rate = -(dot(wheel.velocity, wheel.up) + loaded_radius * sine * sine_rate / cosine) / cosine;
  c.motion.vx = dot(wheel.velocity, c.forward);
  c.motion.vy = dot(wheel.velocity + cross(turning, c.down), c.left);
  c.motion.spin = spin;
  c.motion.camber = atan(sine / cosine);
  c.motion.u = wheel.u;
  c.motion.v = wheel.v;
  c.motion.turn_rate = dot(turning, wheel.up) / (cosine * cosine);
  c.motion.turn = wheel.turn;
  return c;
}

/// Force of a tyre on its wheel, N, and its moment at the contact point, N m, in the axes of the contact's vectors.
template <class T>
Spatial<T> tyre_wrench(const RoadContact<T>& contact, const TyreResult<T>& tyre) {
  return {tyre.fx * contact.forward + tyre.fy * contact.left + tyre.load * contact.up,
          tyre.mx * contact.forward + tyre.my * contact.left + tyre.mz * contact.up};
}

/// Results of a tyre's law for its wheel.
template <class T>
struct WheelForces {
  Spatial<T> wrench;   ///< N, and N m at the wheel centre
  T du{0.0}, dv{0.0};  ///< m/s, rates of the tyre's deflection states
  T dturn{0.0};        ///< rad/s, likewise, of a tyre with turning
};

}  // namespace mbgen
