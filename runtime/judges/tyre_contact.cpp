#include "runtime/judges/tyre_contact.hpp"

#include <cmath>

#include "runtime/judges/road_surface.hpp"

namespace mbgen::cartesian {
namespace {

using Eigen::Vector3d;

/// Contact axes and point of a wheel disc: on the tangential plane of the road below the centre, or the plane from the
/// tyre's envelope, the point below the centre along the wheel's plane.
struct Contact {
  Vector3d forward, left, up;
  Vector3d arm;         ///< from the wheel's centre of mass to the contact point
  double friction = 1;  ///< of the road
  TyreContact<double> motion;
};

Contact contact_of(const Tyre& tyre, const PartTyre& part, const Moving& wheel, const Values& value) {
  Contact c;
  const Vector3d axis = wheel.axes * part.axis, centre = wheel.axes * part.centre.arm;
  const Vector3d velocity = wheel.velocity + wheel.spin.cross(centre), position = wheel.position + centre;
  const RoadSurface road = road_surface(tyre, position.head<2>(), axis, value);
  c.friction = road.friction;
  c.up = Vector3d(-road.gradient.x(), -road.gradient.y(), 1).normalized();
  c.forward = axis.cross(c.up).normalized();
  c.left = c.up.cross(c.forward);
  // Unit vector down the wheel's plane; the road is at the loaded radius along it.
  const Vector3d down = axis.cross(c.forward);
  const double steepness = -down.dot(c.up);
  const double height = c.up.z() * (position.z() - road.height);
  const double radius = height / steepness;
  c.arm = centre + radius * down;
  // height = radius * steepness, and `axis` tilts the plane: d(steepness)/dt = -sine * d(sine)/dt / steepness.
  const double sine = axis.dot(c.up), sine_rate = wheel.spin.cross(axis).dot(c.up);
  const double steepness_rate = -sine * sine_rate / steepness;
  const double spin = wheel.spin.dot(axis);
  const Vector3d turning = wheel.spin - spin * axis;
  c.motion.deflection = value(tyre.radius) - radius;
  c.motion.deflection_rate = -(velocity.dot(c.up) - radius * steepness_rate) / steepness;
  c.motion.vx = velocity.dot(c.forward);
  c.motion.vy = (velocity + turning.cross(radius * down)).dot(c.left);
  c.motion.spin = spin;
  c.motion.camber = std::asin(sine);
  // Rate of the heading: of the axis as seen from above.
  const Vector3d across = axis - sine * c.up, across_rate = wheel.spin.cross(axis);
  c.motion.turn_rate = c.up.dot(across.cross(across_rate)) / across.squaredNorm();
  return c;
}

TyreResult<double> law_of(const Tyre& tyre, const TyreContact<double>& contact, double road_friction,
                          const Values& value) {
  std::vector<double> coefficients;
  for (const Quantity& q : tyre.coefficients) coefficients.push_back(value(q));
  TyreProperties<double> properties{value(tyre.radius),
                                    value(tyre.stiffness),
                                    value(tyre.damping),
                                    road_friction * value(tyre.friction),
                                    value(tyre.rolling_resistance),
                                    value(tyre.relaxation_x),
                                    value(tyre.relaxation_y),
                                    value(tyre.low_speed),
                                    tyre.side,
                                    tyre.count,
                                    value(tyre.pressure),
                                    tyre.over_load_x ? 1. : 0.,
                                    tyre.over_load_y ? 1. : 0.};
  properties.ellipse = tyre.combined_slip == CombinedSlip::ellipse;
  if (tyre.parking) {
    properties.turning = tyre.turn_slip ? Turning::turn_slip : Turning::patch;
    properties.turn_stiffness = value(tyre.parking->stiffness);
    properties.turn_radius = value(tyre.parking->radius);
    properties.turn_load = value(tyre.parking->load);
  }
  if (tyre.model == TyreModel::mf61)
    return tyre_forces(MagicFormula61<double>::from_fields(coefficients.data()), properties, contact);
  if (tyre.model == TyreModel::pac2002)
    return tyre_forces(Pac2002<double>::from_fields(coefficients.data()), properties, contact);
  return tyre_forces(Pac89<double>::from_fields(coefficients.data()), properties, contact);
}

}  // namespace

RoadWheel road_wheel(const Tyre& tyre, const PartTyre& part, const Moving& wheel, const TyreStates& states,
                     const Values& value) {
  Contact contact = contact_of(tyre, part, wheel, value);
  contact.motion.u = states.u;
  contact.motion.v = states.v;
  contact.motion.turn = states.turn;
  const TyreResult<double> result = law_of(tyre, contact.motion, contact.friction, value);
  const Vector3d force = result.fx * contact.forward + result.fy * contact.left + result.load * contact.up;
  const Vector3d moment = result.mx * contact.forward + result.my * contact.left + result.mz * contact.up;
  RoadWheel road{{}, result};
  road.wrench << force, contact.arm.cross(force) + moment;
  return road;
}

}  // namespace mbgen::cartesian
