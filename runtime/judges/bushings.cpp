#include "runtime/judges/bushings.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <limits>

#include "runtime/judges/laws.hpp"

namespace mbgen::cartesian {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

Matrix3d cross_matrix(const Vector3d& v) {
  Matrix3d m;
  m << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return m;
}

/// The matrix J of spin = J dtheta/dt, for a rotation vector theta and the spin in the axes that it turns.
Matrix3d spin_of_rate(const Vector3d& theta) {
  const double angle = theta.norm();
  const Matrix3d cross = cross_matrix(theta);
  // Integral of the rotation by s theta over s from 0 to 1; near zero its first terms.
  if (angle < 1e-4) return Matrix3d::Identity() + cross / 2 + cross * cross / 6;
  const double half = std::sin(angle / 2) / angle;
  return Matrix3d::Identity() + 2 * half * half * cross +
         (1 - std::sin(angle) / angle) / (angle * angle) * cross * cross;
}

Vector3d rotation_vector(const Matrix3d& rotation) {
  const Eigen::AngleAxisd turn{Eigen::Quaterniond(rotation)};
  const double angle = std::remainder(turn.angle(), 2 * M_PI);
  if (std::abs(angle) > kLargestBushingTurn) return Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
  return angle * turn.axis();
}

Vector6d forces_of(const Bushing& bushing, const Vector6d& q, const Vector6d& rate, const double* extensions,
                   const Values& value, std::vector<double>& xd) {
  Vector6d force = Vector6d::Zero();
  const auto add = [&](const std::optional<BushingMatrix>& matrix, const Vector6d& at) {
    for (int i = 0; matrix && i < kBushingFreedoms; ++i)
      for (int j = 0; j < kBushingFreedoms; ++j)
        if (bushing_couples(matrix, i, j)) force[i] += value((*matrix)[kBushingFreedoms * i + j]) * at[j];
  };
  add(bushing.stiffness, q);
  add(bushing.damping, rate);
  for (int i = 0; i < kBushingFreedoms; ++i) {
    const std::optional<BushingFreedom>& own = bushing.freedoms[i];
    if (!own) continue;
    force[i] += value(own->preload) + law(own->stiffness, value, q[i]) + law(own->damping, value, rate[i]) +
                with_locals(own->force, value, q[i], rate[i]);
    if (!own->maxwell_stiffness) continue;
    const double extension = extensions[xd.size()];
    force[i] += value(*own->maxwell_stiffness) * extension;
    xd.push_back(rate[i] - extension / value(own->maxwell_time));
  }
  return force;
}

Load load_at(const Moving& body, int index, const Vector3d& place, const Vector3d& force, const Vector3d& moment) {
  return {index, (Vector6d() << force, moment + (place - body.position).cross(force)).finished()};
}

}  // namespace

BushingAtWork bushing_at_work(const Bushing& bushing, const PartFrames& part, const std::vector<Moving>& bodies,
                              const double* extensions, const Values& value) {
  const Moving &from_body = bodies[part.from.body], &to_body = bodies[part.to.body];
  const End from = end_of(bodies, part.from), to = end_of(bodies, part.to);
  const Matrix3d axes = from_body.axes * part.axes_from;  // of the bushing now, global
  const Vector3d theta = rotation_vector(axes.transpose() * to_body.axes * part.axes_to);
  const Matrix3d spin = spin_of_rate(theta);
  const Vector3d gap = to.position - from.position;
  Vector6d sense, q, rate;
  for (int i = 0; i < kBushingFreedoms; ++i) sense[i] = bushing_sense(bushing, i);
  q << axes.transpose() * gap, theta;
  const Vector3d drift = to.velocity - from.velocity - from_body.spin.cross(gap);
  rate << axes.transpose() * drift, spin.inverse() * (axes.transpose() * (to_body.spin - from_body.spin));
  q = q.cwiseProduct(sense);
  rate = rate.cwiseProduct(sense);
  BushingAtWork result;
  result.deflection = q;
  const Vector6d force = forces_of(bushing, q, rate, extensions, value, result.xd).cwiseProduct(sense);
  result.force = force.head<3>();
  const bool turns = bushing_acts(bushing, 3) || bushing_acts(bushing, 4) || bushing_acts(bushing, 5);
  result.moment = turns ? Vector3d(spin.transpose().inverse() * force.tail<3>()) : Vector3d::Zero();
  const Vector3d global_force = axes * result.force, global_moment = axes * result.moment;
  result.on_from = load_at(from_body, part.from.body, to.position, global_force, global_moment);
  result.on_to = load_at(to_body, part.to.body, to.position, -global_force, -global_moment);
  return result;
}

void add_bushings(const Model& model, const Parts& parts, const std::vector<Moving>& bodies,
                  const std::vector<double>& x, const Values& values, Forces& forces) {
  const double* extensions = x.data() + slip_state_count(model);
  for (std::size_t b = 0; b < model.bushings.size(); ++b) {
    const BushingAtWork bushing = bushing_at_work(model.bushings[b], parts.bushings[b], bodies, extensions, values);
    forces.loads.push_back(bushing.on_from);
    forces.loads.push_back(bushing.on_to);
    forces.xd.insert(forces.xd.end(), bushing.xd.begin(), bushing.xd.end());
    extensions += bushing.xd.size();
  }
}

}  // namespace mbgen::cartesian
