#include "compiler/analysis/tree_inertia.hpp"

#include <Eigen/Dense>
#include <Eigen/Geometry>

namespace mbgen {
namespace {

using Vector3d = Eigen::Vector3d;
using Matrix6d = Eigen::Matrix<double, 6, 6>;
using Vector6d = Eigen::Matrix<double, 6, 1>;

Vector3d eigen_vector(const Vector<double>& v) { return {v.x, v.y, v.z}; }

Eigen::Matrix3d cross_matrix(const Vector3d& v) {
  Eigen::Matrix3d m;
  m << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return m;
}

/// Motion about a point from that about another, which lies at `apart` from it: velocity of the point, angular
/// velocity.
Matrix6d shift_by(const Vector3d& apart) {
  Matrix6d shift = Matrix6d::Identity();
  shift.topRightCorner<3, 3>() = -cross_matrix(apart);
  return shift;
}

/// Where a body is, axes of the ground.
struct TreePose {
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();  ///< from the reference
  Vector3d origin = Vector3d::Zero();                  ///< m
};

/// Inertia of one body about its origin.
Matrix6d own_inertia(const Constants<double>& constants, int i, const Eigen::Matrix3d& turn) {
  const Symmetric<double>& c = constants.inertia[i];
  Eigen::Matrix3d central;
  central << c.xx, c.xy, c.xz, c.xy, c.yy, c.yz, c.xz, c.yz, c.zz;
  Matrix6d about_com = Matrix6d::Zero();
  about_com.diagonal().head<3>().setConstant(constants.mass[i]);
  about_com.bottomRightCorner<3, 3>() = turn * central * turn.transpose();
  const Matrix6d shift = shift_by(turn * eigen_vector(constants.com[i]));
  return shift.transpose() * about_com * shift;
}

}  // namespace

bool tree_has_inertia(const Topology& topology, const Constants<double>& constants, const std::vector<bool>& driven,
                      std::span<const double> z, std::span<const double> rounding) {
  const auto n = static_cast<std::size_t>(topology.size());
  std::vector<TreePose> poses(n);
  std::vector<Vector6d> columns(n);
  std::vector<Matrix6d> articulated(n), composite(n);
  for (std::size_t i = 0; i < n; ++i) {
    const TreeBody& body = topology.bodies[i];
    const TreePose parent = body.parent == kGround ? TreePose{} : poses[body.parent];
    const Vector3d reference = body.parent == kGround ? Vector3d::Zero() : eigen_vector(constants.origin[body.parent]);
    const Vector3d axis(body.axis[0], body.axis[1], body.axis[2]), along = parent.turn * axis;
    const bool turns = body.kind == FreedomKind::revolute;
    poses[i].origin = parent.origin + parent.turn * (eigen_vector(constants.origin[i]) - reference);
    poses[i].turn = turns ? parent.turn * Eigen::AngleAxisd(z[i], axis).toRotationMatrix() : parent.turn;
    if (!turns) poses[i].origin += z[i] * along;
    columns[i].setZero();
    (turns ? columns[i].tail<3>() : columns[i].head<3>()) = along;
    articulated[i] = composite[i] = own_inertia(constants, static_cast<int>(i), poses[i].turn);
  }
  const double left = inertia_left_by_rounding(constants);
  for (std::size_t i = n; i-- > 0;) {
    Matrix6d passed = articulated[i];
    if (!driven[i]) {
      const Vector6d momentum = articulated[i] * columns[i];
      const double pivot = columns[i].dot(momentum);
      if (!(pivot - 1e-12 * columns[i].dot(composite[i] * columns[i]) - left > rounding[i])) return false;
      passed -= momentum * momentum.transpose() / pivot;
    }
    const int parent = topology.bodies[i].parent;
    if (parent == kGround) continue;
    const Matrix6d shift = shift_by(poses[i].origin - poses[parent].origin);
    articulated[parent] += shift.transpose() * passed * shift;
    composite[parent] += shift.transpose() * composite[i] * shift;
  }
  return true;
}

}  // namespace mbgen
