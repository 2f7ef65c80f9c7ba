#pragma once
// Elimination of the free accelerations of a unit into the inertia and the force of its base, and the way back.

#include <utility>

#include "compiler/formulation/elimination.hpp"
#include "compiler/formulation/recursion_inertia.hpp"

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
void eliminate(UnitEquations<T>& u, double rounding = 0) {
  EliminatedPivots<T> pivots = eliminate(u.mass, rounding, [&](std::size_t a, const T& factor, std::size_t q) {
    u.momentum[a] = u.momentum[a] - factor * u.momentum[q];
    u.force[a] = u.force[a] - factor * u.force[q];
  });
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

/// The symmetric operator without the rows and columns of directions that are unit vectors: elimination leaves zeros
/// there, known before any arithmetic.
template <class T>
void clear_directions(const std::vector<Spatial<T>>& directions, ArticulatedInertia<T>& m) {
  const T zero(0.0);
  for (const Spatial<T>& d : directions) {
    const T* components[] = {&d.linear.x, &d.linear.y, &d.linear.z, &d.angular.x, &d.angular.y, &d.angular.z};
    int unit = -1, others = 0;
    for (int c = 0; c < 6; ++c) {
      if (known_size(*components[c]) == 1.0)
        unit = c;
      else if (!is_zero(*components[c]))
        ++others;
    }
    if (unit < 0 || others > 0) continue;
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
