#pragma once
// Elimination of the free accelerations of a unit into the inertia and the force of its base, and the way back.

#include <utility>

#include "compiler/formulation/implicit/elimination.hpp"
#include "compiler/formulation/recursion/recursion_inertia.hpp"

namespace mbgen {

/// The equations of a unit's free directions, base acceleration unknown: mass q'' + momentum . A = force.
template <class T>
struct UnitEquations {
  std::vector<std::vector<T>> mass;  ///< lower triangle, [row][column <= row]
  std::vector<Spatial<T>> momentum;  ///< per direction, about the origin that A is of
  std::vector<T> force;              ///< per direction
  std::vector<T> reciprocal;         ///< after elimination: of the pivots
  std::vector<T> inertia;            ///< after elimination, see EliminatedPivots
  std::size_t size() const { return force.size(); }
};

/// Eliminates in place (theory.md section 4). rounding: of the diagonals; none in a tree, where nothing cancels.
template <class T>
void eliminate(UnitEquations<T>& u, const T& rounding = T(0.0), const T& lost = T(kLostByElimination)) {
  EliminatedPivots<T> pivots = eliminate(
      u.mass, rounding,
      [&](std::size_t a, const T& factor, std::size_t q) {
        u.momentum[a] = u.momentum[a] - factor * u.momentum[q];
        u.force[a] = u.force[a] - factor * u.force[q];
      },
      lost);
  u.reciprocal = std::move(pivots.reciprocal);
  u.inertia = std::move(pivots.inertia);
}

/// Takes the eliminated directions out of an inertia and adds the force that they transmit to the force of the base.
template <class T>
void reduce(const UnitEquations<T>& u, ArticulatedInertia<T>& inertia, Spatial<T>& needed) {
  for (std::size_t q = 0; q < u.size(); ++q) {
    const Spatial<T> scaled = u.reciprocal[q] * u.momentum[q];
    inertia = less_dyad(inertia, scaled, u.momentum[q]);
    needed = needed + u.force[q] * scaled;
  }
}

/// Accelerations of the free directions for an acceleration of the base.
template <class T>
std::vector<T> free_accelerations(const UnitEquations<T>& u, const Spatial<T>& base) {
  return substitute(u.mass, u.reciprocal, [&](std::size_t q) { return u.force[q] - dot(u.momentum[q], base); });
}

/// Component 0 to 5, linear ones first.
template <class T>
T& component(Spatial<T>& s, int c) {
  T* const components[] = {&s.linear.x, &s.linear.y, &s.linear.z, &s.angular.x, &s.angular.y, &s.angular.z};
  return *components[c];
}

/// The component of a direction that is known to be 1 or -1, all others zero; -1: there is none.
template <class T>
int unit_component(Spatial<T> direction) {
  int unit = -1, others = 0;
  for (int c = 0; c < 6; ++c) {
    const T& value = component(direction, c);
    if (known_size(value) == 1.0)
      unit = c;
    else if (!is_zero(value))
      ++others;
  }
  return others > 0 ? -1 : unit;
}

/// The same of a body with these directions. If a direction is a component, the unknown is this component of the body's
/// acceleration: its own part and the base's part use the same column of the equations.
template <class T>
std::vector<T> free_accelerations(const UnitEquations<T>& u, std::vector<Spatial<T>> directions,
                                  const Spatial<T>& base) {
  Spatial<T> moving = base, rest = base;
  for (const Spatial<T>& d : directions)
    if (const int c = unit_component(d); c >= 0) component(rest, c) = T(0.0);
  std::vector<T> free = free_accelerations(u, rest);
  for (std::size_t q = 0; q < free.size(); ++q)
    if (const int c = unit_component(directions[q]); c >= 0)
      free[q] = free[q] - component(directions[q], c) * component(moving, c);
  return free;
}

/// The symmetric operator without the rows and columns of directions that are unit vectors: elimination leaves zeros
/// there, known before any arithmetic.
template <class T>
void clear_directions(const std::vector<Spatial<T>>& directions, ArticulatedInertia<T>& m) {
  const T zero(0.0);
  for (const Spatial<T>& d : directions) {
    const int unit = unit_component(d);
    if (unit < 0) continue;
    Symmetric<T>& s = unit < 3 ? m.linear : m.angular;
    T* const in_symmetric[3][3] = {{&s.xx, &s.xy, &s.xz}, {&s.xy, &s.yy, &s.yz}, {&s.xz, &s.yz, &s.zz}};
    for (int c = 0; c < 3; ++c) *in_symmetric[unit % 3][c] = zero;
    Vector<T>* const columns[] = {&m.coupling.x, &m.coupling.y, &m.coupling.z};
    for (int c = 0; c < 3; ++c) {
      Vector<T>& column = unit < 3 ? *columns[c] : *columns[unit - 3];
      T* const rows[] = {&column.x, &column.y, &column.z};
      *rows[unit < 3 ? unit : c] = zero;
    }
  }
}

}  // namespace mbgen
