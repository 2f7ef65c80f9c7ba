#pragma once
// Recursive form, on the way out: constants, velocities (step 4), accelerations at zero free ones, motion per free
// direction (steps 3 and 6).

#include "compiler/formulation/recursion/recursion_names.hpp"

namespace mbgen::detail {

/// The constants of a body whose origin is the foot of its centre of mass: nothing but rounding is left along the axis.
template <class T>
PseudoInertia<T> without_noise(PseudoInertia<T> m, const SlidOrigin& slid) {
  if (slid.component < 0) return m;
  T& along = slid.component == 0 ? m.moment.x : slid.component == 1 ? m.moment.y : m.moment.z;
  along = mbgen::without_noise(along, 8 * known_size(m.mass) * std::abs(slid.value));
  m.second = entries_without_noise(m.second, m.trace);
  return m;
}

/// Constants of the bodies, named m_, h_ (first moments) and K_ (second moments): rods' ends of m/2 (the rest is the
/// rod's dyad, see add_rods) and locked rotors.
template <class T>
void set_constants(RecursionState<T>& s) {
  const System<T>& system = s.system();
  const Constants<T>& c = system.constants;
  const std::size_t n = system.topology.bodies.size();
  for (std::size_t i = 0; i < n; ++i) s.constant.push_back(from_central(c.mass[i], c.com[i], c.inertia[i]));
  const auto point_mass = [](const T& mass, const Vector<T>& at) {
    return pseudo_inertia(mass, mass * at, square(mass, at));
  };
  for (const RodConstants<T>& rod : c.rods)
    for (const Place<T>& end : {rod.from, rod.to})
      if (end.body != kGround && !is_zero(rod.coupling))
        s.constant[end.body] = s.constant[end.body] + point_mass(rod.coupling, end.at);
  s.polar.assign(n, T(0.0));
  for (const RecursionUnit& unit : s.units()) {
    if (!unit.rotor) continue;
    const int w = unit.end();
    const Vector<T> axis = constant<T>(system.topology.bodies[w].axis);
    const Symmetric<T>& j = c.inertia[w];
    s.polar[w] = dot(axis, j * axis);
    const Symmetric<T> spin = square(-s.polar[w], axis);
    const Vector<T> com = c.origin[w] + c.com[w] - c.origin[unit.base];
    s.constant[unit.base] = s.constant[unit.base] + from_central(c.mass[w], com, j + spin);
    s.constant[w] = {};
  }
  const std::vector<SlidOrigin> slid = slid_origins(system.model, system.topology);
  for (std::size_t i = 0; i < n; ++i) s.constant[i] = without_noise(s.constant[i], slid[i]);
  for (std::size_t i = 0; i < n; ++i) {
    const std::string& body = system.topology.bodies[i].name;
    const bool is_own = !system.annotator.has_details() || known_size(s.constant[i].mass) == known_size(c.mass[i]);
    system.annotator.constant(s.constant[i].mass, is_own ? "m_" : "mr_", body);
    name_constant(system.annotator, s.constant[i].moment, "h_", body);
    name_constant(system.annotator, s.constant[i].second, "K_", body);
    system.annotator.constant(s.constant[i].trace, "K_", body, "_trace");
    system.annotator.constant(s.polar[i], "I_", body, "_polar");
    detail_inertia_about_origin(s, i);
  }
}

/// Angular velocities, bodies of blocks against their base as well (step 4).
template <class T>
void set_velocities(RecursionState<T>& s) {
  const System<T>& system = s.system();
  s.velocity = quasi_velocities(s.work);
  s.omega.resize(system.topology.bodies.size());
  for (std::size_t u = 0; u < s.units().size(); ++u) {
    const RecursionUnit& unit = s.units()[u];
    const auto heading = within_body(system.annotator, unit.end());
    const Vector<T> base = s.omega_of(unit.base);
    if (unit.rotor) continue;
    if (unit.block >= 0) {
      s.blocks[u].velocity = block_motion(s.work, unit, s.velocity);
      for (const JointStep& step : unit.steps) {
        const int i = step.body();
        const auto of_body = within_body(system.annotator, i);
        detail_name(system.annotator, s.blocks[u].velocity[i], "vb", "wb", system.body_name(i));
        s.omega[i] = base + s.blocks[u].velocity[i].angular;
        if (s.work.own(i)) s.omega[i] = transposed_times(s.k().orientation[i], s.omega[i]);
        name(system.annotator, s.omega[i], "w_", system.body_name(i));
      }
      continue;
    }
    Vector<T>& omega = s.omega[unit.end()];
    omega = s.runs[u].before = transposed_times(s.k().orientation[unit.end()], base);
    for (const JointStep& step : unit.steps) omega = omega + step_motion(s.work, step, s.velocity).angular;
    name(system.annotator, omega, "w_", system.body_name(unit.end()));
  }
}

/// Directions of a run and its acceleration at zero (quasi-)accelerations, driven ones prescribed.
template <class T>
void set_run_bias(RecursionState<T>& s, std::size_t u) {
  const RecursionUnit& unit = s.units()[u];
  RunParts<T>& run = s.runs[u];
  const Matrix<T> base_gradient = acceleration_gradient(s.omega_of(unit.base), Vector<T>{});
  run.carried = base_gradient * s.from_base(unit, unit.end());
  detail_name(s.system().annotator, base_gradient, "G_", s.system().body_name(unit.end()), "_base");
  detail_name(s.system().annotator, run.carried, "a_", s.system().body_name(unit.end()), "_carried");
  Vector<T> turning = run.before;
  for (const JointStep& step : unit.steps) {
    const Vector<T>& pin = s.k().pin[step.joints[0]];
    const Vector<T> rate =
        step.revolute ? step_motion(s.work, step, s.velocity).angular : step_motion(s.work, step, s.velocity).linear;
    const Matrix<T> before = acceleration_gradient(turning, run.bias.angular);
    const T* driven = s.driven(step.joints[0]);
    const Vector<T> prescribed = driven ? *driven * s.k().axis[step.joints[0]] : Vector<T>{};
    const Vector<T> coriolis = cross(turning, rate);
    if (step.revolute) {
      run.bias.angular = run.bias.angular + prescribed;
      if (!step.quasi()) run.bias.angular = run.bias.angular + coriolis;
      turning = turning + rate;
      run.bias.linear = run.bias.linear + (before - acceleration_gradient(turning, run.bias.angular)) * pin;
    } else {
      run.bias.linear = run.bias.linear + prescribed + coriolis + coriolis;
    }
    if (driven) continue;
    const Matrix<T> unit_axes = identity<T>();
    const Vector<T> axes[] = {unit_axes.x, unit_axes.y, unit_axes.z};
    for (std::size_t c = 0; c < step.joints.size(); ++c) {
      const Vector<T> axis = step.quasi() ? axes[c] : s.k().axis[step.joints[0]];
      run.directions.push_back(joint_column(step.revolute, axis, pin));
      detail_name(s.system().annotator, run.directions.back(), "v", "w", s.system().body_name(unit.end()), "_per_",
                  s.work.name_of(step.joints[c]));
      run.columns.push_back(step.joints[c]);
    }
  }
}

/// Accelerations of a block at zero free ones, and the motion of its bodies per free direction (steps 3 and 6).
template <class T, class Partition>
void set_block_bias(RecursionState<T>& s, std::size_t u, const Partition& partition) {
  const RecursionUnit& unit = s.units()[u];
  BlockParts<T>& parts = s.blocks[u];
  std::vector<T> driven(unit.joints.size(), T(0.0));
  for (std::size_t c = 0; c < unit.joints.size(); ++c)
    if (const T* value = s.driven(unit.joints[c])) driven[c] = *value;
  parts.bias = block_bias(s.work, unit, parts.velocity);
  const SparseClosure<T> closed = quasi_closure(s.work, unit, parts.velocity, parts.bias);
  parts.zdd_star = frozen_zdd_star(parts.factors, partition, closed, driven);
  name_zdd_star(s.system(), s.work.columns_of(unit), parts.zdd_star);
}

/// A vector over a block's columns as values by tree joint.
template <class T>
PerBody<T> per_joint(const RecursionUnit& unit, const std::vector<T>& local) {
  PerBody<T> values(unit);
  for (std::size_t c = 0; c < unit.joints.size(); ++c) values[unit.joints[c]] = local[c];
  return values;
}

}  // namespace mbgen::detail
