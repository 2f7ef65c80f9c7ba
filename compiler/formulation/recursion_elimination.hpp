#pragma once
// Elimination of the free accelerations of a unit into the inertia and the force of its base, and the way back.

#include "compiler/formulation/recursion_inertia.hpp"

namespace mbgen {

/// The equations of a unit's free directions, base acceleration unknown: mass q'' + momentum . A = force.
template <class T>
struct UnitEquations {
  std::vector<std::vector<T>> mass;  ///< lower triangle, [row][column <= row]
  std::vector<Spatial<T>> momentum;  ///< per direction, about the origin that A is of
  std::vector<T> force;              ///< per direction
  std::vector<T> reciprocal;         ///< after elimination: of the pivots
  std::vector<T> inertia;            ///< after elimination: pivot less 1e-12 of its diagonal
  std::size_t size() const { return force.size(); }
};

/// Eliminates in place, last direction first; afterwards `mass` holds the rows that the way back needs.
template <class T>
void eliminate(UnitEquations<T>& u) {
  const std::size_t n = u.size();
  std::vector<T> diagonal;
  for (std::size_t q = 0; q < n; ++q) diagonal.push_back(u.mass[q][q]);
  u.reciprocal.assign(n, T(0.0));
  u.inertia.assign(n, T(0.0));
  for (std::size_t q = n; q-- > 0;) {
    u.inertia[q] = u.mass[q][q] - T(1e-12) * diagonal[q];
    u.reciprocal[q] = T(1.0) / u.mass[q][q];
    for (std::size_t a = 0; a < q; ++a) {
      if (is_zero(u.mass[q][a])) continue;
      const T factor = u.mass[q][a] * u.reciprocal[q];
      for (std::size_t b = 0; b <= a; ++b)
        if (!is_zero(u.mass[q][b])) u.mass[a][b] = u.mass[a][b] - factor * u.mass[q][b];
      u.momentum[a] = u.momentum[a] - factor * u.momentum[q];
      u.force[a] = u.force[a] - factor * u.force[q];
    }
  }
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
  std::vector<T> acceleration;
  for (std::size_t q = 0; q < u.size(); ++q) {
    T value = u.force[q] - dot(u.momentum[q], base);
    for (std::size_t a = 0; a < q; ++a)
      if (!is_zero(u.mass[q][a])) value = value - u.mass[q][a] * acceleration[a];
    acceleration.push_back(value * u.reciprocal[q]);
  }
  return acceleration;
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
