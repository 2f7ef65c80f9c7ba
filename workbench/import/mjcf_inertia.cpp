// MJCF: effective inertias of coordinates at the reference; springs and dampers from them.
#include <fmt/format.h>

#include <cmath>

#include "compiler/algebra/dense.hpp"
#include "workbench/import/mjcf.hpp"

namespace mbgen::importing {
namespace {

using Eigen::MatrixXd;

constexpr Eigen::Index kMostFreedoms = 3000;  // of a dense matrix

/// A freedom of a joint of the tree: a rotation about an axis through a point, or a translation along it, global.
struct Freedom {
  bool turns = true;
  Vector3d axis = Vector3d::UnitZ(), at = Vector3d::Zero();
  Vector3d velocity(const Vector3d& point) const { return turns ? axis.cross(point - at) : axis; }
};

std::vector<Freedom> freedoms_of(const JointDraft& joint) {
  if (joint.type == JointType::revolute) return {{true, joint.axis, joint.at}};
  if (joint.type == JointType::prismatic) return {{false, joint.axis, joint.at}};
  std::vector<Freedom> freedoms;
  for (int i = 0; i < 3 && joint.type == JointType::free; ++i) freedoms.push_back({false, Vector3d::Unit(i), joint.at});
  for (int i = 0; i < 3 && joint.type != JointType::fixed; ++i) freedoms.push_back({true, Vector3d::Unit(i), joint.at});
  return freedoms;
}

/// Columns of a joint in the mass matrix.
struct JointColumns {
  std::vector<Freedom> freedoms;
  Eigen::Index first = 0;
};

/// Contribution of a body to the mass matrix of the joints between it and the ground.
void add_body(const Assembly& assembly, const std::vector<JointColumns>& columns, const std::vector<int>& joint_of,
              std::size_t index, MatrixXd& mass) {
  const BodyDraft& body = assembly.bodies[index];
  if (body.mass == 0 && body.inertia.isZero(0)) return;
  const Vector3d centre = body.pose * body.com;
  const Matrix3d inertia = body.pose.linear() * body.inertia * body.pose.linear().transpose();
  std::vector<std::pair<Eigen::Index, const Freedom*>> moving;
  for (int at = static_cast<int>(index); at != kGroundDraft && joint_of[static_cast<std::size_t>(at)] >= 0;) {
    const auto joint = static_cast<std::size_t>(joint_of[static_cast<std::size_t>(at)]);
    for (std::size_t k = 0; k < columns[joint].freedoms.size(); ++k)
      moving.emplace_back(columns[joint].first + static_cast<Eigen::Index>(k), &columns[joint].freedoms[k]);
    at = assembly.joints[joint].from;
  }
  for (const auto& [i, one] : moving) {
    for (const auto& [j, other] : moving) {
      mass(i, j) += body.mass * one->velocity(centre).dot(other->velocity(centre));
      if (one->turns && other->turns) mass(i, j) += one->axis.dot(inertia * other->axis);
    }
  }
}

}  // namespace

void find_inertias(Mjcf& mjcf) {
  const Assembly& assembly = mjcf.assembly;
  std::vector<JointColumns> columns;
  std::vector<int> joint_of(assembly.bodies.size(), -1);
  Eigen::Index size = 0;
  for (std::size_t i = 0; i < assembly.joints.size(); ++i) {
    columns.push_back({freedoms_of(assembly.joints[i]), size});
    if (assembly.joints[i].cut) {
      columns.back().freedoms.clear();
      continue;
    }
    size += static_cast<Eigen::Index>(columns.back().freedoms.size());
    joint_of[static_cast<std::size_t>(assembly.joints[i].to)] = static_cast<int>(i);
  }
  if (size > kMostFreedoms) {
    problem(mjcf.reading, {}, fmt::format("springdamper and dampratio are not read in models of {} freedoms", size),
            "give stiffness and damping, or kp and kv");
    return;
  }
  MatrixXd mass = MatrixXd::Zero(size, size);
  for (std::size_t i = 1; i < assembly.bodies.size(); ++i) add_body(assembly, columns, joint_of, i, mass);
  std::map<std::string, Eigen::Index> column_of;
  for (std::size_t i = 0; i < columns.size(); ++i) column_of[assembly.joints[i].name] = columns[i].first;
  for (const MjcfJoint& joint : mjcf.scalar_joints) {
    const Eigen::Index i = column_of.at(joint.coordinate);
    mass(i, i) += joint.armature;
  }
  const MatrixXd inverse = size > 0 ? solved(mass, MatrixXd::Identity(size, size)) : mass;
  for (const MjcfJoint& joint : mjcf.scalar_joints) {
    const Eigen::Index i = column_of.at(joint.coordinate);
    mjcf.inertia_of[joint.coordinate] = mass(i, i);
    mjcf.felt_inertia_of[joint.coordinate] = 1 / inverse(i, i);
  }
}

void add_spring_dampers(Mjcf& mjcf) {
  if (mjcf.spring_dampers.empty()) return;
  find_inertias(mjcf);
  for (const MjcfSpringDamper& made : mjcf.spring_dampers) {
    const double inertia = mjcf.felt_inertia_of[made.coordinate], time = made.time_constant;
    if (!(inertia > 0) || !std::isfinite(inertia)) {
      problem(mjcf.reading, {},
              fmt::format("joint {}: springdamper needs an inertia that moves, it is {:.6g}",
                          quoted_text(made.coordinate), inertia));
      continue;
    }
    const double stiffness = inertia / (time * time * made.damping_ratio * made.damping_ratio);
    add_joint_forces(mjcf.assembly, made.coordinate, mjcf.settings.has_springs ? stiffness : 0,
                     mjcf.settings.has_dampers ? 2 * inertia / time : 0, made.free, 0);
  }
}

}  // namespace mbgen::importing
