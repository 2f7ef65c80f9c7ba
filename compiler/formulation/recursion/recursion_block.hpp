#pragma once
// Recursive form: the projected equations (63) of one loop block in the making, and what a body of it needs.

#include "compiler/formulation/recursion/recursion_bias.hpp"

namespace mbgen::detail {

/// Inertia and needed force of a body as its own block or run sees them at zero base and free accelerations.
/// a, gradient: acceleration field of the body about its origin.
template <class T>
Spatial<T> needed_in(const CompositeBody<T>& c, const Vector<T>& a, const Vector<T>& alpha, const Matrix<T>& gradient) {
  const Spatial<T> motion{a, alpha};
  return c.needed + field_force(c.rigid, a, gradient) + c.above * motion + c.reduced * motion;
}

/// Composite inertia of the bodies of a block that move on one of its bodies, about the origin of that body.
template <class T>
struct SubtreeInertia {
  bool is_empty = true;
  PseudoInertia<T> inertia;
  Spatial<T> needed;
  std::vector<Spatial<T>> momentum;  ///< per free direction: of their motion against this body
};

/// Arms that turn with a body of a block, about its origin in its own axes, like parts of it.
template <class T>
struct OuterArms {
  bool is_empty = true;
  PseudoInertia<T> rigid;
  Spatial<T> needed;  ///< by their motion against the body
};

/// Equations of a block in the making, and its share in its base about the base's origin.
template <class T>
struct BlockGathering {
  const RecursionUnit& unit;
  BlockParts<T>& parts;
  UnitEquations<T>& equations;
  Vector<T> turning, twice;  ///< angular velocity of the base, and twice that
  Matrix<T> turning_field;   ///< w~w~ of it
  CompositeBody<T> base;
  PerBody<SubtreeInertia<T>> subtree;
  PerBody<OuterArms<T>> arms;
};

/// Nothing gathered yet.
template <class T>
BlockGathering<T> block_gathering(RecursionState<T>& s, std::size_t u) {
  const RecursionUnit& unit = s.units()[u];
  const Vector<T> turning = s.omega_of(unit.base);
  return {unit,
          s.blocks[u],
          s.equations[u],
          turning,
          turning + turning,
          acceleration_gradient(turning, Vector<T>{}),
          {},
          PerBody<SubtreeInertia<T>>(unit),
          PerBody<OuterArms<T>>(unit)};
}

/// The free directions: motion of the bodies, forces on the joints.
template <class T>
void start_equations(RecursionState<T>& s, BlockGathering<T>& g) {
  const RecursionUnit& unit = g.unit;
  const std::size_t free = g.parts.rz.empty() ? 0 : g.parts.rz[0].size();
  for (std::size_t q = 0; q < free; ++q) {
    std::vector<T> column(unit.joints.size());
    for (std::size_t c = 0; c < column.size(); ++c) column[c] = g.parts.rz[c][q];
    g.parts.partial.push_back(block_motion(s.work, unit, per_joint(unit, column)));
    for (const JointStep& moving : unit.steps) {
      if (!s.system().annotator.has_details()) break;
      const auto heading = within_body(s.system().annotator, moving.body());
      detail_name(s.system().annotator, g.parts.partial[q][moving.body()], "v", "w",
                  s.system().body_name(moving.body()), "_per_", g.parts.directions[q]);
    }
    g.equations.mass.emplace_back(q + 1, T(0.0));
    g.equations.momentum.emplace_back();
    T force(0.0);
    for (std::size_t c = 0; c < column.size(); ++c) force = force + column[c] * s.force[unit.joints[c]];
    g.equations.force.push_back(force);
  }
  g.parts.zdd_star_motion = block_motion(s.work, unit, per_joint(unit, g.parts.zdd_star));
  for (const JointStep& moving : unit.steps) {
    if (!s.system().annotator.has_details()) break;
    const auto heading = within_body(s.system().annotator, moving.body());
    detail_name(s.system().annotator, g.parts.zdd_star_motion[moving.body()], "astar", "alphastar",
                s.system().body_name(moving.body()));
  }
}

/// A motion about another point of the body, `arm` from where it is given.
template <class T>
Spatial<T> about_point(const Spatial<T>& motion, const Vector<T>& arm) {
  return {velocity_at(motion, arm), motion.angular};
}

/// Adds a body's part of the projected equations, about the point `arm` from its origin and `place` from the base's.
/// needed: by its own free directions.
template <class T>
void add_to_equations(RecursionState<T>& s, BlockGathering<T>& g, int i, const Vector<T>& arm, const Vector<T>& place,
                      const PseudoInertia<T>& whole, const ArticulatedInertia<T>& reduced, const Spatial<T>& needed) {
  std::vector<Spatial<T>> partial;
  for (const PerBody<Spatial<T>>& motion : g.parts.partial) partial.push_back(about_point(motion[i], arm));
  const bool has_details = s.system().annotator.has_details();
  const std::string& body = s.system().body_name(i);
  if (has_details) detail_inertia(s.system().annotator, whole, "hc_", "Kc_", "Ic_", body);
  for (std::size_t q = 0; q < partial.size(); ++q) {
    const Spatial<T> momentum = whole * partial[q] + reduced * partial[q];
    if (has_details) {
      detail_name(s.system().annotator, partial[q], "vc", "wc", body, "_per_", g.parts.directions[q]);
      detail_name(s.system().annotator, momentum, "F", "N", body, "_per_", g.parts.directions[q]);
    }
    for (std::size_t d = 0; d <= q; ++d) g.equations.mass[q][d] = g.equations.mass[q][d] + dot(partial[d], momentum);
    g.equations.momentum[q] = g.equations.momentum[q] + shifted(place, momentum);
    g.equations.force[q] = g.equations.force[q] - dot(partial[q], needed);
  }
}

/// Whether a unit with a door of its own moves on a body.
template <class T>
bool bears_units(const RecursionState<T>& s, int body) {
  const std::vector<int>& on_body = s.work.recursion.on_body[body];
  return std::any_of(on_body.begin(), on_body.end(), [&](int u) { return !s.units()[u].rotor; });
}

/// Acceleration of the point `arm` from the origin of a body of a block at zero base and free accelerations.
template <class T>
Spatial<T> acceleration_of(const RecursionState<T>& s, const BlockGathering<T>& g, int i, const Vector<T>& arm) {
  const Spatial<T> v = about_point(g.parts.velocity[i], arm), extra = about_point(g.parts.zdd_star_motion[i], arm);
  const BodyAcceleration<T>& bias = g.parts.bias[i];
  const Vector<T> place = s.k().position[i] + arm;
  Vector<T> a = bias.linear + bias.gradient * arm + extra.linear + g.turning_field * place + cross(g.twice, v.linear);
  if (g.unit.base == kGround) a = a - s.system().constants.gravity;
  const Vector<T> alpha = bias.angular + extra.angular + cross(g.turning, v.angular);
  detail_name(s.system().annotator, a, "a0_", s.system().body_name(i));
  detail_name(s.system().annotator, alpha, "alpha0_", s.system().body_name(i));
  return {a, alpha};
}

/// Force that a body of a block needs at zero base and free accelerations, about the point `arm` from its origin.
template <class T>
Spatial<T> needed_of(RecursionState<T>& s, BlockGathering<T>& g, int i, const CompositeBody<T>& body,
                     const Vector<T>& arm) {
  const Spatial<T> a = acceleration_of(s, g, i, arm);
  const Matrix<T> gradient = acceleration_gradient(g.turning + g.parts.velocity[i].angular, a.angular);
  detail_name(s.system().annotator, gradient, "G_", s.system().body_name(i));
  const Spatial<T> needed = needed_in(body, a.linear, a.angular, gradient);
  name(s.system().annotator, needed, "f", "n", s.system().body_name(i));
  return needed;
}

}  // namespace mbgen::detail
