#pragma once
// The linear equations of an implicit step, (M - g D - g^2 K) v = right-hand side in the free directions, where v is
// the change of their velocities, g the method's factor times the step, M the reduced mass matrix (63), and K and D are
// the tangents of the force elements.
// Source: docs/method/implicit.md.

#include <cstddef>
#include <utility>
#include <vector>

#include "compiler/formulation/dynamics.hpp"
#include "compiler/formulation/implicit_factors.hpp"
#include "compiler/formulation/tangents.hpp"

namespace mbgen {

/// Auxiliary states that depend on each other, and the factors of 1 / g less the derivatives of their rates.
template <class T>
struct StateEquations {
  std::vector<int> states;
  ImplicitFactors<T> factors;
};

/// Matrix of an implicit step, factorised, with what makes right-hand sides. Matrices are [row][column].
template <class T>
struct ImplicitEquations {
  ImplicitFactors<T> directions;                ///< of the matrix
  std::vector<std::vector<T>> mass, stiffness;  ///< g M, its lower triangle, and g^2 K
  std::vector<StateEquations<T>> states;        ///< of those that are eliminated; the others change as they are told
  std::vector<std::vector<T>> by_state;         ///< right-hand side by the changes of auxiliary states
  /// changes of auxiliary states by those of velocities and by the rates of positions
  std::vector<std::vector<T>> state_by_velocity, state_by_position;
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

/// What right-hand sides are made of: rates of coordinates, velocities and auxiliary states.
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
  matrix(equations.directions.lower);
  matrix(equations.directions.factor);
  for (std::vector<std::vector<T>>* values : {&equations.mass, &equations.stiffness, &equations.by_state,
                                              &equations.state_by_velocity, &equations.state_by_position})
    matrix(*values);
  row(equations.directions.reciprocal);
  for (StateEquations<T>& block : equations.states) {
    matrix(block.factors.lower);
    matrix(block.factors.factor);
    row(block.factors.reciprocal);
  }
  for (std::vector<std::vector<T>>& group : equations.rz) matrix(group);
}

/// sum of a_i b_i, without the products that are zero.
template <class T>
T product(const std::vector<T>& a, const std::vector<T>& b) {
  T sum(0.0);
  for (std::size_t i = 0; i < a.size(); ++i)
    if (!is_zero(a[i]) && !is_zero(b[i])) sum = sum + a[i] * b[i];
  return sum;
}

/// A row over the tree's coordinates as one over the free directions.
template <class T>
std::vector<T> projected_row(const Topology& topology, const std::vector<GroupProjection<T>>& projections,
                             const std::vector<T>& row) {
  std::vector<T> result;
  for (std::size_t g = 0; g < topology.groups.size(); ++g) {
    const std::vector<int>& joints = topology.groups[g].joints;
    for (std::size_t q = 0; q < (projections[g].rz.empty() ? 0 : projections[g].rz[0].size()); ++q) {
      T sum(0.0);
      for (std::size_t c = 0; c < joints.size(); ++c)
        if (!is_zero(row[joints[c]]) && !is_zero(projections[g].rz[c][q]))
          sum = sum + row[joints[c]] * projections[g].rz[c][q];
      result.push_back(sum);
    }
  }
  return result;
}

/// Whether a row and a column of a matrix have no entry but that on the diagonal.
template <class T>
bool stands_alone(const std::vector<std::vector<T>>& matrix, std::size_t a) {
  for (std::size_t b = 0; b < matrix.size(); ++b)
    if (b != a && !(is_zero(matrix[a][b]) && is_zero(matrix[b][a]))) return false;
  return true;
}

/// to += rows' matrix rows. matrix: over the rows; a symmetric sum stays symmetric where all rows stand alone.
template <class T>
void add_projected(const std::vector<std::vector<T>>& rows, const std::vector<std::vector<T>>& matrix,
                   std::vector<std::vector<T>>& to) {
  const std::size_t n = to.size();
  for (std::size_t a = 0; a < rows.size(); ++a) {
    const bool is_alone = stands_alone(matrix, a);
    std::vector<T> moved(n, T(0.0));
    for (std::size_t b = 0; b < rows.size(); ++b)
      for (std::size_t d = 0; d < n; ++d)
        if (!is_zero(matrix[a][b]) && !is_zero(rows[b][d])) moved[d] = moved[d] + matrix[a][b] * rows[b][d];
    for (std::size_t q = 0; q < n; ++q) {
      for (std::size_t d = 0; d < (is_alone ? q + 1 : n); ++d) {
        if (is_zero(rows[a][q]) || is_zero(moved[d])) continue;
        const T value = rows[a][q] * moved[d];
        to[q][d] = to[q][d] + value;
        if (is_alone && d != q) to[d][q] = to[d][q] + value;
      }
    }
  }
}

/// to += factors' rows.
template <class T>
void add_weighted(const std::vector<T>& factors, const std::vector<std::vector<T>>& rows, std::vector<T>& to) {
  for (std::size_t b = 0; b < rows.size(); ++b)
    for (std::size_t d = 0; d < to.size(); ++d)
      if (!is_zero(factors[b]) && !is_zero(rows[b][d])) to[d] = to[d] + factors[b] * rows[b][d];
}

/// Sums over the elements: g D + g^2 K, and g^2 K alone.
template <class T>
struct TangentSums {
  std::vector<std::vector<T>> both, stiffness;
};

/// Columns that solve the equations of states, for columns of a matrix [state][column].
template <class T>
std::vector<std::vector<T>> solved_columns(const ImplicitFactors<T>& factors, std::vector<std::vector<T>> matrix) {
  for (std::size_t b = 0; b < (matrix.empty() ? 0 : matrix[0].size()); ++b) {
    std::vector<T> column;
    for (const std::vector<T>& row : matrix) column.push_back(row[b]);
    solve(factors, column);
    for (std::size_t s = 0; s < column.size(); ++s) matrix[s][b] = column[s];
  }
  return matrix;
}

/// Eliminates the auxiliary states of an element into its tangents: their changes are those that solve
/// (1 / g - F) change = rates + P (change of positions) + Q (change of velocities). rows: of the element over the free
/// directions.
template <class T>
void eliminate_states(const std::vector<std::vector<T>>& rows, ElementTangents<T>& element, const T& g, int first_user,
                      WatchedEquations<T>& watched) {
  using S = Slope<T>;
  ImplicitEquations<T>& e = watched.equations;
  const std::size_t states = element.states.size(), size = rows.size();
  const T reciprocal = T(1.0) / g;
  std::vector<std::vector<T>> matrix = zeros<T>(states, states);
  for (std::size_t s = 0; s < states; ++s)
    for (std::size_t t = 0; t < states; ++t)
      matrix[s][t] = (s == t ? reciprocal : T(0.0)) - element.rate_by_state[s][t];
  WatchedFactors<T> factors = implicit_factors(std::move(matrix), false);
  const std::vector<std::vector<T>> by_position = solved_columns(factors.factors, element.rate_by_position),
                                    by_velocity = solved_columns(factors.factors, element.rate_by_velocity);
  for (std::size_t s = 0; s < states; ++s) {
    const int state = element.states[s];
    if (state >= first_user) watched.state_pivot[state - first_user] = factors.pivot[s];
    std::vector<T> of_velocity, of_position, forces;
    for (std::size_t b = 0; b < size; ++b) {
      of_position.push_back(S::times(g, by_position[s][b]));
      of_velocity.push_back(by_velocity[s][b] + of_position[b]);
      for (std::size_t a = 0; a < size; ++a) {
        element.by_velocity[a][b] = element.by_velocity[a][b] + S::times(element.by_state[a][s], by_velocity[s][b]);
        element.by_position[a][b] = element.by_position[a][b] + S::times(element.by_state[a][s], by_position[s][b]);
      }
    }
    add_weighted(of_velocity, rows, e.state_by_velocity[state]);
    add_weighted(of_position, rows, e.state_by_position[state]);
    for (std::size_t a = 0; a < size; ++a) forces.push_back(S::times(g, element.by_state[a][s]));
    std::vector<T> right(e.by_state.size(), T(0.0));
    add_weighted(forces, rows, right);
    for (std::size_t q = 0; q < right.size(); ++q) e.by_state[q][state] = e.by_state[q][state] + right[q];
  }
  e.states.push_back({element.states, std::move(factors.factors)});
}

/// One element's part of the matrix. rows: over the free directions. Result: whether its part is symmetric.
template <class T>
bool add_element(const std::vector<std::vector<T>>& rows, ElementTangents<T>& element, const T& g,
                 TangentSums<T>& sums) {
  using S = Slope<T>;
  const std::size_t size = rows.size();
  std::vector<std::vector<T>>&stiffness = element.by_position, &damping = element.by_velocity;
  for (std::size_t a = 0; a < size; ++a) {
    for (std::size_t b = 0; b < size; ++b) {
      stiffness[a][b] = S::times(g * g, stiffness[a][b]);
      damping[a][b] = S::times(g, damping[a][b]) + stiffness[a][b];
    }
  }
  add_projected(rows, damping, sums.both);
  add_projected(rows, stiffness, sums.stiffness);
  bool is_symmetric = true;
  for (std::size_t a = 0; a < size; ++a) is_symmetric = is_symmetric && stands_alone(damping, a);
  return is_symmetric;
}

}  // namespace detail

/// The equations at a state. g: the method's factor times the step, s. Cost: as the equations of motion in the matrix
/// form, and a dense elimination of what is not zero.
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
  ReducedSystem<T> reduced =
      reduced_system(system, k, inertias(system, k), projections, std::vector<T>(topology.bodies.size(), T(0.0)));
  const std::size_t n = reduced.mass.size(), states = system.x.size();
  detail::TangentSums<T> sums{detail::zeros<T>(n, n), detail::zeros<T>(n, n)};
  e.by_state = detail::zeros<T>(n, states);
  e.state_by_velocity = e.state_by_position = detail::zeros<T>(states, n);
  watched.state_pivot.assign(system.model.states.size(), T(1.0));
  bool is_symmetric = true;
  for (ElementTangents<T>& element : force_tangents(system, k, v)) {
    std::vector<std::vector<T>> rows;
    for (const LocalCoordinate<T>& coordinate : element.coordinates)
      rows.push_back(detail::projected_row(topology, projections, coordinate.row));
    if (!element.states.empty()) detail::eliminate_states(rows, element, g, first_user_state(system.model), watched);
    is_symmetric = detail::add_element(rows, element, g, sums) && is_symmetric;
  }
  std::vector<std::vector<T>> matrix = detail::zeros<T>(n, n);
  for (std::size_t q = 0; q < n; ++q) {
    e.mass.emplace_back();
    for (std::size_t d = 0; d < n; ++d) {
      const T& mass = d <= q ? reduced.mass[q][d] : reduced.mass[d][q];
      matrix[q][d] = mass - sums.both[q][d];
      if (d <= q) e.mass[q].push_back(Slope<T>::times(g, mass));
    }
  }
  e.stiffness = std::move(sums.stiffness);
  WatchedFactors<T> factors = implicit_factors(std::move(matrix), is_symmetric);
  e.directions = std::move(factors.factors);
  watched.pivot = std::move(factors.pivot);
  for (const GroupProjection<T>& p : projections) e.rz.push_back(p.rz);
  return watched;
}

/// Changes of auxiliary states for given rates, where nothing moves.
template <class T>
std::vector<T> state_changes(const ImplicitEquations<T>& e, const T& g, const std::vector<T>& rates) {
  std::vector<T> changes;
  for (const T& rate : rates) changes.push_back(g * rate);
  for (const StateEquations<T>& block : e.states) {
    std::vector<T> right;
    for (const int state : block.states) right.push_back(rates[state]);
    solve(block.factors, right);
    for (std::size_t s = 0; s < right.size(); ++s) changes[block.states[s]] = right[s];
  }
  return changes;
}

/// Changes of velocities and auxiliary states, in place of given rates: those that solve (1 / g - A) change = rates, A
/// with the tangents alone. rates: of coordinates, velocities and states. free: the coordinate of each free direction,
/// group by group. Result: zdd and xd; no zd, whose change is g times its rate and the change of its velocity.
template <class T>
ImplicitRates<T> implicit_changes(const Topology& topology, const std::vector<int>& free, const ImplicitEquations<T>& e,
                                  const T& g, const ImplicitRates<T>& rates) {
  const std::size_t n = free.size();
  std::vector<T> zd, change;
  for (const int i : free) zd.push_back(rates.zd[i]);
  const std::vector<T> still = state_changes(e, g, rates.xd);
  for (std::size_t q = 0; q < n; ++q) {
    T right = detail::product(e.stiffness[q], zd) + detail::product(e.by_state[q], still);
    for (std::size_t d = 0; d < n; ++d) {
      const T& mass = d <= q ? e.mass[q][d] : e.mass[d][q];
      if (!is_zero(mass)) right = right + mass * rates.zdd[free[d]];
    }
    change.push_back(right);
  }
  solve(e.directions, change);
  std::vector<T> more;  // than an explicit method changes
  for (std::size_t q = 0; q < n; ++q) more.push_back(change[q] - g * rates.zdd[free[q]]);
  ImplicitRates<T> result;
  for (const T& rate : rates.zdd) result.zdd.push_back(g * rate);
  std::size_t first = 0;
  for (std::size_t group = 0; group < topology.groups.size(); ++group) {
    const std::vector<int>& joints = topology.groups[group].joints;
    const std::size_t directions = e.rz[group].empty() ? 0 : e.rz[group][0].size();
    const std::vector<T> own(more.begin() + first, more.begin() + first + directions);
    for (std::size_t c = 0; c < joints.size(); ++c)
      result.zdd[joints[c]] = result.zdd[joints[c]] + detail::product(e.rz[group][c], own);
    first += directions;
  }
  for (std::size_t q = 0; q < n; ++q) result.zdd[free[q]] = change[q];
  for (std::size_t s = 0; s < rates.xd.size(); ++s)
    result.xd.push_back(still[s] + detail::product(e.state_by_velocity[s], change) +
                        detail::product(e.state_by_position[s], zd));
  return result;
}

}  // namespace mbgen
