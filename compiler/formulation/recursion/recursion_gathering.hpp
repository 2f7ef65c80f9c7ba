#pragma once
// Recursive form: the projected equations (63) of one loop block or run, and its share in its base.

#include "compiler/formulation/recursion/recursion_arms.hpp"
#include "compiler/formulation/rods.hpp"

namespace mbgen::detail {

/// A body on another body of its block, by one joint: its motion is the sum of the inboard body's motion and its own
/// joint's, so that its inertia joins the inboard body's subtree, and only its joint's motion b is projected here.
template <class T>
void gather_in_subtree(RecursionState<T>& s, BlockGathering<T>& g, const JointStep& step) {
  const int i = step.body(), below = s.work.parent(step);
  const Vector<T>& axis = s.k().axis[i];
  const Spatial<T> b = step.revolute ? Spatial<T>{{}, axis} : Spatial<T>{axis, {}};
  const CompositeBody<T> body = with_arms(s, g, i);
  const PseudoInertia<T> whole = body.rigid + g.subtree[i].inertia;
  const Spatial<T> needed = needed_of(s, g, i, body, Vector<T>{}) + g.subtree[i].needed;
  const Vector<T>& offset = s.work.offset[i];
  const Spatial<T> momentum = whole * b;
  SubtreeInertia<T>& subtree = g.subtree[below];
  subtree.is_empty = false;
  subtree.inertia = subtree.inertia + shifted(offset, whole);
  subtree.needed = subtree.needed + shifted(offset, needed);
  detail_inertia(s.system().annotator, whole, "hc_", "Kc_", "Ic_", s.system().body_name(i));
  detail_name(s.system().annotator, needed, "fc", "nc", s.system().body_name(i));
  detail_name(s.system().annotator, momentum, "F", "N", s.system().topology.bodies[i].coordinate);
  project_joint(s, g, i, below, shifted(offset, momentum), T(0.5) * dot(b, momentum), dot(b, needed));
  for (std::size_t q = 0; q < g.subtree[i].momentum.size(); ++q)
    subtree.momentum[q] = subtree.momentum[q] + shifted(offset, g.subtree[i].momentum[q]);
}

/// Any other body of a block: about its centre of mass where nothing moves on it and that was chosen, else its origin.
template <class T>
void gather_body(RecursionState<T>& s, BlockGathering<T>& g, int i) {
  const Matrix<T>& axes = s.k().orientation[i];
  const SubtreeInertia<T>& subtree = g.subtree[i];
  CompositeBody<T> body = with_arms(s, g, i);
  Vector<T> arm;
  const bool is_bare = subtree.is_empty && g.arms[i].is_empty && !is_zero(s.constant[i].mass) && !bears_units(s, i);
  if (s.work.recursion.choices.centres && is_bare) {
    const PseudoInertia<T>& constant = s.constant[i];
    const Vector<T> com = (T(1.0) / constant.mass) * constant.moment;
    arm = axes * com;
    body.rigid = s.in_base_axes(i, centred(constant));
    body.needed = shifted(-arm, body.needed);
  }
  const Vector<T> place = s.k().position[i] + arm;
  detail_name(s.system().annotator, arm, "arm_", s.system().body_name(i), "_com");
  detail_name(s.system().annotator, place, "r_", s.system().body_name(i), "_com");
  const PseudoInertia<T> whole = body.rigid + body.above + subtree.inertia;
  g.base.reduced = g.base.reduced + shifted(place, body.reduced);
  for (std::size_t q = 0; q < subtree.momentum.size(); ++q)
    g.equations.momentum[q] = g.equations.momentum[q] + shifted(place, subtree.momentum[q]);
  if (turns_in_plane(s, g, i)) {
    const NeededInPlane<T> parts = needed_in_plane(s, g, i, body, arm);
    const Spatial<T> needed = parts.own + subtree.needed, with_part = needed + parts.as_part;
    g.base.rigid = g.base.rigid + shifted(place, body.rigid);
    g.base.above = g.base.above + shifted(place, body.above);
    g.base.needed = g.base.needed + shifted(place, needed);
    detail_name(s.system().annotator, with_part, "fc", "nc", s.system().body_name(i));
    add_to_equations(s, g, i, arm, place, whole, body.reduced, with_part);
    return;
  }
  const Spatial<T> needed = needed_of(s, g, i, body, arm) + subtree.needed;
  g.base.above = g.base.above + shifted(place, whole);
  g.base.needed = g.base.needed + shifted(place, needed);
  detail_name(s.system().annotator, needed, "fc", "nc", s.system().body_name(i));
  add_to_equations(s, g, i, arm, place, whole, body.reduced, needed);
}

/// Share of a rod's mass beyond two point masses m/2: -m/6 times the kinetic energy of the difference of its ends. It
/// has no momentum in a translation, and the pseudo-inertia -m/6 d d'.
template <class T>
void gather_rod(RecursionState<T>& s, BlockGathering<T>& g, const std::string& name, const RodConstants<T>& rod) {
  const auto end = [&](const Place<T>& at) { return near_end(s.work, g.unit, g.parts.velocity, g.parts.bias, at); };
  const NearEnd<T> from = end(rod.from), to = end(rod.to);
  const auto moved = [&](const PerBody<Spatial<T>>& motion) {
    const auto of = [&](const NearEnd<T>& e) {
      return e.body == g.unit.base ? Vector<T>{} : velocity_at(motion[e.body], e.arm);
    };
    return of(from) - of(to);
  };
  const T mass = -rod.coupling;
  const Vector<T> gap = from.place - to.place, scaled_gap = mass * gap;
  const Vector<T> rate = from.point_velocity() - to.point_velocity();
  const Vector<T> own = from.point_acceleration() - to.point_acceleration() + moved(g.parts.zdd_star_motion);
  const Vector<T> force = mass * (own + cross(g.twice, rate) + g.turning_field * gap);
  g.base.above = g.base.above + pseudo_inertia(T(0.0), Vector<T>{}, square(mass, gap));
  g.base.needed.angular = g.base.needed.angular + cross(gap, force);
  std::vector<Vector<T>> partial;
  for (const PerBody<Spatial<T>>& motion : g.parts.partial) partial.push_back(moved(motion));
  Annotator<T>& annotator = s.system().annotator;
  detail_name(annotator, scaled_gap, "mgap_", name);
  detail_name(annotator, rate, "vgap_", name);
  detail_name(annotator, own, "a0gap_", name, "_whole");
  detail_name(annotator, force, "f_", name);
  for (std::size_t q = 0; annotator.has_details() && q < partial.size(); ++q)
    detail_name(annotator, partial[q], "v_", name, "_per_", g.parts.directions[q]);
  for (std::size_t q = 0; q < partial.size(); ++q) {
    for (std::size_t d = 0; d <= q; ++d)
      g.equations.mass[q][d] = g.equations.mass[q][d] + mass * dot(partial[q], partial[d]);
    g.equations.momentum[q].angular = g.equations.momentum[q].angular + cross(scaled_gap, partial[q]);
    g.equations.force[q] = g.equations.force[q] - dot(partial[q], force);
  }
}

/// Equations of a block's free directions. Result: its share in its base.
template <class T>
CompositeBody<T> gather_block(RecursionState<T>& s, std::size_t u) {
  const System<T>& system = s.system();
  const RecursionUnit& unit = s.units()[u];
  BlockGathering<T> g = block_gathering(s, u);
  if (unit.base != kGround) {
    detail_name(system.annotator, g.twice, "twice_w_", system.body_name(unit.base));
    detail_name(system.annotator, g.turning_field, "G_", system.body_name(unit.base));
  }
  start_equations(s, g);
  for (auto step = unit.steps.rbegin(); step != unit.steps.rend(); ++step) {
    const auto heading = within_body(system.annotator, step->body());
    if (is_arm(s, unit, *step))
      gather_arm(s, g, step->body());
    else if (is_outer_arm(s, unit, *step))
      gather_outer_arm(s, g, *step);
    else if (is_in_subtree(s, unit, *step))
      gather_in_subtree(s, g, *step);
    else
      gather_body(s, g, step->body());
  }
  each_coupling_rod(system, system.topology.blocks[unit.block],
                    [&](const Rod& of_model, const RodConstants<T>& rod) { gather_rod(s, g, of_model.name, rod); });
  detail_equations(s, g.parts.directions, g.equations);
  detail_share(s, unit, g.base);
  return g.base;
}

/// Force that the angular velocity of a run's end asks for.
template <class T>
Spatial<T> turning_force(const RecursionState<T>& s, int end) {
  return field_force(s.composite[end].rigid, Vector<T>{}, acceleration_gradient(s.omega[end], Vector<T>{}));
}

/// Equations of a run's free directions about its end's origin, and its inertia and force there at zero accelerations.
template <class T>
void gather_run(RecursionState<T>& s, std::size_t u, UnitEquations<T>& equations, ArticulatedInertia<T>& inertia,
                Spatial<T>& needed) {
  const RecursionUnit& unit = s.units()[u];
  const RunParts<T>& run = s.runs[u];
  const CompositeBody<T>& body = s.composite[unit.end()];
  const PseudoInertia<T> whole = body.rigid + body.above;
  inertia = articulated(whole) + body.reduced;
  needed = body.needed + turning_force(s, unit.end()) + inertia * run.bias;
  Annotator<T>& annotator = s.system().annotator;
  const std::string& name_of_end = s.system().body_name(unit.end());
  annotator.detail(whole.mass, "mc_", name_of_end);
  detail_inertia(annotator, whole, "hc_", "Kc_", "Ic_", name_of_end);
  detail_articulated(annotator, inertia, name_of_end);
  detail_name(annotator, needed, "fc", "nc", name_of_end);
  detail_run_bias(s, u);
  for (std::size_t q = 0; q < run.directions.size(); ++q) {
    equations.momentum.push_back(inertia * run.directions[q]);
    equations.mass.emplace_back();
    for (std::size_t d = 0; d <= q; ++d) equations.mass[q].push_back(dot(run.directions[d], equations.momentum[q]));
    equations.force.push_back(s.force[run.columns[q]] - dot(run.directions[q], needed));
  }
  if (annotator.has_details()) detail_equations(s, directions_of(s, run), equations);
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
  const CompositeBody<T>& body = s.composite[unit.end()];
  const RunParts<T>& run = s.runs[u];
  const PseudoInertia<T> whole = body.rigid + body.above;
  const ArticulatedInertia<T> inertia = articulated(whole) + body.reduced;
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
  const std::string& name_of_end = s.system().body_name(unit.end());
  s.system().annotator.detail(whole.mass, "mc_", name_of_end);
  detail_inertia(s.system().annotator, whole, "hc_", "Kc_", "Ic_", name_of_end);
  detail_articulated(s.system().annotator, inertia, name_of_end);
  detail_name(s.system().annotator, available, "fc", "nc", name_of_end);
  const std::vector<Spatial<T>> units = unit_motions<T>(unit);
  for (std::size_t q = 0; q < units.size(); ++q) {
    const Spatial<T> momentum = inertia * units[q];
    equations.mass.emplace_back();
    for (std::size_t d = 0; d <= q; ++d) equations.mass[q].push_back(dot(units[d], momentum));
    equations.momentum.emplace_back();
    equations.force.push_back(dot(units[q], available));
  }
}

/// Adds what a run carries to the body that it moves on. The acceleration of its end's place by the velocities of the
/// base meets the inertia that is left, in the axes of the base: fewer entries than the whole.
template <class T>
void hand_down(RecursionState<T>& s, std::size_t u, const ArticulatedInertia<T>& inertia, const Spatial<T>& needed) {
  const RecursionUnit& unit = s.units()[u];
  if (unit.base == kGround) return;
  const Matrix<T>& axes = s.k().orientation[unit.end()];
  const Vector<T> place = s.from_base(unit, unit.end());
  const ArticulatedInertia<T> left = rotated(axes, inertia);
  const Spatial<T> force = rotated(axes, needed) + left * Spatial<T>{s.runs[u].carried, {}};
  Annotator<T>& annotator = s.system().annotator;
  const std::string& name_of_end = s.system().body_name(unit.end());
  detail_articulated(annotator, inertia, name_of_end, "_reduced");
  detail_articulated(annotator, left, name_of_end, "_down");
  detail_name(annotator, force, "f", "n", name_of_end, "_down");
  CompositeBody<T>& below = s.composite[unit.base];
  below.reduced = below.reduced + shifted(place, left);
  below.needed = below.needed + shifted(place, force);
}

}  // namespace mbgen::detail
