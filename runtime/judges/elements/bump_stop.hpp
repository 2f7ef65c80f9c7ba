#pragma once
// Bump stops: travel, law, and loads on the bodies or the coordinate.

#include "runtime/judges/elements/at_work.hpp"

namespace mbgen::cartesian {

/// A bump stop at one instant.
struct StopAtWork {
  double penetration = 0, rate = 0, force = 0;        ///< m or rad, per second, N or N m
  Eigen::Vector3d on_from = Eigen::Vector3d::Zero();  ///< between points: force on `from`, global axes, N
};

inline double stop_force(const BumpStop& stop, const Values& value, double penetration, double rate) {
  if (penetration <= 0) return 0;
  const bool is_table = stop.stiffness && std::holds_alternative<Table>(*stop.stiffness);
  const double elastic = law(stop.stiffness, value, is_table ? penetration : std::pow(penetration, stop.exponent)) +
                         with_locals(stop.force, value, penetration, rate);
  return std::max(0.0, elastic * (1 + value(stop.damping) * rate));
}

/// The travel and its rate, and the unit force on `from`, global axes, of a stop between points.
struct Travel {
  double way = 0, rate = 0;
  Eigen::Vector3d direction = Eigen::Vector3d::Zero();
};

inline Travel travel_of(const BumpStop& stop, const ElementPart& part, const std::vector<Moving>& bodies) {
  const End from = end_of(bodies, part.from), to = end_of(bodies, part.to);
  const Eigen::Vector3d gap = to.position - from.position, speed = to.velocity - from.velocity;
  const double sign = stop.side == BumpStop::Side::compression ? -1 : 1;
  if (!stop.axis) {
    const Eigen::Vector3d along = gap.normalized();
    return {sign * (gap.norm() - part.reference), sign * along.dot(speed), sign * along};
  }
  const Moving& body = bodies[part.from.body];
  const Eigen::Vector3d axis = sign * (body.axes * part.axis);
  return {axis.dot(gap - body.axes * part.gap), axis.dot(speed - body.spin.cross(gap)), axis};
}

inline StopAtWork stop_at_work(const BumpStop& stop, const ElementPart& part, const std::vector<Moving>& bodies,
                               const Values& value) {
  Travel travel;
  if (stop.is_on_joint()) {
    const double sign = stop.side == BumpStop::Side::below ? -1 : 1;
    travel.way = sign * value.position(stop.joint);
    travel.rate = sign * value.velocity(stop.joint);
    if (stop.relative_to) {
      travel.way -= sign * value.position(*stop.relative_to);
      travel.rate -= sign * value.velocity(*stop.relative_to);
    }
  } else {
    travel = travel_of(stop, part, bodies);
  }
  const double penetration = travel.way - value(stop.clearance);
  const double force = stop_force(stop, value, penetration, travel.rate);
  return {penetration, travel.rate, force, force * travel.direction};
}

inline StopAtWork stop_at_work(const AtWork& at, const BumpStop& stop) {
  return stop_at_work(stop, part_of(at, stop), at.bodies, at.value);
}

inline void apply(const AtWork& at, const BumpStop& stop, Forces& forces) {
  const StopAtWork at_work = stop_at_work(at, stop);
  if (stop.is_on_joint()) {
    const double force = stop.side == BumpStop::Side::below ? at_work.force : -at_work.force;
    add_on_coordinate(at, stop.joint, force, forces);
    if (stop.relative_to) add_on_coordinate(at, *stop.relative_to, -force, forces);
    return;
  }
  const ElementPart& part = part_of(at, stop);
  const Eigen::Vector3d place = end_of(at.bodies, part.to).position;  // both forces are here, on one line of action
  const auto add = [&](int body, const Eigen::Vector3d& force) {
    const Eigen::Vector3d arm = place - at.bodies[body].position;
    forces.loads.push_back({body, (Vector6d() << force, arm.cross(force)).finished()});
  };
  add(part.from.body, at_work.on_from);
  add(part.to.body, -at_work.on_from);
}

inline double shown(const AtWork& at, const Forces&, const BumpStop& stop, int quantity, int) {
  const StopAtWork at_work = stop_at_work(at, stop);
  const double values[] = {at_work.force, at_work.penetration, at_work.rate};
  return values[quantity];
}

inline double energy_of(const AtWork& at, const BumpStop& stop) {
  const double penetration = stop_at_work(at, stop).penetration;
  if (penetration <= 0) return 0;
  if (std::holds_alternative<Table>(*stop.stiffness)) return work_of(stop.stiffness, at.value, penetration);
  // Work of a power law: final force times penetration, over the exponent plus one.
  const double force = law(stop.stiffness, at.value, std::pow(penetration, stop.exponent));
  return force * penetration / (stop.exponent + 1);
}

}  // namespace mbgen::cartesian
