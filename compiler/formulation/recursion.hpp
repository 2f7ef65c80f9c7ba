#pragma once
// The recursive form: the same equations as the matrix form (63), with each loop block and each run of joints
// eliminated from the leaves to the root into the 6x6 inertia of its base body. Quasi-velocities inside, joint
// accelerations at the doors. Source: design.md section 7; R. Featherstone, Rigid Body Dynamics Algorithms, 2008,
// chapter 7 (articulated bodies), extended by the loop blocks' Rz (61).

#include "compiler/formulation/applied_forces.hpp"
#include "compiler/formulation/driven.hpp"
#include "compiler/formulation/loop_solution.hpp"
#include "compiler/formulation/recursion_closure.hpp"
#include "compiler/formulation/recursion_elimination.hpp"

namespace mbgen {

/// How much inertia a free direction moves.
template <class T>
struct DirectionInertia {
  int block = -1;  ///< index into Topology::blocks, -1 outside
  int place = 0;   ///< of the direction in its block, outside blocks its coordinate
  T value{0.0};    ///< not positive: none
};

/// Result of the recursive form.
template <class T>
struct RecursiveSolution {
  std::vector<T> zdd;      ///< per coordinate
  std::vector<T> quality;  ///< per block: smallest |pivot| / reference
  std::vector<DirectionInertia<T>> inertia;
};

namespace detail {

/// What moves on a body, about the body's origin in the frame that carries it (own frame, or that of its block's base).
template <class T>
struct Carried {
  PseudoInertia<T> rigid;         ///< of the body itself and of arms on it: its angular velocity acts on it as a whole
  PseudoInertia<T> above;         ///< of the blocks' bodies on it, whose velocities `needed` has taken in already
  ArticulatedInertia<T> reduced;  ///< what eliminated units change of it
  Spatial<T> needed;              ///< force that must be given at zero acceleration, applied forces taken off
};

/// What a block's solution needs on the way back.
template <class T>
struct BlockParts {
  FrozenFactors<T> factors;
  std::vector<std::vector<T>> rz;
  std::vector<T> star;                           ///< per local column: accelerations at zero free ones
  std::vector<Spatial<T>> velocity;              ///< per tree body, against the base
  std::vector<BodyAcceleration<T>> bias;         ///< at zero accelerations
  std::vector<std::vector<Spatial<T>>> partial;  ///< per free direction: motion of the bodies
  std::vector<Spatial<T>> star_motion;           ///< motion for `star`
};

/// What a run needs on the way back.
template <class T>
struct RunParts {
  std::vector<Spatial<T>> directions;  ///< motion of the end per free (quasi-)velocity
  std::vector<int> columns;            ///< their tree joints
  Vector<T> before;                    ///< angular velocity of the base, end's axes
  Spatial<T> bias;                     ///< acceleration of the end at zero (quasi-)accelerations
};

/// The recursion in the making: the passes of recursive_accelerations share it.
template <class T>
struct RecursionState {
  const RecursionWork<T>& work;
  const std::vector<Drive<T>>& drives;
  std::vector<PseudoInertia<T>> constant;  ///< per tree body in its axes: with rotors and rods' ends
  std::vector<T> polar;                    ///< per tree body: a rotor's inertia about its axis
  std::vector<T> velocity;                 ///< per joint: (quasi-)velocities
  std::vector<Vector<T>> omega;            ///< per tree body: angular velocity in the frame that carries it
  std::vector<Carried<T>> carried;
  std::vector<BlockParts<T>> blocks;        ///< per Recursion::units, empty where not a block
  std::vector<RunParts<T>> runs;            ///< likewise
  std::vector<UnitEquations<T>> equations;  ///< per unit
  std::vector<Spatial<T>> acceleration;     ///< per tree body about its origin in its carrying frame
  std::vector<T> force;                     ///< per joint: of the (quasi-)velocities

  const System<T>& system() const { return work.system; }
  const Kinematics<T>& k() const { return work.k; }
  const std::vector<RecursionUnit>& units() const { return work.recursion.units; }
  const T* driven(int joint) const {
    for (const Drive<T>& d : drives)
      if (d.coordinate == joint) return &d.acceleration;
    return nullptr;
  }
  /// Origin of a unit's end from the origin of its base body, in the axes of the frame that carries the base body.
  Vector<T> from_base(const RecursionUnit& unit, int body) const {
    const Vector<T>& at = k().position[body];
    return unit.base == kGround || work.own(unit.base) ? at : at - k().position[unit.base];
  }
  const Vector<T> omega_of(int body) const { return body == kGround ? Vector<T>{} : omega[body]; }
};

/// Constants of the bodies: rods' ends of m/2 (the rest is the rod's dyad, see add_rods) and locked rotors.
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
}

/// Angular velocities, bodies of blocks against their base as well (step 4).
template <class T>
void set_velocities(RecursionState<T>& s) {
  const System<T>& system = s.system();
  s.velocity = quasi_velocities(s.work);
  s.omega.resize(system.topology.bodies.size());
  for (std::size_t u = 0; u < s.units().size(); ++u) {
    const RecursionUnit& unit = s.units()[u];
    system.scribe.place(system.layout.titles[unit.end()]);
    const Vector<T> base = s.omega_of(unit.base);
    if (unit.rotor) continue;
    if (unit.block >= 0) {
      s.blocks[u].velocity = block_motion(s.work, unit, s.velocity);
      for (const JointStep& step : unit.steps) {
        const int i = step.body();
        s.omega[i] = base + s.blocks[u].velocity[i].angular;
        if (s.work.own(i)) s.omega[i] = transposed_times(s.k().orientation[i], s.omega[i]);
        name(system.scribe, s.omega[i], "w_", system.body_name(i));
      }
      continue;
    }
    Vector<T>& omega = s.omega[unit.end()];
    omega = s.runs[u].before = transposed_times(s.k().orientation[unit.end()], base);
    for (const JointStep& step : unit.steps) omega = omega + step_motion(s.work, step, s.velocity).angular;
    name(system.scribe, omega, "w_", system.body_name(unit.end()));
  }
}

/// Directions of a run and its acceleration at zero (quasi-)accelerations, driven ones prescribed.
template <class T>
void set_run_bias(RecursionState<T>& s, std::size_t u) {
  const RecursionUnit& unit = s.units()[u];
  RunParts<T>& run = s.runs[u];
  const Matrix<T> base_gradient = acceleration_gradient(s.omega_of(unit.base), Vector<T>{});
  run.bias.linear = transposed_times(s.k().orientation[unit.end()], base_gradient * s.from_base(unit, unit.end()));
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
  parts.star = frozen_zdd_star(parts.factors, partition, closed, driven);
  for (std::size_t c = 0; c < parts.star.size(); ++c)
    s.system().scribe.name(parts.star[c], "zdd_star_", s.system().topology.bodies[unit.joints[c]].coordinate);
}

/// A vector over a block's columns as values per tree joint.
template <class T>
std::vector<T> per_joint(const RecursionUnit& unit, std::size_t size, const std::vector<T>& local) {
  std::vector<T> values(size, T(0.0));
  for (std::size_t c = 0; c < unit.joints.size(); ++c) values[unit.joints[c]] = local[c];
  return values;
}

/// Inertia and needed force of a body as its own block or run sees them at zero base and free accelerations.
/// a, gradient: acceleration field of the body about its origin.
template <class T>
Spatial<T> needed_in(const Carried<T>& c, const Vector<T>& a, const Vector<T>& alpha, const Matrix<T>& gradient) {
  const Spatial<T> motion{a, alpha};
  return c.needed + field_force(c.rigid, a, gradient) + c.above * motion + c.reduced * motion;
}

/// What a body of a block holds of the bodies on it, about its origin.
template <class T>
struct Held {
  PseudoInertia<T> inertia;
  Spatial<T> needed;
  std::vector<Spatial<T>> momentum;  ///< per free direction: of their motion against this body
};

/// Equations of a block in the making, and what it adds to its base about the base's origin.
template <class T>
struct BlockGathering {
  const RecursionUnit& unit;
  BlockParts<T>& parts;
  UnitEquations<T>& equations;
  Vector<T> turning, twice;  ///< angular velocity of the base, and twice that
  Matrix<T> turning_field;   ///< w~w~ of it
  Carried<T> base;
  std::vector<Held<T>> held;  ///< per tree body
};

/// The free directions: motion of the bodies, forces on the joints.
template <class T>
void start_equations(RecursionState<T>& s, BlockGathering<T>& g) {
  const RecursionUnit& unit = g.unit;
  const std::size_t n = s.system().topology.bodies.size(), free = g.parts.rz.empty() ? 0 : g.parts.rz[0].size();
  for (std::size_t q = 0; q < free; ++q) {
    std::vector<T> column(unit.joints.size());
    for (std::size_t c = 0; c < column.size(); ++c) column[c] = g.parts.rz[c][q];
    g.parts.partial.push_back(block_motion(s.work, unit, per_joint(unit, n, column)));
    g.equations.mass.emplace_back(q + 1, T(0.0));
    g.equations.momentum.emplace_back();
    T force(0.0);
    for (std::size_t c = 0; c < column.size(); ++c) force = force + column[c] * s.force[unit.joints[c]];
    g.equations.force.push_back(force);
  }
  g.parts.star_motion = block_motion(s.work, unit, per_joint(unit, n, g.parts.star));
}

/// A motion about another point of the body, `arm` from where it is given.
template <class T>
Spatial<T> about_point(const Spatial<T>& motion, const Vector<T>& arm) {
  return {velocity_at(motion, arm), motion.angular};
}

/// Adds a body's part of the projected equations, about the point `arm` from its origin and `place` from the base's.
/// needed: by its own free directions.
template <class T>
void add_to_equations(BlockGathering<T>& g, int i, const Vector<T>& arm, const Vector<T>& place,
                      const PseudoInertia<T>& whole, const ArticulatedInertia<T>& reduced, const Spatial<T>& needed) {
  std::vector<Spatial<T>> partial;
  for (const std::vector<Spatial<T>>& motion : g.parts.partial) partial.push_back(about_point(motion[i], arm));
  for (std::size_t q = 0; q < partial.size(); ++q) {
    const Spatial<T> momentum = whole * partial[q] + reduced * partial[q];
    for (std::size_t d = 0; d <= q; ++d) g.equations.mass[q][d] = g.equations.mass[q][d] + dot(partial[d], momentum);
    g.equations.momentum[q] = g.equations.momentum[q] + shifted(place, momentum);
    g.equations.force[q] = g.equations.force[q] - dot(partial[q], needed);
  }
}

/// An arm: one revolute joint on the base, nothing on it. The base's angular velocity acts on it as on a part of the
/// base (there it costs nothing more), so that only its motion against the base and the Coriolis field are its own.
template <class T>
void gather_arm(RecursionState<T>& s, BlockGathering<T>& g, int i) {
  const Carried<T>& arm = s.carried[i];
  const Vector<T>& w = g.parts.velocity[i].angular;
  const Vector<T> alpha = g.parts.star_motion[i].angular;
  const Matrix<T> own = acceleration_gradient(w, alpha);
  const T along = dot(g.twice, w);
  const Matrix<T> field = own + Matrix<T>{g.twice.x * w, g.twice.y * w, g.twice.z * w} -
                          Matrix<T>{{along, T(0.0), T(0.0)}, {T(0.0), along, T(0.0)}, {T(0.0), T(0.0), along}};
  const Spatial<T> needed = arm.needed + field_force(arm.rigid, Vector<T>{}, field);
  const Vector<T>& place = s.k().position[i];
  g.base.rigid = g.base.rigid + shifted(place, arm.rigid);
  g.base.needed = g.base.needed + shifted(place, needed);
  const Spatial<T> as_part_of_base = field_force(arm.rigid, g.turning_field * place, g.turning_field);
  add_to_equations(g, i, Vector<T>{}, place, arm.rigid, {}, needed + as_part_of_base);
}

/// Whether a unit with a door of its own moves on a body.
template <class T>
bool bears_units(const RecursionState<T>& s, int body) {
  return std::any_of(s.units().begin(), s.units().end(),
                     [body](const RecursionUnit& u) { return u.base == body && !u.rotor; });
}

/// Force that a body of a block needs at zero base and free accelerations, about the point `arm` from its origin.
template <class T>
Spatial<T> needed_of(RecursionState<T>& s, BlockGathering<T>& g, int i, const Carried<T>& body, const Vector<T>& arm) {
  const Spatial<T> v = about_point(g.parts.velocity[i], arm), extra = about_point(g.parts.star_motion[i], arm);
  const BodyAcceleration<T>& bias = g.parts.bias[i];
  const Vector<T> place = s.k().position[i] + arm;
  Vector<T> a = bias.linear + bias.gradient * arm + extra.linear + g.turning_field * place + cross(g.twice, v.linear);
  if (g.unit.base == kGround) a = a - s.system().constants.gravity;
  const Vector<T> alpha = bias.angular + extra.angular + cross(g.turning, v.angular);
  const Spatial<T> needed = needed_in(body, a, alpha, acceleration_gradient(g.turning + v.angular, alpha));
  name(s.system().scribe, needed, "f", "n", s.system().body_name(i));
  return needed;
}

/// A body on another body of its block, by one joint: its motion is that of the body below and of its own joint, so
/// that the body below holds its inertia, and only its joint's motion b is projected here.
template <class T>
void gather_held(RecursionState<T>& s, BlockGathering<T>& g, const JointStep& step) {
  const int i = step.body(), below = s.work.parent(step);
  const Vector<T>& axis = s.k().axis[i];
  const Spatial<T> b = step.revolute ? Spatial<T>{{}, axis} : Spatial<T>{axis, {}};
  const PseudoInertia<T> whole = s.carried[i].rigid + g.held[i].inertia;
  const Spatial<T> needed = needed_of(s, g, i, s.carried[i], Vector<T>{}) + g.held[i].needed;
  const Vector<T>& offset = s.work.offset[i];
  const Spatial<T> momentum = whole * b, seen_below = shifted(offset, momentum);
  const T half = T(0.5) * dot(b, momentum);
  Held<T>& held = g.held[below];
  held.inertia = held.inertia + shifted(offset, whole);
  held.needed = held.needed + shifted(offset, needed);
  held.momentum.resize(g.equations.size());
  const auto local = std::lower_bound(g.unit.joints.begin(), g.unit.joints.end(), i) - g.unit.joints.begin();
  const std::vector<T>& rate = g.parts.rz[local];
  std::vector<T> coupled;
  for (std::size_t q = 0; q < g.equations.size(); ++q) {
    coupled.push_back(dot(seen_below, g.parts.partial[q][below]) + half * rate[q]);
    for (std::size_t d = 0; d <= q; ++d)
      g.equations.mass[q][d] = g.equations.mass[q][d] + (rate[q] * coupled[d] + rate[d] * coupled[q]);
    held.momentum[q] = held.momentum[q] + rate[q] * seen_below;
    if (!g.held[i].momentum.empty()) held.momentum[q] = held.momentum[q] + shifted(offset, g.held[i].momentum[q]);
    g.equations.force[q] = g.equations.force[q] - rate[q] * dot(b, needed);
  }
}

/// Whether a body of a block is an arm.
template <class T>
bool is_arm(const RecursionState<T>& s, const RecursionUnit& unit, const JointStep& step) {
  const int i = step.body();
  if (!s.work.recursion.choices.arms) return false;
  if (!step.revolute || step.quasi() || unit.base == kGround || s.work.own(i) || s.work.parent(step) != unit.base)
    return false;
  return std::none_of(s.units().begin(), s.units().end(), [i](const RecursionUnit& u) { return u.base == i; });
}

/// Whether a body of a block is held by the one below.
template <class T>
bool is_held(const RecursionState<T>& s, const RecursionUnit& unit, const JointStep& step) {
  const int below = s.work.parent(step);
  if (!s.work.recursion.choices.holding || step.quasi() || below == unit.base || s.work.own(step.body())) return false;
  return !bears_units(s, step.body()) && s.work.step[below] != nullptr && !is_arm(s, unit, *s.work.step[below]);
}

/// Any other body of a block: about its centre of mass where nothing moves on it and that was chosen, else its origin.
template <class T>
void gather_body(RecursionState<T>& s, BlockGathering<T>& g, int i) {
  const Matrix<T>& axes = s.k().orientation[i];
  const Held<T>& held = g.held[i];
  Carried<T> body = s.carried[i];
  Vector<T> arm;
  if (s.work.own(i))
    body = {rotated(axes, body.rigid), rotated(axes, body.above), rotated(axes, body.reduced),
            rotated(axes, body.needed)};
  const bool is_bare = held.momentum.empty() && !is_zero(s.constant[i].mass) && !bears_units(s, i);
  if (s.work.recursion.choices.centres && is_bare) {
    const PseudoInertia<T>& constant = s.constant[i];
    const Vector<T> com = (T(1.0) / constant.mass) * constant.moment;
    arm = axes * com;
    body.rigid = rotated(axes, centred(constant));
    body.needed = shifted(-arm, body.needed);
  }
  const Vector<T> place = s.k().position[i] + arm;
  const Spatial<T> needed = needed_of(s, g, i, body, arm) + held.needed;
  const PseudoInertia<T> whole = body.rigid + body.above + held.inertia;
  g.base.above = g.base.above + shifted(place, whole);
  g.base.reduced = g.base.reduced + shifted(place, body.reduced);
  g.base.needed = g.base.needed + shifted(place, needed);
  for (std::size_t q = 0; q < held.momentum.size(); ++q)
    g.equations.momentum[q] = g.equations.momentum[q] + shifted(place, held.momentum[q]);
  add_to_equations(g, i, arm, place, whole, body.reduced, needed);
}

/// What a rod's mass adds to two point masses m/2: -m/6 times the kinetic energy of the difference of its ends. It has
/// no momentum in a translation, and the pseudo-inertia -m/6 d d'.
template <class T>
void gather_rod(RecursionState<T>& s, BlockGathering<T>& g, const RodConstants<T>& rod) {
  const auto end = [&](const Place<T>& at) { return near_end(s.work, g.unit, g.parts.velocity, g.parts.bias, at); };
  const NearEnd<T> from = end(rod.from), to = end(rod.to);
  const auto moved = [&](const std::vector<Spatial<T>>& motion) {
    const auto of = [&](const NearEnd<T>& e) {
      return e.body == g.unit.base ? Vector<T>{} : velocity_at(motion[e.body], e.arm);
    };
    return of(from) - of(to);
  };
  const T mass = -rod.coupling;
  const Vector<T> gap = from.place - to.place, scaled_gap = mass * gap;
  const Vector<T> rate = from.point_velocity() - to.point_velocity();
  const Vector<T> own = from.point_acceleration() - to.point_acceleration() + moved(g.parts.star_motion);
  const Vector<T> force = mass * (own + cross(g.twice, rate) + g.turning_field * gap);
  g.base.above = g.base.above + pseudo_inertia(T(0.0), Vector<T>{}, square(mass, gap));
  g.base.needed.angular = g.base.needed.angular + cross(gap, force);
  std::vector<Vector<T>> partial;
  for (const std::vector<Spatial<T>>& motion : g.parts.partial) partial.push_back(moved(motion));
  for (std::size_t q = 0; q < partial.size(); ++q) {
    for (std::size_t d = 0; d <= q; ++d)
      g.equations.mass[q][d] = g.equations.mass[q][d] + mass * dot(partial[q], partial[d]);
    g.equations.momentum[q].angular = g.equations.momentum[q].angular + cross(scaled_gap, partial[q]);
    g.equations.force[q] = g.equations.force[q] - dot(partial[q], force);
  }
}

/// Equations of a block's free directions. Result: what it adds to its base.
template <class T>
Carried<T> gather_block(RecursionState<T>& s, std::size_t u) {
  const System<T>& system = s.system();
  const RecursionUnit& unit = s.units()[u];
  const Vector<T> turning = s.omega_of(unit.base);
  BlockGathering<T> g{
      unit, s.blocks[u], s.equations[u], turning, turning + turning, acceleration_gradient(turning, Vector<T>{}), {}};
  start_equations(s, g);
  g.held.resize(system.topology.bodies.size());
  for (auto step = unit.steps.rbegin(); step != unit.steps.rend(); ++step) {
    system.scribe.place(system.layout.titles[step->body()]);
    if (is_arm(s, unit, *step))
      gather_arm(s, g, step->body());
    else if (is_held(s, unit, *step))
      gather_held(s, g, *step);
    else
      gather_body(s, g, step->body());
  }
  for (int l : system.topology.blocks[unit.block].loops) {
    const Loop& loop = system.topology.loops[l];
    if (loop.kind != ClosureKind::rod || is_zero(system.constants.rods[loop.rod].coupling)) continue;
    system.scribe.place(loop.name);
    gather_rod(s, g, system.constants.rods[loop.rod]);
  }
  return g.base;
}

/// What the angular velocity of a run's end asks for.
template <class T>
Spatial<T> turning_force(const RecursionState<T>& s, int end) {
  return field_force(s.carried[end].rigid, Vector<T>{}, acceleration_gradient(s.omega[end], Vector<T>{}));
}

/// Equations of a run's free directions about its end's origin, and what it carries there at zero accelerations.
template <class T>
void gather_run(RecursionState<T>& s, std::size_t u, UnitEquations<T>& equations, ArticulatedInertia<T>& inertia,
                Spatial<T>& needed) {
  const RecursionUnit& unit = s.units()[u];
  const RunParts<T>& run = s.runs[u];
  const Carried<T>& body = s.carried[unit.end()];
  inertia = articulated(body.rigid + body.above) + body.reduced;
  needed = body.needed + turning_force(s, unit.end()) + inertia * run.bias;
  for (std::size_t q = 0; q < run.directions.size(); ++q) {
    equations.momentum.push_back(inertia * run.directions[q]);
    equations.mass.emplace_back();
    for (std::size_t d = 0; d <= q; ++d) equations.mass[q].push_back(dot(run.directions[d], equations.momentum[q]));
    equations.force.push_back(s.force[run.columns[q]] - dot(run.directions[q], needed));
  }
}

/// Unit motions of a free run's end about its origin, in the order of its steps.
template <class T>
std::vector<Spatial<T>> unit_motions(const RecursionUnit& unit) {
  const Matrix<T> e = identity<T>();
  std::vector<Spatial<T>> units;
  for (const JointStep& step : unit.steps)
    for (const Vector<T>& axis : {e.x, e.y, e.z})
      units.push_back(step.revolute ? Spatial<T>{{}, axis} : Spatial<T>{axis, {}});
  return units;
}

/// A free run: the acceleration of its end is the unknown, and its base gets the joint's forces alone.
template <class T>
void gather_free(RecursionState<T>& s, std::size_t u, UnitEquations<T>& equations, Spatial<T>& transmitted) {
  const RecursionUnit& unit = s.units()[u];
  const Carried<T>& body = s.carried[unit.end()];
  const RunParts<T>& run = s.runs[u];
  const ArticulatedInertia<T> inertia = articulated(body.rigid + body.above) + body.reduced;
  // directions: pin x e for turns, so forces at the origin follow from those on the quasi-velocities
  Vector<T> push, turn;
  for (std::size_t q = 0; q < 6; ++q) {
    const JointStep& step = q < 3 ? unit.steps[0] : unit.steps[1];
    Vector<T>& part = step.revolute ? turn : push;
    const T& value = s.force[run.columns[q]];
    (q % 3 == 0 ? part.x : q % 3 == 1 ? part.y : part.z) = value;
  }
  const Vector<T>& pin = s.k().pin[(unit.steps[0].revolute ? unit.steps[0] : unit.steps[1]).joints[0]];
  transmitted = {push, turn + cross(pin, push)};
  const Spatial<T> available = transmitted - (body.needed + turning_force(s, unit.end()));
  const std::vector<Spatial<T>> units = unit_motions<T>(unit);
  for (std::size_t q = 0; q < units.size(); ++q) {
    const Spatial<T> momentum = inertia * units[q];
    equations.mass.emplace_back();
    for (std::size_t d = 0; d <= q; ++d) equations.mass[q].push_back(dot(units[d], momentum));
    equations.momentum.emplace_back();
    equations.force.push_back(dot(units[q], available));
  }
}

/// Adds what a unit carries to the body that it moves on. axes, place: of the frame that it is given in, seen from
/// the frame that carries the base.
template <class T>
void hand_down(RecursionState<T>& s, int base, const Matrix<T>& axes, const Vector<T>& place,
               const ArticulatedInertia<T>& inertia, const Spatial<T>& needed) {
  if (base == kGround) return;
  Carried<T>& below = s.carried[base];
  below.reduced = below.reduced + shifted(place, rotated(axes, inertia));
  below.needed = below.needed + shifted(place, rotated(axes, needed));
}

template <class T>
void eliminate_block(RecursionState<T>& s, std::size_t u) {
  const RecursionUnit& unit = s.units()[u];
  UnitEquations<T>& equations = s.equations[u];
  Carried<T> base = gather_block(s, u);
  s.system().scribe.place("");
  eliminate(equations);
  if (unit.base == kGround) return;
  reduce(equations, base.reduced, base.needed);
  Carried<T>& below = s.carried[unit.base];
  below.rigid = below.rigid + base.rigid;
  below.above = below.above + base.above;
  below.reduced = below.reduced + base.reduced;
  below.needed = below.needed + base.needed;
}

/// A block as its loops name it.
inline std::string block_name(const Topology& topology, int block) {
  const LoopBlock& b = topology.blocks[block];
  return topology.loops[b.loops[0]].name + (b.loops.size() > 1 ? " .. " + topology.loops[b.loops.back()].name : "");
}

template <class T>
void eliminate_run(RecursionState<T>& s, std::size_t u) {
  const RecursionUnit& unit = s.units()[u];
  UnitEquations<T>& equations = s.equations[u];
  const Matrix<T>& axes = s.k().orientation[unit.end()];
  const Vector<T> place = s.from_base(unit, unit.end());
  ArticulatedInertia<T> inertia;
  Spatial<T> needed;
  if (is_free(unit)) {
    gather_free(s, u, equations, needed);
    eliminate(equations);
    hand_down(s, unit.base, axes, place, {}, needed);
    return;
  }
  gather_run(s, u, equations, inertia, needed);
  eliminate(equations);
  reduce(equations, inertia, needed);
  clear_directions(s.runs[u].directions, inertia);
  hand_down(s, unit.base, axes, place, inertia, needed);
}

/// Origin of a body in the frame that carries it.
template <class T>
Vector<T> work_origin(const RecursionState<T>& s, int body) {
  return s.work.own(body) ? Vector<T>{} : s.k().position[body];
}

/// A rotor spins freely on its base, which holds its inertia across the axis and its mass.
template <class T>
void eliminate_rotor(RecursionState<T>& s, std::size_t u, const AppliedForces<T>& forces) {
  const RecursionUnit& unit = s.units()[u];
  const int w = unit.end();
  const Vector<T>& axis = s.k().axis[w];
  UnitEquations<T>& equations = s.equations[u];
  const T* driven = s.driven(w);
  const T applied = dot(s.k().column[w], forces.wrench[w]);
  Carried<T>& base = s.carried[unit.base];
  const Vector<T> center = work_origin(s, unit.base);
  base.needed = base.needed - shifted(Vector<T>{} - center, forces.wrench[w]);
  const Vector<T> omega = s.omega[unit.base];
  const T spin = dot(axis, omega) + s.system().zd(w);
  base.needed.angular = base.needed.angular + (s.polar[w] * spin) * cross(omega, axis);
  if (driven) {  // its spin acceleration is that of the base and the prescribed one
    const Vector<T> along = s.polar[w] * axis;
    base.reduced.angular = base.reduced.angular + square(s.polar[w], axis);
    base.needed.angular = base.needed.angular + *driven * along;
    return;
  }
  const T force = s.force[w] + applied;
  base.needed.angular = base.needed.angular + force * axis;
  equations.mass = {{s.polar[w]}};
  equations.momentum = {{}};
  equations.force = {force};
  eliminate(equations);
}

/// Motion of a unit's base, and of the frame about the base's origin.
template <class T>
Spatial<T> base_acceleration(const RecursionState<T>& s, int base) {
  return base == kGround ? Spatial<T>{-s.system().constants.gravity, {}} : s.acceleration[base];
}

/// Quasi-accelerations of a step.
template <class T>
Vector<T> quasi_of(const JointStep& step, const std::vector<T>& values) {
  return {values[step.joints[0]], values[step.joints[1]], values[step.joints[2]]};
}

/// Inertias of a unit's free directions. Where the joint rates of its balls are singular the monitor falls, of its
/// block or of the middle joint's direction.
template <class T>
void watch_unit(const RecursionState<T>& s, std::size_t u, RecursiveSolution<T>& solution) {
  using std::abs;
  using std::min;
  const RecursionUnit& unit = s.units()[u];
  std::vector<DirectionInertia<T>> found;
  for (std::size_t q = 0; q < s.equations[u].size(); ++q) {
    const int column = unit.rotor ? unit.end() : unit.block < 0 ? s.runs[u].columns[q] : static_cast<int>(q);
    found.push_back({unit.block, column, s.equations[u].inertia[q]});
  }
  for (const JointStep& step : unit.steps) {
    if (!step.quasi() || !step.revolute) continue;
    const T& volume = s.work.quasi[step.body()].volume;
    if (unit.block >= 0) {
      T& quality = solution.quality[unit.block];
      quality = min(quality, abs(volume));
    } else {
      for (DirectionInertia<T>& d : found)
        if (d.place == step.joints[1]) d.value = min(d.value, volume * volume - T(1e-12));
    }
  }
  solution.inertia.insert(solution.inertia.end(), found.begin(), found.end());
}

template <class T>
void solve_block(RecursionState<T>& s, std::size_t u, std::vector<T>& zdd) {
  const System<T>& system = s.system();
  const RecursionUnit& unit = s.units()[u];
  const BlockParts<T>& parts = s.blocks[u];
  const bool grounded = unit.base == kGround;
  const Spatial<T> base = grounded ? Spatial<T>{} : base_acceleration(s, unit.base);
  const std::vector<T> free = free_accelerations(s.equations[u], base);
  std::vector<T> local = parts.star;
  for (std::size_t c = 0; c < local.size(); ++c)
    for (std::size_t q = 0; q < free.size(); ++q) local[c] = local[c] + parts.rz[c][q] * free[q];
  for (std::size_t c = 0; c < local.size(); ++c) zdd[unit.joints[c]] = local[c];
  const Vector<T> turning = s.omega_of(unit.base), twice = turning + turning;
  const Matrix<T> base_gradient = acceleration_gradient(turning, base.angular);
  for (const JointStep& step : unit.steps) {
    const int i = step.body(), p = s.work.parent(step);
    system.scribe.place(system.layout.titles[i]);
    if (step.quasi()) {
      set_joint_accelerations(s.work, step, p == unit.base ? Vector<T>{} : parts.velocity[p].angular,
                              quasi_of(step, zdd), zdd);
    }
    const Spatial<T>& v = parts.velocity[i];
    Spatial<T> a = parts.star_motion[i];
    for (std::size_t q = 0; q < free.size(); ++q) a = a + free[q] * parts.partial[q][i];
    a.linear =
        a.linear + parts.bias[i].linear + base.linear + base_gradient * s.k().position[i] + cross(twice, v.linear);
    a.angular = a.angular + parts.bias[i].angular + base.angular + cross(turning, v.angular);
    if (grounded) a.linear = a.linear - system.constants.gravity;
    if (s.work.own(i))
      a = {transposed_times(s.k().orientation[i], a.linear), transposed_times(s.k().orientation[i], a.angular)};
    name(system.scribe, a.linear, "a_", system.body_name(i));
    name(system.scribe, a.angular, "alpha_", system.body_name(i));
    s.acceleration[i] = a;
  }
}

template <class T>
void solve_run(RecursionState<T>& s, std::size_t u, std::vector<T>& zdd) {
  const RecursionUnit& unit = s.units()[u];
  const RunParts<T>& run = s.runs[u];
  const int e = unit.end();
  const Matrix<T>& axes = s.k().orientation[e];
  const Spatial<T> below = base_acceleration(s, unit.base);
  const Spatial<T> base{transposed_times(axes, velocity_at(below, s.from_base(unit, e))),
                        transposed_times(axes, below.angular)};
  std::vector<T> free = free_accelerations(s.equations[u], base);
  Spatial<T>& a = s.acceleration[e];
  if (is_free(unit)) {
    const std::vector<Spatial<T>> units = unit_motions<T>(unit);
    for (std::size_t q = 0; q < free.size(); ++q) a = a + free[q] * units[q];
    const Spatial<T> left = a - base - run.bias;
    const bool turns_first = unit.steps[0].revolute;
    const Vector<T>& pin = s.k().pin[(turns_first ? unit.steps[0] : unit.steps[1]).joints[0]];
    const Vector<T> push = left.linear - cross(pin, left.angular);
    const Vector<T>& first = turns_first ? left.angular : push;
    const Vector<T>& second = turns_first ? push : left.angular;
    free = {first.x, first.y, first.z, second.x, second.y, second.z};
  } else {
    a = base + run.bias;
    for (std::size_t q = 0; q < free.size(); ++q) a = a + free[q] * run.directions[q];
  }
  name(s.system().scribe, a.linear, "a_", s.system().body_name(e));
  name(s.system().scribe, a.angular, "alpha_", s.system().body_name(e));
  for (int j : unit.joints)
    if (const T* driven = s.driven(j)) zdd[j] = *driven;
  for (std::size_t q = 0; q < free.size(); ++q) zdd[run.columns[q]] = free[q];
  Vector<T> turning = run.before;
  for (const JointStep& step : unit.steps) {
    if (step.quasi()) set_joint_accelerations(s.work, step, turning, quasi_of(step, zdd), zdd);
    turning = turning + step_motion(s.work, step, s.velocity).angular;
  }
}

template <class T>
void solve_rotor(RecursionState<T>& s, std::size_t u, std::vector<T>& zdd) {
  const RecursionUnit& unit = s.units()[u];
  const int w = unit.end();
  if (const T* driven = s.driven(w)) {
    zdd[w] = *driven;
    return;
  }
  const UnitEquations<T>& e = s.equations[u];
  zdd[w] = e.force[0] * e.reciprocal[0] - dot(s.k().axis[w], s.acceleration[unit.base].angular);
}

/// Adds what the bodies of a unit carry themselves to what units above have left there: inertia, applied forces.
template <class T>
void add_own_parts(RecursionState<T>& s, const RecursionUnit& unit, const AppliedForces<T>& forces) {
  for (const JointStep& step : unit.steps) {
    const int i = step.body();
    if (unit.block < 0 && i != unit.end()) continue;
    s.system().scribe.place(s.system().layout.titles[i]);
    Carried<T>& c = s.carried[i];
    c.rigid = c.rigid + (s.work.own(i) ? s.constant[i] : rotated(s.k().orientation[i], s.constant[i]));
    c.needed = c.needed - shifted(Vector<T>{} - work_origin(s, i), forces.wrench[i]);
  }
}

/// Steps 2, 3, 6, 7 and 8 of a loop block.
template <class T, class Partition>
void eliminate_block(RecursionState<T>& s, std::size_t u, const AppliedForces<T>& forces, const Partition& partition,
                     T& quality) {
  const RecursionUnit& unit = s.units()[u];
  Scribe<T>& scribe = s.system().scribe;
  const std::string name = block_name(s.system().topology, unit.block);
  const std::size_t n = s.system().topology.bodies.size();
  BlockParts<T>& parts = s.blocks[u];
  scribe.step(Step::jacobian, name);
  const SparseClosure<T> closed =
      quasi_closure(s.work, unit, std::vector<Spatial<T>>(n), std::vector<BodyAcceleration<T>>(n));
  scribe.place("");
  parts.factors = factorise_frozen(closed.jacobian, partition, unit.joints.size());
  quality = parts.factors.quality;
  scribe.step(Step::projection, name);
  parts.rz = frozen_rz(parts.factors, partition, unit.joints.size());
  for (std::size_t c = 0; c < parts.rz.size(); ++c)
    for (std::size_t q = 0; q < parts.rz[c].size(); ++q)
      scribe.name(parts.rz[c][q], "Rz_", s.system().topology.bodies[unit.joints[c]].coordinate, "_", std::to_string(q));
  scribe.step(Step::closure_bias, name);
  set_block_bias(s, u, partition);
  scribe.step(Step::accelerations, name);
  add_own_parts(s, unit, forces);
  scribe.step(Step::reduced_system, name);
  eliminate_block(s, u);
}

/// The way to the root (steps 2 to 8).
template <class T, class Partitions>
void eliminate_units(RecursionState<T>& s, const AppliedForces<T>& forces, const Partitions& partitions,
                     RecursiveSolution<T>& solution) {
  Scribe<T>& scribe = s.system().scribe;
  for (std::size_t u = s.units().size(); u-- > 0;) {
    const RecursionUnit& unit = s.units()[u];
    if (unit.block >= 0) {
      eliminate_block(s, u, forces, partitions[unit.block], solution.quality[unit.block]);
      continue;
    }
    scribe.step(Step::reduced_system);
    scribe.place(s.system().layout.titles[unit.end()]);
    if (unit.rotor) {
      eliminate_rotor(s, u, forces);
      continue;
    }
    set_run_bias(s, u);
    add_own_parts(s, unit, forces);
    eliminate_run(s, u);
  }
}

/// The way back to the leaves (step 9).
template <class T>
void solve_units(RecursionState<T>& s, RecursiveSolution<T>& solution) {
  const System<T>& system = s.system();
  system.scribe.step(Step::solution);
  solution.zdd.assign(system.topology.bodies.size(), T(0.0));
  for (std::size_t u = 0; u < s.units().size(); ++u) {
    const RecursionUnit& unit = s.units()[u];
    system.scribe.place(system.layout.titles[unit.end()]);
    if (unit.rotor)
      solve_rotor(s, u, solution.zdd);
    else if (unit.block >= 0)
      solve_block(s, u, solution.zdd);
    else
      solve_run(s, u, solution.zdd);
    watch_unit(s, u, solution);
  }
}

}  // namespace detail

/// All joint accelerations by the recursive form. partitions: per block over (quasi-)velocities. forces: applied,
/// without tau. Cost: linear in bodies, quadratic in the free directions of one unit.
template <class T, class Partitions>
RecursiveSolution<T> recursive_accelerations(System<T>& system, const Recursion& recursion, const Kinematics<T>& k,
                                             const AppliedForces<T>& forces, const std::vector<Drive<T>>& drives,
                                             const std::vector<T>& tau, const Partitions& partitions) {
  const std::size_t n = system.topology.bodies.size(), units = recursion.units.size();
  const RecursionWork<T> work = recursion_work(system, recursion, k);
  detail::RecursionState<T> s{work, drives, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}};
  s.blocks.resize(units);
  s.runs.resize(units);
  s.equations.resize(units);
  s.acceleration.resize(n);
  s.carried.resize(n);
  detail::set_constants(s);
  RecursiveSolution<T> solution;
  solution.quality.assign(system.topology.blocks.size(), T(1.0));
  system.scribe.step(Step::velocities);
  detail::set_velocities(s);
  system.scribe.step(Step::accelerations);
  s.force = tau;
  for (std::size_t i = 0; i < n; ++i) s.force[i] = s.force[i] + forces.joint[i];
  s.force = quasi_forces(work, s.force);
  detail::eliminate_units(s, forces, partitions, solution);
  detail::solve_units(s, solution);
  return solution;
}

/// Jacobian of a block by (quasi-)velocities at the present position, for choosing its partition.
template <class T>
std::vector<SparseRow<T>> quasi_jacobian(const RecursionWork<T>& work, const RecursionUnit& unit) {
  const std::size_t n = work.system.topology.bodies.size();
  return quasi_closure(work, unit, std::vector<Spatial<T>>(n), std::vector<BodyAcceleration<T>>(n)).jacobian;
}

}  // namespace mbgen
