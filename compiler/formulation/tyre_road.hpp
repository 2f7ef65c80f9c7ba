#pragma once
// Geometry of a wheel on a flat horizontal road, around the tyre law of the runtime's header tyre.hpp.

#include "compiler/formulation/force_work.hpp"

namespace mbgen {
namespace detail {

/// Contact of a wheel: axes and point in the frame that carries the wheel body.
template <class T>
struct RoadContact {
  Vector<T> forward, left, up;  ///< unit
  Vector<T> point;              ///< m, from the point that the wheel body's motion is about
  TyreContact<T> motion;
};

/// Spin axis of the wheel in its carrying frame; the joint's own axis where they agree, so that the spin angle drops
/// out.
template <class T>
Vector<T> spin_axis(const System<T>& system, const Kinematics<T>& k, const Tyre& tyre, int body) {
  if (body == kGround) return constant<T>(tyre.axis);
  const Vector3& joint = system.topology.bodies[body].axis;
  const double along = joint[0] * tyre.axis[0] + joint[1] * tyre.axis[1] + joint[2] * tyre.axis[2];
  const int carrier = system.layout.frame_of(body);
  if (system.revolute(body) && std::abs(std::abs(along) - 1) < 1e-12 &&
      system.layout.bodies[body].joint_frame == carrier)
    return T(along > 0 ? 1.0 : -1.0) * k.axis[body];
  return direction_in(system, k, body, constant<T>(tyre.axis), carrier);
}

template <class T>
RoadContact<T> road_contact(const ForceWork<T>& work, const Tyre& tyre, std::size_t index) {
  using std::atan;
  const System<T>& system = work.system;
  const Place<T> centre = work.place(tyre.centre);
  const int carrier = system.layout.frame_of(centre.body);
  const Vector<T> up = direction_up(system, work.k, kGround, Vector<T>{T(0.0), T(0.0), T(1.0)}, carrier);
  const Vector<T> axis = spin_axis(system, work.k, tyre, centre.body);
  const Vector<T> across = cross(axis, up);
  const T cosine = norm(across), sine = dot(axis, up);
  RoadContact<T> c;
  c.up = up;
  c.forward = (T(1.0) / cosine) * across;
  c.left = cross(up, c.forward);
  const T height = position_in(system, work.k, centre, kGround).z - work.value(tyre.road_height, "road", tyre.name);
  const T loaded_radius = height / cosine;
  const Vector<T> down = (loaded_radius / cosine) * (sine * axis - up);  // from the centre to the contact point
  const Vector<T> at = arm_of(system, work.k, centre, work.v.about);
  c.point = at + down;
  const Spatial<T> velocity = velocity_of(system, work.v, centre.body);
  const Vector<T> centre_velocity = velocity_at(velocity, at);
  const T spin = dot(velocity.angular, axis);
  const Vector<T> turning = velocity.angular - spin * axis;
  const T sine_rate = dot(cross(velocity.angular, axis), up);
  c.motion.deflection = work.value(tyre.radius, "radius", tyre.name) - loaded_radius;
  c.motion.deflection_rate = -(dot(centre_velocity, up) + loaded_radius * sine * sine_rate / cosine) / cosine;
  c.motion.vx = dot(centre_velocity, c.forward);
  c.motion.vy = dot(centre_velocity + cross(turning, down), c.left);
  c.motion.spin = spin;
  c.motion.camber = atan(sine / cosine);
  c.motion.u = system.x[2 * index];
  c.motion.v = system.x[2 * index + 1];
  return c;
}

/// Properties of a mounted tyre; value: of a quantity of the tyre with the meaning of its name.
template <class T, class Value>
TyreProperties<T> tyre_properties(const Tyre& tyre, const Value& value) {
  return {value(tyre.radius, "radius"),
          value(tyre.stiffness, "k"),
          value(tyre.damping, "d"),
          value(tyre.friction, "friction"),
          value(tyre.rolling_resistance, "rolling"),
          value(tyre.relaxation_x, "relaxation_x"),
          value(tyre.relaxation_y, "relaxation_y"),
          value(tyre.low_speed, "low_speed"),
          T(tyre.side),
          T(tyre.count)};
}

/// Calls use(set) with a tyre's set of coefficients as its model has them.
template <class T, class Use>
auto with_tyre_set(TyreModel model, const std::vector<T>& coefficients, const Use& use) {
  return model == TyreModel::pac2002 ? use(Pac2002<T>::from_fields(coefficients.data()))
                                     : use(Pac89<T>::from_fields(coefficients.data()));
}

/// The law of a set of coefficients.
template <class T>
TyreResult<T> tyre_law(TyreModel model, const std::vector<T>& coefficients, const TyreProperties<T>& properties,
                       const TyreContact<T>& contact) {
  return with_tyre_set(model, coefficients, [&](const auto& set) { return tyre_forces(set, properties, contact); });
}

template <class T>
TyreResult<T> tyre_result(const ForceWork<T>& work, const Tyre& tyre, std::size_t index,
                          const TyreContact<T>& contact) {
  const TyreProperties<T> properties = tyre_properties<T>(
      tyre, [&](const Quantity& q, const char* meaning) { return work.value(q, meaning, tyre.name); });
  if (work.shared_law) {
    if (std::optional<TyreResult<T>> result = work.shared_law(index, properties, contact)) return *result;
  }
  std::vector<T> coefficients;
  for (const Quantity& q : tyre.coefficients) coefficients.push_back(work.value(q));
  return tyre_law(tyre.model, coefficients, properties, contact);
}

template <class T>
void tyres(ForceWork<T>& work) {
  for (std::size_t i = 0; i < work.system.model.tyres.size(); ++i) {
    const Tyre& tyre = work.system.model.tyres[i];
    const auto heading = work.system.scribe.within(OwnerKind::tyre, i);
    const RoadContact<T> contact = road_contact(work, tyre, i);
    const TyreResult<T> result = tyre_result(work, tyre, i, contact.motion);
    const Vector<T> force = result.fx * contact.forward + result.fy * contact.left + result.load * contact.up;
    const Vector<T> moment = result.mx * contact.forward + result.my * contact.left + result.mz * contact.up;
    work.system.scribe.name(result.load, "load_", tyre.name);
    work.system.scribe.name(result.fx, "fx_", tyre.name);
    work.system.scribe.name(result.fy, "fy_", tyre.name);
    act(work, {tyre.centre.body, force, moment, contact.point});
    work.forces.xd[2 * i] = result.du;
    work.forces.xd[2 * i + 1] = result.dv;
    work.forces.tyres.push_back(result);
  }
}

}  // namespace detail
}  // namespace mbgen
