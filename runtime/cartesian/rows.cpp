#include "runtime/cartesian/rows.hpp"

#include <Eigen/Geometry>

namespace mbgen::cartesian {

using Eigen::Vector3d;

namespace {

Vector6d wrench(const Vector3d& force, const Vector3d& moment) { return (Vector6d() << force, moment).finished(); }

/// Second derivative of a direction that turns with an angular velocity, while that stays.
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
  // The axis turns across itself, so its rate does not see the spin: no bias.
  return {rod, ground, wrench(Vector3d::Zero(), motion.axes.col(0)), Vector6d::Zero(), 0, 0, 0};
}

}  // namespace mbgen::cartesian
