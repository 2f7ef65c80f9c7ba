#pragma once
// Energy and momentum of one body of the model, or of all bodies and rods.

#include "compiler/formulation/inertia.hpp"
#include "compiler/formulation/relative_motion.hpp"

namespace mbgen::detail {

/// Mass, momentum and kinetic energy of what was added, global axes.
template <class T>
struct MomentumSum {
  T mass{0.0}, twice_energy{0.0};   ///< kg, J
  Vector<T> first_moment;           ///< sum of mass times position, kg m
  Vector<T> momentum;               ///< kg m/s
  std::vector<Vector<T>> at, part;  ///< shares of the momentum and the points where they act
  Vector<T> spin;                   ///< angular momentum about those points, kg m^2/s

  void add_share(const Vector<T>& point, const Vector<T>& share) {
    at.push_back(point);
    part.push_back(share);
    momentum = momentum + share;
  }
  /// About a point, kg m^2/s.
  Vector<T> angular_momentum(const Vector<T>& about) const {
    Vector<T> sum = spin;
    for (std::size_t i = 0; i < at.size(); ++i) sum = sum + cross(at[i] - about, part[i]);
    return sum;
  }
};

template <class T>
void add_body(const System<T>& system, const SolvedState<T>& s, int body, MomentumSum<T>& sum) {
  const Kinematics<T>& k = s.kinematics;
  const int tree = system.topology.tree_body[body];
  const Vector<T> origin = carrier_origin(system.topology, system.constants, body);
  const Part<T> part = without_noise(part_of(system.model, body, origin, system.environment));
  const Place<T> centre{tree, part.com};
  const Vector<T> at = position_in(system, k, centre, kGround);
  sum.mass = sum.mass + part.mass;
  sum.first_moment = sum.first_moment + part.mass * at;
  if (tree == kGround) return;
  const int carrier = system.layout.frame_of(tree);
  const Vector<T> velocity = velocity_in(system, k, s.velocities, centre, carrier);
  const Matrix<T> axes = inertia_axes(system, k, tree);
  const Vector<T> w = transposed_times(axes, velocity_of(system, s.velocities, tree).angular);
  const Vector<T> spin = part.inertia * w;
  sum.twice_energy = sum.twice_energy + part.mass * dot(velocity, velocity) + dot(w, spin);
  sum.add_share(at, direction_in(system, k, carrier, part.mass * velocity, kGround));
  sum.spin = sum.spin + direction_in(system, k, carrier, axes * spin, kGround);
}

/// A uniform rod: each end has m/3 of its own velocity and m/6 of the other one's as its share of the momentum.
template <class T>
void add_rod(const System<T>& system, const SolvedState<T>& s, const RodConstants<T>& rod, MomentumSum<T>& sum) {
  if (is_zero(rod.coupling)) return;
  const Kinematics<T>& k = s.kinematics;
  const T sixth = rod.coupling, half = T(3.0) * rod.coupling;
  const Vector<T> from = position_in(system, k, rod.from, kGround), to = position_in(system, k, rod.to, kGround);
  const Vector<T> u = velocity_in(system, k, s.velocities, rod.from, kGround),
                  v = velocity_in(system, k, s.velocities, rod.to, kGround);
  sum.mass = sum.mass + half + half;
  sum.first_moment = sum.first_moment + half * (from + to);
  sum.twice_energy = sum.twice_energy + T(2.0) * sixth * (dot(u, u) + dot(u, v) + dot(v, v));
  sum.add_share(from, sixth * (u + u + v));
  sum.add_share(to, sixth * (u + v + v));
}

template <class T>
T momentum_output(const System<T>& system, const SolvedState<T>& s, const MomentumOutput& output) {
  using What = MomentumOutput::What;
  MomentumSum<T> sum;
  if (output.body != kNoBody) {
    add_body(system, s, output.body, sum);
  } else {
    for (int b = 0; b < static_cast<int>(system.model.bodies.size()); ++b)
      if (b != system.model.ground) add_body(system, s, b, sum);
    for (const RodConstants<T>& rod : system.constants.rods) add_rod(system, s, rod, sum);
  }
  if (output.what == What::kinetic_energy) return T(0.5) * sum.twice_energy;
  if (output.what == What::potential_energy) return -dot(system.constants.gravity, sum.first_moment);
  Vector<T> value = sum.momentum;
  if (output.what == What::angular_momentum && output.about.body >= 0)
    value = sum.angular_momentum(position_in(system, s.kinematics, place_of(system, output.about), kGround));
  else if (output.what == What::angular_momentum && output.body != kNoBody)
    value = sum.spin;
  else if (output.what == What::angular_momentum)
    value = sum.angular_momentum((T(1.0) / sum.mass) * sum.first_moment);
  return component(in_axes_of_any(system, s.kinematics, kGround, value, output.axes), output.axis);
}

}  // namespace mbgen::detail
