#include "runtime/judges/bump_stops.hpp"

#include <algorithm>
#include <cmath>

#include "runtime/judges/laws.hpp"

namespace mbgen::cartesian {
namespace {

using Eigen::Vector3d;
using Side = BumpStop::Side;

double stop_force(const BumpStop& stop, const Values& value, double penetration, double rate) {
  if (penetration <= 0) return 0;
  const bool is_table = stop.stiffness && std::holds_alternative<Table>(*stop.stiffness);
  const double elastic = law(stop.stiffness, value, is_table ? penetration : std::pow(penetration, stop.exponent)) +
                         with_locals(stop.force, value, penetration, rate);
  return std::max(0.0, elastic * (1 + value(stop.damping) * rate));
}

/// The travel and its rate, and the unit force on `from`, global axes, of a stop between points.
struct Travel {
  double way = 0, rate = 0;
  Vector3d direction = Vector3d::Zero();
};

Travel travel_of(const BumpStop& stop, const PartStop& part, const std::vector<Moving>& bodies) {
  const End from = end_of(bodies, part.line.from), to = end_of(bodies, part.line.to);
  const Vector3d gap = to.position - from.position, speed = to.velocity - from.velocity;
  const double sign = stop.side == Side::compression ? -1 : 1;
  if (!stop.axis) {
    const Vector3d along = gap.normalized();
    return {sign * (gap.norm() - part.line.reference), sign * along.dot(speed), sign * along};
  }
  const Moving& body = bodies[part.line.from.body];
  const Vector3d axis = sign * (body.axes * part.axis);
  return {axis.dot(gap - body.axes * part.gap), axis.dot(speed - body.spin.cross(gap)), axis};
}

}  // namespace

StopAtWork stop_at_work(const BumpStop& stop, const PartStop& part, const std::vector<Moving>& bodies,
                        const Values& value) {
  Travel travel;
  if (stop.is_on_joint()) {
    const double sign = stop.side == Side::below ? -1 : 1;
    travel.way = sign * value.position(stop.joint);
    travel.rate = sign * value.velocity(stop.joint);
  } else {
    travel = travel_of(stop, part, bodies);
  }
  const double penetration = travel.way - value(stop.clearance);
  const double force = stop_force(stop, value, penetration, travel.rate);
  return {penetration, travel.rate, force, force * travel.direction};
}

void add_bump_stops(const Model& model, const Parts& parts, const std::vector<Moving>& bodies, const Values& values,
                    Forces& forces) {
  for (std::size_t s = 0; s < model.bump_stops.size(); ++s) {
    const BumpStop& stop = model.bump_stops[s];
    const StopAtWork at_work = stop_at_work(stop, parts.bump_stops[s], bodies, values);
    if (stop.is_on_joint()) {
      const int i = values.table[stop.joint.joint][stop.joint.component];
      if (i >= 0) forces.joints[i] -= stop.side == Side::below ? -at_work.force : at_work.force;
      continue;
    }
    const PartLine& line = parts.bump_stops[s].line;
    const Vector3d place = end_of(bodies, line.to).position;  // both are pushed there, on one line of action
    const auto add = [&](int body, const Vector3d& force) {
      const Vector3d arm = place - bodies[body].position;
      forces.loads.push_back({body, (Vector6d() << force, arm.cross(force)).finished()});
    };
    add(line.from.body, at_work.on_from);
    add(line.to.body, -at_work.on_from);
  }
}

}  // namespace mbgen::cartesian
