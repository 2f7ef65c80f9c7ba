#pragma once
// The linear equations of an implicit step, (M - g D - g^2 K) v = right-hand side in the free directions, where v is
// the change of their velocities in addition to an explicit step, g the method's factor times the step, M the reduced
// mass matrix (63), and K and D are the tangents of the force elements. Source: docs/method/implicit.md.

#include <cstddef>
#include <utility>
#include <vector>

#include "compiler/formulation/dynamics.hpp"
#include "compiler/formulation/implicit/implicit_elements.hpp"

namespace mbgen {

/// Matrix of an implicit step, factorised, with what makes right-hand sides.
template <class T>
struct ImplicitEquations {
  ImplicitFactors<T> directions;  ///< of the matrix: the motions of elements by themselves, then the free directions
  std::vector<ImplicitElement<T>> elements;
  std::vector<std::vector<std::vector<T>>> rz;  ///< per joint group: [coordinate][direction]
};

/// The equations of a step with the values that a solver watches.
template <class T>
struct WatchedEquations {
  ImplicitEquations<T> equations;
  std::vector<T> quality;      ///< per block, see FrozenFactors
  std::vector<T> pivot;        ///< per free direction, not positive where the equations do not determine it
  std::vector<T> state_pivot;  ///< likewise, per state of the user's own; those of other states are always positive
};

/// Parts of the right-hand sides: rates of coordinates, velocities and auxiliary states.
template <class T>
struct ImplicitRates {
  std::vector<T> zd, zdd, xd;
};

namespace detail {

/// Calls visit(value) for every entry, in an order of its own.
template <class T, class Visit>
void each_entry(ImplicitEquations<T>& equations, const Visit& visit) {
  const auto row = [&](std::vector<T>& values) {
    for (T& value : values) visit(value);
  };
  const auto matrix = [&](std::vector<std::vector<T>>& values) {
    for (std::vector<T>& one : values) row(one);
  };
  const auto factors = [&](ImplicitFactors<T>& f) {
    matrix(f.lower);
    matrix(f.factor);
    row(f.reciprocal);
  };
  for (ImplicitElement<T>& element : equations.elements) {
    for (SparseRow<T>& one : element.rows) row(one.values);
    for (std::vector<std::vector<T>>* values :
         {&element.both, &element.stiffness, &element.by_state, &element.state_by_velocity, &element.state_by_position})
      matrix(*values);
    factors(element.factors);
  }
  factors(equations.directions);
  for (std::vector<std::vector<T>>& group : equations.rz) matrix(group);
}

/// Calls visit(row of Rz, coordinate, first free direction of the row).
template <class T, class Visit>
void each_rz_row(const Topology& topology, const std::vector<std::vector<std::vector<T>>>& rz, const Visit& visit) {
  std::size_t first = 0;
  for (std::size_t g = 0; g < topology.groups.size(); ++g) {
    const std::vector<int>& joints = topology.groups[g].joints;
    for (std::size_t c = 0; c < joints.size(); ++c) visit(rz[g][c], joints[c], first);
    first += rz[g].empty() ? 0 : rz[g][0].size();
  }
}

/// Rz times values of the free directions: per coordinate of the tree.
template <class T>
std::vector<T> along_directions(const Topology& topology, const ImplicitEquations<T>& e, const std::vector<T>& free) {
  std::vector<T> result(topology.bodies.size(), T(0.0));
  each_rz_row(topology, e.rz, [&](const std::vector<T>& row, int coordinate, std::size_t first) {
    for (std::size_t q = 0; q < row.size(); ++q)
      result[coordinate] = result[coordinate] + Slope<T>::times(row[q], free[first + q]);
  });
  return result;
}

/// Rz' times values of the tree's coordinates: per free direction.
template <class T>
std::vector<T> onto_directions(const Topology& topology, const ImplicitEquations<T>& e, std::size_t directions,
                               const std::vector<T>& values) {
  std::vector<T> result(directions, T(0.0));
  each_rz_row(topology, e.rz, [&](const std::vector<T>& row, int coordinate, std::size_t first) {
    for (std::size_t q = 0; q < row.size(); ++q)
      result[first + q] = result[first + q] + Slope<T>::times(row[q], values[coordinate]);
  });
  return result;
}

/// Rows over the tree's coordinates as rows over the free directions.
template <class T>
std::vector<SparseRow<T>> onto_directions(const Topology& topology, const ImplicitEquations<T>& e,
                                          std::size_t directions, const std::vector<SparseRow<T>>& rows) {
  std::vector<SparseRow<T>> result;
  for (const SparseRow<T>& row : rows) {
    std::vector<T> values(topology.bodies.size(), T(0.0));
    for (std::size_t i = 0; i < row.columns.size(); ++i) values[row.columns[i]] = row.values[i];
    result.push_back(without_zeros(onto_directions(topology, e, directions, values)));
  }
  return result;
}

/// Whether an element couples many more directions than the mass matrix and than its own row has: then its motion is an
/// unknown by itself, whose row and column leave the directions apart. rows: over the free directions.
template <class T>
bool couples_apart(const ImplicitElement<T>& element, const std::vector<SparseRow<T>>& rows,
                   const std::vector<std::vector<T>>& mass) {
  if (rows.size() != 1 || is_zero(element.both[0][0])) return false;
  const std::vector<int>& directions = rows[0].columns;
  std::size_t apart = 0;
  for (std::size_t i = 0; i < directions.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) apart += is_zero(mass[directions[i]][directions[j]]) ? 1 : 0;
  return apart > 2 * directions.size();
}

/// The matrix of a step over the motions of elements by themselves, v_e = J v, and the free directions.
template <class T>
struct ImplicitMatrix {
  MirroredMatrix<T> matrix;
  std::vector<int> first_directions;  ///< per single element, of its moving directions
};

/// Forces of elements by velocities, summed: over the free directions. Of symmetric ones the lower triangle.
template <class T>
struct ElementSums {
  std::vector<std::vector<T>> symmetric, other;
};

/// Adds Rz' matrix Rz. matrix: over the tree's coordinates; is_symmetric: its lower triangle alone, as in the result.
template <class T>
void add_projected(const Topology& topology, const ImplicitEquations<T>& e, std::vector<std::vector<T>> matrix,
                   bool is_symmetric, std::vector<std::vector<T>>& to) {
  const std::size_t n = to.size();
  for (std::size_t a = 0; a < (is_symmetric ? matrix.size() : 0); ++a)
    for (std::size_t b = 0; b < a; ++b) matrix[b][a] = matrix[a][b];
  for (std::vector<T>& row : matrix) row = onto_directions(topology, e, n, row);
  each_rz_row(topology, e.rz, [&](const std::vector<T>& rz, int coordinate, std::size_t first) {
    for (std::size_t r = 0; r < rz.size(); ++r)
      for (std::size_t d = 0; d < (is_symmetric ? first + r + 1 : n); ++d)
        to[first + r][d] = to[first + r][d] + Slope<T>::times(rz[r], matrix[coordinate][d]);
  });
}

/// The sums over all elements, except elements that couple otherwise uncoupled directions: their rows and factors go to
/// `apart`. An element is summed over the tree's coordinates if these are not more than its directions: many elements
/// then share one projection.
template <class T>
ElementSums<T> element_sums(const Topology& topology, const ImplicitEquations<T>& e,
                            const std::vector<std::vector<T>>& mass, std::vector<std::pair<SparseRow<T>, T>>& apart) {
  const std::size_t n = mass.size(), coordinates = topology.bodies.size();
  ElementSums<T> sums{zeros<T>(n, n), zeros<T>(n, n)};
  std::vector<std::vector<T>> symmetric = zeros<T>(coordinates, coordinates), other = symmetric;
  for (const ImplicitElement<T>& element : e.elements) {
    const std::vector<SparseRow<T>> rows = onto_directions(topology, e, n, element.rows);
    if (couples_apart(element, rows, mass)) {
      apart.emplace_back(rows[0], element.both[0][0]);
      continue;
    }
    const bool in_tree = columns_of(element.rows).size() <= columns_of(rows).size();
    std::vector<std::vector<T>>& to = in_tree                ? element.is_symmetric ? symmetric : other
                                      : element.is_symmetric ? sums.symmetric
                                                             : sums.other;
    add_projected(in_tree ? element.rows : rows, element.both, element.is_symmetric, to);
  }
  add_projected(topology, e, std::move(symmetric), true, sums.symmetric);
  add_projected(topology, e, std::move(other), false, sums.other);
  return sums;
}

/// mass: reduced, its lower triangle.
template <class T>
ImplicitMatrix<T> implicit_matrix(const Topology& topology, const ImplicitEquations<T>& e,
                                  const std::vector<std::vector<T>>& mass) {
  std::vector<std::pair<SparseRow<T>, T>> apart;
  const auto [symmetric, other] = element_sums(topology, e, mass, apart);
  const std::size_t n = mass.size(), first = apart.size();
  ImplicitMatrix<T> result{MirroredMatrix<T>(first + n), {}};
  for (std::size_t q = 0; q < n; ++q)
    for (std::size_t d = 0; d <= q; ++d) {
      const T shared = mass[q][d] - symmetric[q][d];
      if (is_zero(other[q][d]) && is_zero(other[d][q])) {
        result.matrix.set_pair(first + q, first + d, shared);
      } else {
        result.matrix.entry[first + q][first + d] = shared - other[q][d];
        result.matrix.entry[first + d][first + q] = shared - other[d][q];
      }
    }
  for (std::size_t u = 0; u < first; ++u) {
    const auto& [row, both] = apart[u];
    result.first_directions.push_back(row.columns[0]);
    result.matrix.entry[u][u] = T(1.0);
    for (std::size_t i = 0; i < row.columns.size(); ++i) {
      result.matrix.entry[u][first + row.columns[i]] = -row.values[i];
      result.matrix.entry[first + row.columns[i]][u] = Slope<T>::times(-both, row.values[i]);
    }
  }
  return result;
}

}  // namespace detail

/// The equations at a state. g: the method's factor times the step, s. Cost: as the equations of motion in the matrix
/// form, and a dense elimination of the structural nonzeros.
template <class T, class Partitions>
WatchedEquations<T> implicit_equations(System<T>& system, const Partitions& partitions, const std::vector<bool>& driven,
                                       const T& g) {
  const Topology& topology = system.topology;
  WatchedEquations<T> watched;
  ImplicitEquations<T>& e = watched.equations;
  const Kinematics<T> k = kinematics(system);
  const Velocities<T> v = velocities(system, k);
  const std::vector<GroupProjection<T>> projections =
      frozen_directions(system, k, partitions, driven, &watched.quality);
  for (const GroupProjection<T>& p : projections) e.rz.push_back(p.rz);
  watched.state_pivot.assign(system.model.states.size(), T(1.0));
  for (ElementTangents<T>& element : force_tangents(system, k, v))
    e.elements.push_back(
        detail::implicit_element(std::move(element), g, first_user_state(system.model), watched.state_pivot));
  e.elements = detail::united_where_less(std::move(e.elements));
  const ReducedSystem<T> reduced =
      reduced_system(system, k, inertias(system, k), projections, std::vector<T>(topology.bodies.size(), T(0.0)));
  auto [matrix, first_directions] = detail::implicit_matrix(topology, e, reduced.mass);
  WatchedFactors<T> factors = implicit_factors(std::move(matrix));
  e.directions = std::move(factors.factors);
  const auto pivots = factors.pivot.begin() + static_cast<std::ptrdiff_t>(first_directions.size());
  watched.pivot.assign(pivots, factors.pivot.end());
  using std::min;
  for (std::size_t u = 0; u < first_directions.size(); ++u) {
    T& pivot = watched.pivot[first_directions[u]];
    pivot = min(pivot, factors.pivot[u]);
  }
  return watched;
}

/// Changes of auxiliary states for given rates, where nothing moves.
template <class T>
std::vector<T> state_changes(const ImplicitEquations<T>& e, const T& g, const std::vector<T>& rates) {
  std::vector<T> changes;
  for (const T& rate : rates) changes.push_back(g * rate);
  for (const ImplicitElement<T>& element : e.elements) {
    std::vector<T> right;
    for (const int state : element.states) right.push_back(rates[state]);
    solve(element.factors, right);
    for (std::size_t s = 0; s < right.size(); ++s) changes[element.states[s]] = right[s];
  }
  return changes;
}

namespace detail {

/// Rates and changes along the coordinates of the tree.
template <class T>
struct TreeChanges {
  std::vector<T> zd;      ///< rates of positions
  std::vector<T> change;  ///< of velocities
};

/// Forces of the elements by changes, times g: per coordinate of the tree. states: changes of the auxiliary states
/// where nothing moves.
template <class T>
std::vector<T> element_forces(const ImplicitEquations<T>& e, const TreeChanges<T>& tree, const std::vector<T>& states) {
  using S = Slope<T>;
  std::vector<T> result(tree.zd.size(), T(0.0));
  for (const ImplicitElement<T>& element : e.elements) {
    std::vector<T> position, velocity, still;
    for (const SparseRow<T>& row : element.rows) {
      position.push_back(product(row, tree.zd));
      velocity.push_back(product(row, tree.change));
    }
    for (const int state : element.states) still.push_back(states[state]);
    for (std::size_t a = 0; a < element.rows.size(); ++a) {
      T force = product(element.both[a], velocity) + product(element.stiffness[a], position);
      if (!still.empty()) force = force + product(element.by_state[a], still);
      const SparseRow<T>& row = element.rows[a];
      for (std::size_t i = 0; i < row.columns.size(); ++i)
        result[row.columns[i]] = result[row.columns[i]] + S::times(row.values[i], force);
    }
  }
  return result;
}

/// Adds to changes of auxiliary states those by the motion.
template <class T>
void add_motion(const ImplicitEquations<T>& e, const TreeChanges<T>& tree, std::vector<T>& changes) {
  for (const ImplicitElement<T>& element : e.elements) {
    if (element.states.empty()) continue;
    std::vector<T> position, velocity;
    for (const SparseRow<T>& row : element.rows) {
      position.push_back(product(row, tree.zd));
      velocity.push_back(product(row, tree.change));
    }
    for (std::size_t s = 0; s < element.states.size(); ++s)
      changes[element.states[s]] = changes[element.states[s]] + product(element.state_by_velocity[s], velocity) +
                                   product(element.state_by_position[s], position);
  }
}

}  // namespace detail

/// Changes of velocities and auxiliary states, in place of given rates: they solve (1 / g - A) change = rates, A with
/// the tangents alone. rates: of coordinates, velocities and states. free: the coordinate of each free direction, group
/// by group. Result: zdd and xd; no zd, whose change is g times its rate and the change of its velocity.
template <class T>
ImplicitRates<T> implicit_changes(const Topology& topology, const std::vector<int>& free, const ImplicitEquations<T>& e,
                                  const T& g, const ImplicitRates<T>& rates) {
  std::vector<T> zd, change;
  for (const int i : free) {
    zd.push_back(rates.zd[i]);
    change.push_back(g * rates.zdd[i]);
  }
  detail::TreeChanges<T> tree{detail::along_directions(topology, e, zd), detail::along_directions(topology, e, change)};
  ImplicitRates<T> result;
  result.xd = state_changes(e, g, rates.xd);
  const std::vector<T> right =
      detail::onto_directions(topology, e, free.size(), detail::element_forces(e, tree, result.xd));
  std::vector<T> more(e.directions.reciprocal.size() - right.size(), T(0.0));  // than an explicit method changes
  const auto directions = static_cast<std::ptrdiff_t>(more.size());
  more.insert(more.end(), right.begin(), right.end());
  solve(e.directions, more);
  more.erase(more.begin(), more.begin() + directions);
  const std::vector<T> along = detail::along_directions(topology, e, more);
  for (std::size_t i = 0; i < along.size(); ++i) {
    result.zdd.push_back(g * rates.zdd[i] + along[i]);
    tree.change[i] = tree.change[i] + along[i];
  }
  detail::add_motion(e, tree, result.xd);
  return result;
}

}  // namespace mbgen
