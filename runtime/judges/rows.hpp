#pragma once
// Rows of the constraint Jacobian: blocks of one equation for its two bodies, and equations of joints.

#include <utility>
#include <vector>

#include "runtime/judges/parts.hpp"

namespace mbgen::cartesian {

using Vector6d = Eigen::Matrix<double, 6, 1>;

/// A body at one instant, global axes. position and velocity: of the centre of mass.
struct Moving {
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
  Eigen::Vector3d position = Eigen::Vector3d::Zero(), velocity = Eigen::Vector3d::Zero(),
                  spin = Eigen::Vector3d::Zero();
};

/// A point of a body at one instant, global axes.
struct End {
  int body = 0;
  Eigen::Vector3d arm;                       ///< from the centre of mass, m
  Eigen::Vector3d position, velocity, spin;  ///< of the point; spin of its body
  Eigen::Vector3d centripetal;               ///< acceleration of the point for a body without acceleration, m/s^2
};

End end_of(const std::vector<Moving>& bodies, const Place& place);

/// One equation between two bodies: on_from' qdd_from + on_to' qdd_to = bias, plus blocks of further bodies for a
/// coupling. The columns are also the wrenches, about the centres of mass, of a unit multiplier.
struct Row {
  int from = 0, to = 0;
  Vector6d on_from, on_to;
  double residual = 0;  ///< Phi, m or 1
  double rate = 0;      ///< b of (3): required value of on_from' qd_from + on_to' qd_to
  double bias = 0;      ///< c of (4)
  std::vector<std::pair<int, Vector6d>> further = {};
  bool of_velocities = false;  ///< no function of positions has it as derivative: no residual
};

/// Component of r_from - r_to along a constant direction.
Row coincidence(const End& from, const End& to, const Eigen::Vector3d& direction);

/// a . b for a direction of `from` and one of `to`.
Row perpendicular(const End& from, const End& to, const Eigen::Vector3d& a, const Eigen::Vector3d& b);

/// a . (r_from - r_to) for a direction of `from`.
Row in_plane(const End& from, const End& to, const Eigen::Vector3d& a);

/// Equal rotation of two shafts, the third columns of the triads: the axis of their relative rotation is perpendicular
/// to them. At velocity level, the relative spin lies in their bisecting plane.
Row equal_turns(const End& from, const End& to, const Eigen::Matrix3d& on_from, const Eigen::Matrix3d& on_to);

/// Contact point of a plane of `from` and a disc, ball or blade of `to`, moving over both, global axes.
struct RollingContact {
  Eigen::Vector3d place, rate;
};

/// Velocity of `from` minus velocity of `to` along a direction, at their contact; nonholonomic.
Row no_slip(const End& from, const End& to, const RollingContact& contact, const Eigen::Vector3d& direction,
            const Eigen::Vector3d& direction_rate);

/// Rows of a disc, ball or blade on the plane of `from` through its point. on_from: with the normal in the third
/// column; on_to: likewise the axle or blade. Requires: a nonholonomic type.
std::vector<Row> rolling(JointType type, const End& from, const End& to, const Eigen::Matrix3d& on_from,
                         const Eigen::Matrix3d& on_to, double radius);

/// (|r_from - r_to|^2 - length^2) / (2 length): residual in m, multiplier the tension of a massless rod in N.
Row distance(const End& from, const End& to, double length);

/// Zero spin of a massive rod about its own axis, which no force determines; nonholonomic.
Row no_spin(int rod, int ground, const Moving& motion);

}  // namespace mbgen::cartesian
