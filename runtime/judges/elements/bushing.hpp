#pragma once
// Bushings: deflection by rotation vectors, law, and loads on the bodies.

#include <Eigen/Geometry>
#include <limits>

#include "runtime/judges/elements/at_work.hpp"

namespace mbgen::cartesian {

/// A bushing at one instant.
struct BushingAtWork {
  Vector6d deflection;            ///< m, then rad, with the sense of its freedoms
  Eigen::Vector3d force, moment;  ///< on `from`, in the bushing's axes, at the point of `to`: N, N m
  Load on_from, on_to;
  std::vector<double> xd;  ///< rates of the extensions of its Maxwell branches
};

inline Eigen::Matrix3d cross_matrix(const Eigen::Vector3d& v) {
  Eigen::Matrix3d m;
  m << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return m;
}

/// The matrix J of spin = J dtheta/dt, for a rotation vector theta and the spin in the rotated axes.
inline Eigen::Matrix3d spin_of_rate(const Eigen::Vector3d& theta) {
  const double angle = theta.norm();
  const Eigen::Matrix3d cross = cross_matrix(theta);
  // Integral of the rotation by s theta over s from 0 to 1; near zero its first terms.
  if (angle < 1e-4) return Eigen::Matrix3d::Identity() + cross / 2 + cross * cross / 6;
  const double half = std::sin(angle / 2) / angle;
  return Eigen::Matrix3d::Identity() + 2 * half * half * cross +
         (1 - std::sin(angle) / angle) / (angle * angle) * cross * cross;
}

inline Eigen::Vector3d rotation_vector(const Eigen::Matrix3d& rotation) {
  const Eigen::AngleAxisd turn{Eigen::Quaterniond(rotation)};
  const double angle = std::remainder(turn.angle(), 2 * M_PI);
  if (std::abs(angle) > kLargestBushingTurn) return Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
  return angle * turn.axis();
}

inline Vector6d forces_of(const Bushing& bushing, const Vector6d& q, const Vector6d& rate, const double* extensions,
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

inline Load load_at(const Moving& body, int index, const Eigen::Vector3d& place, const Eigen::Vector3d& force,
                    const Eigen::Vector3d& moment) {
  return {index, (Vector6d() << force, moment + (place - body.position).cross(force)).finished()};
}

/// extensions: of its Maxwell branches. Not a number for a relative rotation beyond kLargestBushingTurn.
inline BushingAtWork bushing_at_work(const Bushing& bushing, const ElementPart& part, const std::vector<Moving>& bodies,
                                     const double* extensions, const Values& value) {
  const Moving &from_body = bodies[part.from.body], &to_body = bodies[part.to.body];
  const End from = end_of(bodies, part.from), to = end_of(bodies, part.to);
  const Eigen::Matrix3d axes = from_body.axes * part.axes_from;  // of the bushing now, global
  const Eigen::Vector3d theta = rotation_vector(axes.transpose() * to_body.axes * part.axes_to);
  const Eigen::Matrix3d spin = spin_of_rate(theta);
  const Eigen::Vector3d gap = to.position - from.position;
  Vector6d sense, q, rate;
  for (int i = 0; i < kBushingFreedoms; ++i) sense[i] = bushing_sense(bushing, i);
  q << axes.transpose() * gap, theta;
  const Eigen::Vector3d drift = to.velocity - from.velocity - from_body.spin.cross(gap);
  rate << axes.transpose() * drift, spin.inverse() * (axes.transpose() * (to_body.spin - from_body.spin));
  q = q.cwiseProduct(sense);
  rate = rate.cwiseProduct(sense);
  BushingAtWork result;
  result.deflection = q;
  const Vector6d force = forces_of(bushing, q, rate, extensions, value, result.xd).cwiseProduct(sense);
  result.force = force.head<3>();
  const bool turns = bushing_acts(bushing, 3) || bushing_acts(bushing, 4) || bushing_acts(bushing, 5);
  result.moment = turns ? Eigen::Vector3d(spin.transpose().inverse() * force.tail<3>()) : Eigen::Vector3d::Zero();
  const Eigen::Vector3d global_force = axes * result.force, global_moment = axes * result.moment;
  result.on_from = load_at(from_body, part.from.body, to.position, global_force, global_moment);
  result.on_to = load_at(to_body, part.to.body, to.position, -global_force, -global_moment);
  return result;
}

/// Extensions of its Maxwell branches.
inline const double* extensions_of(const AtWork& at, const Bushing& bushing) {
  return at.x.data() + state_of_element(at.c.model, bushing);
}

inline BushingAtWork bushing_at_work(const AtWork& at, const Bushing& bushing) {
  return bushing_at_work(bushing, part_of(at, bushing), at.bodies, extensions_of(at, bushing), at.value);
}

inline void apply(const AtWork& at, const Bushing& bushing, Forces& forces) {
  const BushingAtWork at_work = bushing_at_work(at, bushing);
  forces.loads.push_back(at_work.on_from);
  forces.loads.push_back(at_work.on_to);
  std::copy(at_work.xd.begin(), at_work.xd.end(), forces.xd.data() + state_of_element(at.c.model, bushing));
}

inline double shown(const AtWork& at, const Forces&, const Bushing& bushing, int quantity, int axis) {
  enum Quantity { force, moment, deflection, rotation_vector };
  const BushingAtWork at_work = bushing_at_work(at, bushing);
  const bool turns = quantity == moment || quantity == rotation_vector;
  const int place = axis + (turns ? 3 : 0);
  if (quantity >= deflection) return at_work.deflection[place];
  const Eigen::Vector3d& acts = turns ? at_work.moment : at_work.force;
  return -bushing_sense(bushing, place) * acts[axis];
}

inline double energy_of(const AtWork& at, const Bushing& bushing) {
  const Values& value = at.value;
  const double* extensions = extensions_of(at, bushing);
  const Vector6d q = bushing_at_work(at, bushing).deflection;
  Eigen::Matrix<double, kBushingFreedoms, kBushingFreedoms> stiffness;
  stiffness.setZero();
  double energy = 0;
  for (int i = 0; i < kBushingFreedoms; ++i) {
    for (int j = 0; bushing.stiffness && j < kBushingFreedoms; ++j)
      stiffness(i, j) = value((*bushing.stiffness)[kBushingFreedoms * i + j]);
    const std::optional<BushingFreedom>& own = bushing.freedoms[i];
    if (!own) continue;
    energy += work_of(own->stiffness, value, q[i]) + value(own->preload) * q[i];
    if (!own->maxwell_stiffness) continue;
    energy += value(*own->maxwell_stiffness) * *extensions * *extensions / 2;
    ++extensions;
  }
  return energy + q.dot(stiffness * q) / 2;
}

}  // namespace mbgen::cartesian
