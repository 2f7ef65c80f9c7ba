// Energy that parts of a mechanism give and take, element by element and body by body.

#include "runtime/generic/equations.hpp"
#include "runtime/generic/generic.hpp"

namespace mbgen {
namespace {

/// Powers of forces on a motion, one per element.
std::vector<double> element_powers(const System<double>& system, const AppliedForces<double>& forces,
                                   const Velocities<double>& v) {
  std::vector<double> powers;
  const auto add = [&](int element, double power) {
    const auto place = static_cast<std::size_t>(element);
    if (place >= powers.size()) powers.resize(place + 1, 0.0);
    powers[place] += power;
  };
  for (const Action<double>& action : forces.actions) {
    const int body = system.topology.tree_body[action.body];
    if (body == kGround) continue;
    Spatial<double> wrench = force_at(action.force, action.point);
    wrench.angular = wrench.angular + action.moment;
    add(action.element, dot(wrench, velocity_of(system, v, body)));
  }
  for (const JointAction<double>& action : forces.joint_actions)
    add(action.element, action.force * system.zd(action.coordinate));
  return powers;
}

/// Applied forces by velocities v, elements counted from one.
AppliedForces<double> counted_forces(System<double>& system, const Kinematics<double>& k, const Velocities<double>& v,
                                     const mbgen::detail::SharedTyreLaw<double>& law = {}) {
  system.annotator.parts = 0;
  return applied_forces(system, k, v, law);
}

/// Applied forces as they are at rest in the position of the system; tyres, which act by rolling and slip, give none.
AppliedForces<double> forces_at_rest(System<double>& system, const Kinematics<double>& k) {
  Environment<double>& environment = system.environment;
  const std::vector<double> zd = environment.zd, users_zd = environment.users_zd;
  environment.zd.assign(zd.size(), 0.0);
  environment.users_zd.assign(users_zd.size(), 0.0);
  const auto no_tyre = [](std::size_t, const TyreProperties<double>&, const WheelMotion<double>&) {
    return std::optional<WheelForces<double>>(WheelForces<double>{});
  };
  AppliedForces<double> forces = counted_forces(system, k, velocities(system, k), no_tyre);
  environment.zd = zd;
  environment.users_zd = users_zd;
  return forces;
}

/// Gravity in the axes of each frame that carries bodies, from frame to frame.
std::vector<Vector<double>> gravity_in_frames(const System<double>& system, const Kinematics<double>& k) {
  std::vector<Vector<double>> down(system.topology.bodies.size());
  for (int i = 0; i < system.topology.size(); ++i) {
    if (system.layout.frame_of(i) != i) continue;
    const int base = system.layout.bodies[i].base;
    down[i] = transposed_times(k.orientation[i], base == kGround ? system.constants.gravity : down[base]);
  }
  return down;
}

/// Kinetic energies of the bodies and power of gravity on each.
void add_bodies(const System<double>& system, const Kinematics<double>& k, const Velocities<double>& v,
                GenericExchanges& e) {
  const Constants<double>& c = system.constants;
  const std::vector<Vector<double>> gravity = gravity_in_frames(system, k);
  for (int i = 0; i < system.topology.size(); ++i) {
    const Spatial<double> velocity = velocity_of(system, v, i);
    const Vector<double> at_com = velocity_at(velocity, inertia_arm(system, k, i, c.com[i], v.about));
    const Vector<double> w = transposed_times(inertia_axes(system, k, i), velocity.angular),
                         momentum = c.inertia[i] * w;
    const int frame = system.layout.frame_of(i);
    const Vector<double> down = frame == kGround ? c.gravity : gravity[frame];
    e.powers.push_back(c.mass[i] * dot(down, at_com));
    e.kinetic.push_back(0.5 * c.mass[i] * dot(at_com, at_com));
    for (const double part : {w.x * momentum.x, w.y * momentum.y, w.z * momentum.z}) e.kinetic.push_back(0.5 * part);
  }
}

}  // namespace

GenericExchanges GenericSolver::exchanges(const GenericState& state) const {
  System<double>& system = equations_->system(state);
  const Kinematics<double> k = kinematics(system);
  const AppliedForces<double> at_rest = forces_at_rest(system, k);
  const Velocities<double> v = velocities(system, k);
  const AppliedForces<double> forces = counted_forces(system, k, v);
  std::vector<double> by_position = element_powers(system, at_rest, v);
  std::vector<double> by_velocity = element_powers(system, forces, v);
  const std::size_t elements = std::max(by_position.size(), by_velocity.size());
  by_position.resize(elements, 0.0);
  by_velocity.resize(elements, 0.0);
  GenericExchanges e;
  for (const double power : by_velocity) e.applied += power;
  e.powers = by_position;
  for (std::size_t i = 0; i < elements; ++i) e.powers.push_back(by_velocity[i] - by_position[i]);
  add_bodies(system, k, v, e);
  return e;
}

}  // namespace mbgen
