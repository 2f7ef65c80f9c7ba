#pragma once
// Friction on coordinates, along springs and in rod ends.

#include <functional>

#include "mbgen/solver/bristle.hpp"
#include "mbgen/solver/forces.hpp"
#include "runtime/judges/elements/at_work.hpp"

namespace mbgen::cartesian {

/// Force of a friction, N m or N, on the part that moves at `rate`, and the rates of its bristles.
template <class Friction>
double friction_at(const AtWork& at, const Friction& f, double rate, Forces& forces) {
  const Values& value = at.value;
  double force = 0;
  if (f.has_bristle()) {
    const Bristles<double> bristles{value(f.coulomb),   value(f.stiction), value(f.stribeck_velocity),
                                    value(f.stiffness), value(f.damping),  *f.lag};
    const std::size_t state = state_of_element(value.model, f);
    const BristleResult<double> result = f.kind == FrictionLaw::Kind::lugre
                                             ? lugre_friction(bristles, at.x[state], rate)
                                             : elasto_plastic_friction(bristles, value(f.elastic), at.x[state], rate);
    forces.xd[state] = result.rate;
    force = result.force;
  } else {
    force =
        friction_force(value(f.coulomb), value(f.stiction), 0.0, value(f.velocity), value(f.stribeck_velocity), rate);
  }
  if (f.normal >= 0) force *= std::abs(forces.springs[static_cast<std::size_t>(f.normal)].own);
  if (f.load >= 0) force *= std::abs(value.states[value.model.states.size() + static_cast<std::size_t>(f.load)]);
  return force - value(f.viscous) * rate;
}

inline void apply(const AtWork& at, const JointFriction& friction, Forces& forces) {
  double rate = at.value.velocity(friction.joint);
  if (friction.relative_to) rate -= at.value.velocity(*friction.relative_to);
  const double force = friction_at(at, friction, rate, forces);
  add_on_coordinate(at, friction.joint, force, forces);
  if (friction.relative_to) add_on_coordinate(at, *friction.relative_to, -force, forces);
}

inline void apply(const AtWork& at, const SpringFriction& friction, Forces& forces) {
  const ElementPart& part = part_of(at, at.c.model.springs[static_cast<std::size_t>(friction.spring)]);
  const Line line = line_between(part.from, part.to, at.bodies);
  const double pull = -friction_at(at, friction, line.rate, forces);
  add_tension(line, pull, forces);
  forces.springs[static_cast<std::size_t>(friction.spring)].force += pull;
}

/// Moment against the rotation of a body relative to a rod, in the joint at the rod's end, perpendicular to the rod's
/// line. Forces at the rod's ends balance it, in addition to those of its own equations. moment: N m, over the angular
/// speed, rad/s, against it.
inline void add_rod_friction(const PartRod& rod, bool at_from, const std::vector<Moving>& bodies,
                             const std::function<double(double)>& moment, Forces& forces) {
  const Line line = line_between(rod.from, rod.to, bodies);
  const End& end = at_from ? line.from : line.to;
  const Eigen::Vector3d& axis = line.direction;
  const Eigen::Vector3d rod_spin =
      rod.body >= 0 ? bodies[static_cast<std::size_t>(rod.body)].spin
                    : Eigen::Vector3d(axis.cross(line.to.velocity - line.from.velocity) / line.length);
  const Eigen::Vector3d relative = end.spin - rod_spin, turn = relative - axis.dot(relative) * axis;
  const double rate = turn.norm();
  if (rate == 0) return;
  const Eigen::Vector3d on_body = moment(rate) / rate * turn;
  forces.loads.push_back({end.body, (Vector6d() << Eigen::Vector3d::Zero(), on_body).finished()});
  // Equilibrium of the rod under the pair: (to - from) x pair = -on_body.
  const Eigen::Vector3d pair = on_body.cross(-axis) / line.length;
  forces.loads.push_back(force_at(line.to, pair));
  forces.loads.push_back(force_at(line.from, -pair));
}

inline void apply(const AtWork& at, const RodFriction& friction, Forces& forces) {
  const auto moment = [&](double rate) { return friction_at(at, friction, rate, forces); };
  add_rod_friction(at.c.parts.rods[static_cast<std::size_t>(friction.rod)], friction.at_from, at.bodies, moment,
                   forces);
}

}  // namespace mbgen::cartesian
