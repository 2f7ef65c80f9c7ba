#include "runtime/judges/joint_coordinates.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "mbgen/solver/newton.hpp"

namespace mbgen::cartesian {
namespace {

using Eigen::AngleAxisd;
using Eigen::Matrix3d;
using Eigen::Vector3d;
/// One column, or row, per rotation of a joint.
using Columns = Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, 3>;
using Inverse = Eigen::Matrix<double, Eigen::Dynamic, 3, 0, 3, 3>;
using Angles = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 3, 1>;

double nearest_turn(double angle, double guess) {
  return angle - 2 * std::numbers::pi * std::round((angle - guess) / (2 * std::numbers::pi));
}

/// Axes of successive rotations, each rotated by the previous ones, in the axes of the first.
Columns carried_axes(const std::vector<Vector3d>& axes, const Angles& angles) {
  Columns columns(3, axes.size());
  Matrix3d turn = Matrix3d::Identity();
  for (std::size_t k = 0; k < axes.size(); ++k) {
    columns.col(k) = turn * axes[k];
    turn = turn * AngleAxisd(angles[k], axes[k]);
  }
  return columns;
}

Matrix3d turned(const std::vector<Vector3d>& axes, const Angles& angles) {
  Matrix3d turn = Matrix3d::Identity();
  for (std::size_t k = 0; k < axes.size(); ++k) turn = turn * AngleAxisd(angles[k], axes[k]);
  return turn;
}

/// Rates of the angles from an angular velocity; least squares if it has other components.
Inverse rates_of(const Columns& columns) {
  if (columns.cols() == 3) return Matrix3d(columns).inverse();
  if (columns.cols() == 1) return columns.transpose() / columns.squaredNorm();
  const Eigen::Matrix<double, 3, 2> two = columns;
  return (two.transpose() * two).inverse() * two.transpose();
}

/// Angle of a rotation about one axis.
double angle_about(const Vector3d& axis, const Matrix3d& turn) {
  const Vector3d first = axis.unitOrthogonal(), second = axis.cross(first);
  return std::atan2(second.dot(turn * first) - first.dot(turn * second),
                    first.dot(turn * first) + second.dot(turn * second));
}

/// Angles of three rotations about mutually perpendicular axes, in every position; of the two possible triples the one
/// nearer to a guess.
Angles ball_angles(const std::vector<Vector3d>& axes, const Matrix3d& turn, const Angles& guess) {
  Matrix3d basis;
  basis << axes[0], axes[1], axes[0].cross(axes[1]);
  const Matrix3d m = basis.transpose() * turn * basis;
  const double hand = axes[2].dot(basis.col(2)) > 0 ? 1 : -1;
  const double first = m(1, 2) == 0 && m(2, 2) == 0 ? guess[0] : std::atan2(-m(1, 2), m(2, 2));
  const Matrix3d left = AngleAxisd(-first, Vector3d::UnitX()) * m;
  const double second = std::atan2(left(0, 2), left(2, 2)), third = hand * std::atan2(left(1, 0), left(1, 1));
  Angles best(3);
  double least = INFINITY;
  for (const double half : {0.0, std::numbers::pi}) {
    Angles other(3);
    other << first + half, half > 0 ? half - second : second, third + half;
    for (int k = 0; k < 3; ++k) other[k] = nearest_turn(other[k], guess[k]);
    if (const double distance = (other - guess).norm(); distance < least) {
      least = distance;
      best = other;
    }
  }
  return best;
}

bool are_square(const std::vector<Vector3d>& axes) {
  constexpr double kSquare = 1e-12;
  return axes.size() == 3 && std::abs(axes[0].dot(axes[1])) < kSquare && std::abs(axes[1].dot(axes[2])) < kSquare &&
         std::abs(axes[0].dot(axes[2])) < kSquare;
}

/// Angles of a sequence with product `turn`, nearest to a guess: two by Newton's method.
Angles sequence_angles(const std::vector<Vector3d>& axes, const Matrix3d& turn, Angles angles) {
  if (axes.size() == 1) angles[0] = nearest_turn(angle_about(axes[0], turn), angles[0]);
  if (axes.size() <= 1) return angles;
  if (are_square(axes)) return ball_angles(axes, turn, angles);
  for (int step = 0; step < kSearchIterations; ++step) {
    const AngleAxisd error(Eigen::Quaterniond(turn * turned(axes, angles).transpose()));
    Angles change = rates_of(carried_axes(axes, angles)) * (error.angle() * error.axis());
    const double length = change.norm();
    change *= shortening(length, kLargestNewtonStep<double>);
    angles += change;
    if (!(length > kLastStep)) break;
  }
  return angles;
}

/// Motion of a joint's bodies relative to `from`, in its axes rotated back to the reference configuration.
struct RelativeMotion {
  End from, to;
  Matrix3d axes;         ///< those axes, global
  Matrix3d turn;         ///< of `to` in them
  Vector3d spin;         ///< of `to` relative to `from`, in these axes
  Vector3d spin_change;  ///< rate of `spin` for bodies without angular acceleration
};

RelativeMotion relative_motion(const PartJoint& joint, const std::vector<Part>& parts,
                               const std::vector<Moving>& bodies) {
  const int f = joint.from.body, t = joint.to.body;
  RelativeMotion m{end_of(bodies, joint.from), end_of(bodies, joint.to), {}, {}, {}, {}};
  m.axes = bodies[f].axes * parts[f].axes.transpose();
  m.turn = m.axes.transpose() * bodies[t].axes * parts[t].axes.transpose();
  m.spin = m.axes.transpose() * (m.to.spin - m.from.spin);
  m.spin_change = -(m.axes.transpose() * m.from.spin.cross(m.to.spin));
  return m;
}

JointCoordinate translation(const RelativeMotion& m, const PartFreedom& freedom) {
  Row row = in_plane(m.from, m.to, m.axes * freedom.axis);
  row.on_from = -row.on_from;
  row.on_to = -row.on_to;
  row.residual = -row.residual;
  row.bias = -row.bias;
  const double relative = (m.axes * freedom.axis).dot(m.to.velocity - m.from.velocity) -
                          m.from.spin.cross(m.axes * freedom.axis).dot(m.from.position - m.to.position);
  return {freedom.coordinate, relative, row};
}

void add_rotations(const RelativeMotion& m, const PartJoint& joint, const std::vector<double>& guess,
                   std::vector<JointCoordinate>& coordinates) {
  std::vector<Vector3d> axes;
  Angles angles(3);
  std::vector<int> index;
  for (const PartFreedom& freedom : joint.freedoms) {
    if (freedom.kind != FreedomKind::revolute) continue;
    angles[static_cast<int>(axes.size())] = guess[freedom.coordinate];
    axes.push_back(freedom.axis);
    index.push_back(freedom.coordinate);
  }
  if (axes.empty()) return;
  angles = sequence_angles(axes, m.turn, Angles(angles.head(axes.size())));
  const Columns columns = carried_axes(axes, angles);
  const Inverse inverse = rates_of(columns);
  const Angles rates = inverse * m.spin;
  Vector3d carried = Vector3d::Zero(), change = m.spin_change;  // part of the change is due to the axes' own rates
  for (std::size_t k = 0; k < axes.size(); ++k) {
    change -= rates[k] * carried.cross(columns.col(k));
    carried += rates[k] * columns.col(k);
  }
  for (std::size_t k = 0; k < axes.size(); ++k) {
    const Vector3d turn = m.axes * inverse.row(k).transpose();
    const Vector6d on_to = (Vector6d() << Vector3d::Zero(), turn).finished();
    coordinates.push_back(
        {index[k], rates[k], Row{m.from.body, m.to.body, -on_to, on_to, angles[k], 0, -inverse.row(k).dot(change)}});
  }
}

}  // namespace

std::vector<JointCoordinate> joint_coordinates(const PartJoint& joint, const std::vector<Part>& parts,
                                               const std::vector<Moving>& bodies, const std::vector<double>& guess) {
  std::vector<JointCoordinate> coordinates;
  if (joint.freedoms.empty()) return coordinates;
  const RelativeMotion m = relative_motion(joint, parts, bodies);
  for (const PartFreedom& freedom : joint.freedoms)
    if (freedom.kind == FreedomKind::prismatic) coordinates.push_back(translation(m, freedom));
  add_rotations(m, joint, guess, coordinates);
  return coordinates;
}

}  // namespace mbgen::cartesian
