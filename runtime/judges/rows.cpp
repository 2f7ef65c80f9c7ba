#include "runtime/judges/rows.hpp"

#include <Eigen/Geometry>
#include <cmath>

namespace mbgen::cartesian {

using Eigen::Vector3d;

namespace {

Vector6d wrench(const Vector3d& force, const Vector3d& moment) { return (Vector6d() << force, moment).finished(); }

/// Second derivative of a direction that rotates with a constant angular velocity.
Vector3d centripetal(const Vector3d& spin, const Vector3d& direction) { return spin.cross(spin.cross(direction)); }

}  // namespace

End end_of(const std::vector<Moving>& bodies, const Place& place) {
  const Moving& body = bodies[place.body];
  const Vector3d arm = body.axes * place.arm;
  return {place.body,          arm,
          body.position + arm, body.velocity + body.spin.cross(arm),
          body.spin,           centripetal(body.spin, arm)};
}

Row coincidence(const End& from, const End& to, const Vector3d& direction) {
  return {from.body,
          to.body,
          wrench(direction, from.arm.cross(direction)),
          -wrench(direction, to.arm.cross(direction)),
          direction.dot(from.position - to.position),
          0,
          -direction.dot(from.centripetal - to.centripetal)};
}

Row perpendicular(const End& from, const End& to, const Vector3d& a, const Vector3d& b) {
  const Vector6d turn = wrench(Vector3d::Zero(), a.cross(b));
  const double second =
      centripetal(from.spin, a).dot(b) + a.dot(centripetal(to.spin, b)) + 2 * from.spin.cross(a).dot(to.spin.cross(b));
  return {from.body, to.body, turn, -turn, a.dot(b), 0, -second};
}

Row in_plane(const End& from, const End& to, const Vector3d& a) {
  const Vector3d gap = from.position - to.position;
  const double second = centripetal(from.spin, a).dot(gap) + 2 * from.spin.cross(a).dot(from.velocity - to.velocity) +
                        a.dot(from.centripetal - to.centripetal);
  return {from.body, to.body, wrench(a, from.arm.cross(a) + a.cross(gap)), -wrench(a, to.arm.cross(a)), a.dot(gap),
          0,         -second};
}

Row equal_turns(const End& from, const End& to, const Eigen::Matrix3d& on_from, const Eigen::Matrix3d& on_to) {
  const Eigen::Quaterniond turn(Eigen::Matrix3d(on_from.transpose() * on_to));
  const Vector3d shaft_from = on_from.col(2), shaft_to = on_to.col(2);
  const Vector6d half = wrench(Vector3d::Zero(), 0.5 * (shaft_from + shaft_to));
  const double second = 0.5 * (from.spin - to.spin).dot(from.spin.cross(shaft_from) + to.spin.cross(shaft_to));
  return {from.body, to.body, half, -half, -2 * turn.w() * turn.z(), 0, -second};
}

Row no_slip(const End& from, const End& to, const RollingContact& contact, const Vector3d& direction,
            const Vector3d& direction_rate) {
  // Arms from the centres of mass, whose velocities are independent of the contact's position.
  const auto arm = [&](const End& end) { return Vector3d(contact.place - end.position + end.arm); };
  const auto centre = [](const End& end) { return Vector3d(end.velocity - end.spin.cross(end.arm)); };
  const auto velocity = [&](const End& end) { return Vector3d(centre(end) + end.spin.cross(arm(end))); };
  const auto with_arm = [&](const End& end) { return Vector3d(end.spin.cross(contact.rate - centre(end))); };
  return {from.body,
          to.body,
          wrench(direction, arm(from).cross(direction)),
          -wrench(direction, arm(to).cross(direction)),
          0,
          0,
          -direction_rate.dot(velocity(from) - velocity(to)) - direction.dot(with_arm(from) - with_arm(to)),
          {},
          true};
}

std::vector<Row> rolling(JointType type, const End& from, const End& to, const Eigen::Matrix3d& on_from,
                         const Eigen::Matrix3d& on_to, double radius) {
  const Vector3d normal = on_from.col(2), normal_rate = from.spin.cross(normal);
  const Vector3d axle = on_to.col(2), axle_rate = to.spin.cross(axle);
  const double lean = normal.dot(axle), lean_rate = normal_rate.dot(axle) + normal.dot(axle_rate);
  const double share = 1 / std::sqrt(1 - lean * lean), share_rate = share * share * share * lean * lean_rate;
  const Vector3d ahead = axle.cross(normal), ahead_rate = axle_rate.cross(normal) + axle.cross(normal_rate);
  const Vector3d forward = share * ahead, forward_rate = share_rate * ahead + share * ahead_rate;
  const Vector3d left = normal.cross(forward), left_rate = normal_rate.cross(forward) + normal.cross(forward_rate);
  if (type == JointType::knife_edge) {  // normal x blade is behind
    return {no_slip(from, to, {to.position, to.velocity}, -forward, -forward_rate)};
  }
  if (type == JointType::rolling_ball) {
    const RollingContact contact{to.position - radius * normal, to.velocity - radius * normal_rate};
    const auto fixed = [&](int k) {
      return no_slip(from, to, contact, on_from.col(k), from.spin.cross(on_from.col(k)));
    };
    std::vector<Row> rows{fixed(2), fixed(0), fixed(1)};
    rows[0].residual = normal.dot(from.position - to.position) + radius;
    rows[0].of_velocities = false;
    return rows;
  }
  // The normal minus its component along the axle points away from the lowest point of the rim.
  const Vector3d up = normal - lean * axle, up_rate = normal_rate - lean_rate * axle - lean * axle_rate;
  const RollingContact contact{to.position - radius * share * up,
                               to.velocity - radius * (share_rate * up + share * up_rate)};
  std::vector<Row> rows{no_slip(from, to, contact, normal, normal_rate),
                        no_slip(from, to, contact, forward, forward_rate), no_slip(from, to, contact, left, left_rate)};
  rows[0].residual = normal.dot(from.position - to.position) + radius / share;
  rows[0].of_velocities = false;
  return rows;
}

Row distance(const End& from, const End& to, double length) {
  const Vector3d gap = from.position - to.position, direction = gap / length;
  const double second =
      (from.velocity - to.velocity).squaredNorm() / length + direction.dot(from.centripetal - to.centripetal);
  return {from.body,
          to.body,
          wrench(direction, from.arm.cross(direction)),
          -wrench(direction, to.arm.cross(direction)),
          (gap.squaredNorm() - length * length) / (2 * length),
          0,
          -second};
}

Row no_spin(int rod, int ground, const Moving& motion) {
  // The axis rotates perpendicular to itself, so its rate has no component along the spin: no bias.
  return {rod, ground, wrench(Vector3d::Zero(), motion.axes.col(0)), Vector6d::Zero(), 0, 0, 0};
}

}  // namespace mbgen::cartesian
