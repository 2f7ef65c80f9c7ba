#pragma once
// Force elements in the equations of an implicit step: rows over the tree's coordinates, and forces along them by the
// changes of a step, auxiliary states eliminated. Source: docs/method/implicit.md.

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

#include "compiler/formulation/closure.hpp"
#include "compiler/formulation/implicit/implicit_factors.hpp"
#include "compiler/formulation/implicit/tangents.hpp"

namespace mbgen {

/// One element in the equations. Matrices are [row][column], entries of rows and columns local coordinates a, b and
/// states s.
template <class T>
struct ImplicitElement {
  std::vector<SparseRow<T>> rows;               ///< per local coordinate, over the tree's coordinates
  std::vector<std::vector<T>> both, stiffness;  ///< [a][b]: g D + g^2 K, and g^2 K alone
  bool is_symmetric = true;                     ///< both is, to the letter
  std::vector<int> states;                      ///< auxiliary ones, eliminated
  ImplicitFactors<T> factors;                   ///< of 1 / g less the derivatives of their rates
  std::vector<std::vector<T>> by_state;         ///< [a][s]: forces by the changes of states, times g
  /// [s][b]: changes of states by those of velocities and by the rates of positions
  std::vector<std::vector<T>> state_by_velocity, state_by_position;
};

namespace detail {

template <class T>
SparseRow<T> without_zeros(const std::vector<T>& row) {
  SparseRow<T> result;
  for (std::size_t i = 0; i < row.size(); ++i)
    if (!is_zero(row[i])) result.push_back(static_cast<int>(i), row[i]);
  return result;
}

/// row . values
template <class T>
T product(const SparseRow<T>& row, const std::vector<T>& values) {
  T sum(0.0);
  for (std::size_t i = 0; i < row.columns.size(); ++i)
    sum = sum + Slope<T>::times(row.values[i], values[row.columns[i]]);
  return sum;
}

/// sum of a_i b_i, without the products that are zero.
template <class T>
T product(const std::vector<T>& a, const std::vector<T>& b) {
  T sum(0.0);
  for (std::size_t i = 0; i < a.size(); ++i) sum = sum + Slope<T>::times(a[i], b[i]);
  return sum;
}

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

/// Eliminates the auxiliary states of an element into its tangents: their changes solve (1 / g - F) change = rates + P
/// (change of positions) + Q (change of velocities). state_pivot: per user-defined state, the first of them
/// `first_user`.
template <class T>
void eliminate_states(ElementTangents<T>& tangents, const T& g, int first_user, ImplicitElement<T>& element,
                      std::vector<T>& state_pivot) {
  using S = Slope<T>;
  const std::size_t states = tangents.states.size(), size = tangents.coordinates.size();
  const T reciprocal = T(1.0) / g;
  MirroredMatrix<T> matrix(states);
  for (std::size_t s = 0; s < states; ++s)
    for (std::size_t t = 0; t < states; ++t)
      matrix.entry[s][t] = (s == t ? reciprocal : T(0.0)) - tangents.rate_by_state[s][t];
  WatchedFactors<T> factors = implicit_factors(std::move(matrix));
  element.states = tangents.states;
  element.factors = std::move(factors.factors);
  element.state_by_position = solved_columns(element.factors, tangents.rate_by_position);
  element.state_by_velocity = solved_columns(element.factors, tangents.rate_by_velocity);
  element.by_state = tangents.by_state;
  for (std::size_t s = 0; s < states; ++s) {
    if (const int own = element.states[s] - first_user; own >= 0) state_pivot[own] = factors.pivot[s];
    for (std::size_t b = 0; b < size; ++b) {
      T &position = element.state_by_position[s][b], &velocity = element.state_by_velocity[s][b];
      for (std::size_t a = 0; a < size; ++a) {
        const T& force = tangents.by_state[a][s];
        tangents.by_velocity[a][b] = tangents.by_velocity[a][b] + S::times(force, velocity);
        tangents.by_position[a][b] = tangents.by_position[a][b] + S::times(force, position);
      }
      position = S::times(g, position);
      velocity = velocity + position;
    }
    for (std::size_t a = 0; a < size; ++a) element.by_state[a][s] = S::times(g, element.by_state[a][s]);
  }
}

/// Whether a square matrix has no entry off its diagonal.
template <class T>
bool is_diagonal(const std::vector<std::vector<T>>& matrix) {
  for (std::size_t a = 0; a < matrix.size(); ++a)
    for (std::size_t b = 0; b < matrix.size(); ++b)
      if (a != b && !is_zero(matrix[a][b])) return false;
  return true;
}

/// Takes the mean of both entries of each pair.
template <class T>
void make_symmetric(std::vector<std::vector<T>>& matrix) {
  for (std::size_t a = 0; a < matrix.size(); ++a)
    for (std::size_t b = 0; b < a; ++b)
      matrix[a][b] = matrix[b][a] = Slope<T>::times(T(0.5), matrix[a][b] + matrix[b][a]);
}

/// An element with its states eliminated. g, first_user, state_pivot: as in eliminate_states.
template <class T>
ImplicitElement<T> implicit_element(ElementTangents<T> tangents, const T& g, int first_user,
                                    std::vector<T>& state_pivot) {
  using S = Slope<T>;
  ImplicitElement<T> element;
  for (const LocalCoordinate<T>& coordinate : tangents.coordinates)
    element.rows.push_back(without_zeros(coordinate.row));
  if (!tangents.states.empty()) eliminate_states(tangents, g, first_user, element, state_pivot);
  element.both = std::move(tangents.by_velocity);
  element.stiffness = std::move(tangents.by_position);
  for (std::size_t a = 0; a < element.rows.size(); ++a) {
    for (std::size_t b = 0; b < element.rows.size(); ++b) {
      T &both = element.both[a][b], &stiffness = element.stiffness[a][b];
      stiffness = S::times(g * g, stiffness);
      both = S::times(g, both) + stiffness;
    }
  }
  if (tangents.counts_as_symmetric) make_symmetric(element.both);
  element.is_symmetric = tangents.counts_as_symmetric || is_diagonal(element.both);
  return element;
}

/// to += rows' matrix rows, of a symmetric one the lower triangle alone.
template <class T>
void add_projected(const std::vector<SparseRow<T>>& rows, const std::vector<std::vector<T>>& matrix, bool is_symmetric,
                   std::vector<std::vector<T>>& to) {
  const std::size_t n = to.size();
  for (std::size_t a = 0; a < rows.size(); ++a) {
    std::vector<T> moved(n, T(0.0));
    for (std::size_t b = 0; b < rows.size(); ++b)
      for (std::size_t i = 0; i < (is_zero(matrix[a][b]) ? 0 : rows[b].columns.size()); ++i) {
        T& sum = moved[rows[b].columns[i]];
        sum = sum + matrix[a][b] * rows[b].values[i];
      }
    for (std::size_t i = 0; i < rows[a].columns.size(); ++i) {
      const std::size_t q = rows[a].columns[i];
      for (std::size_t d = 0; d < (is_symmetric ? q + 1 : n); ++d)
        if (!is_zero(moved[d])) to[q][d] = to[q][d] + rows[a].values[i] * moved[d];
    }
  }
}

/// Number of entries that are not zero.
template <class T>
std::size_t entries(const std::vector<std::vector<T>>& matrix) {
  std::size_t count = 0;
  for (const std::vector<T>& row : matrix)
    for (const T& entry : row) count += is_zero(entry) ? 0 : 1;
  return count;
}

/// Products that an element costs in each stage of a step.
template <class T>
std::size_t stage_products(const ImplicitElement<T>& element) {
  std::size_t count = entries(element.both) + entries(element.stiffness);
  for (const SparseRow<T>& row : element.rows) count += 3 * row.columns.size();
  return count;
}

/// Columns in which rows have entries, ascending.
template <class T>
std::vector<int> columns_of(const std::vector<SparseRow<T>>& rows) {
  std::vector<int> columns;
  for (const SparseRow<T>& row : rows) columns.insert(columns.end(), row.columns.begin(), row.columns.end());
  std::ranges::sort(columns);
  columns.erase(std::unique(columns.begin(), columns.end()), columns.end());
  return columns;
}

/// Elements without states on the same coordinates of the tree as one, whose local coordinates these are.
template <class T>
ImplicitElement<T> united(const std::vector<int>& coordinates, const std::vector<ImplicitElement<T>>& elements) {
  const std::size_t size = coordinates.size();
  ImplicitElement<T> result;
  for (const int coordinate : coordinates) {
    result.rows.emplace_back();
    result.rows.back().push_back(coordinate, T(1.0));
  }
  result.both = result.stiffness = zeros<T>(size, size);
  for (ImplicitElement<T> element : elements) {
    for (SparseRow<T>& row : element.rows)
      for (int& column : row.columns)
        column = static_cast<int>(std::ranges::lower_bound(coordinates, column) - coordinates.begin());
    add_projected(element.rows, element.both, true, result.both);
    add_projected(element.rows, element.stiffness, true, result.stiffness);
  }
  for (std::vector<std::vector<T>>* matrix : {&result.both, &result.stiffness})
    for (std::size_t a = 0; a < size; ++a)
      for (std::size_t b = 0; b < a; ++b) (*matrix)[b][a] = (*matrix)[a][b];
  return result;
}

/// Whether an element is a symmetric matrix over its rows and no more.
template <class T>
bool is_symmetric_alone(const ImplicitElement<T>& element) {
  return element.states.empty() && element.is_symmetric && is_diagonal(element.stiffness);
}

/// Unites elements on the same coordinates of the tree, as compliances of one arm, where that costs less in a stage.
template <class T>
std::vector<ImplicitElement<T>> united_where_less(std::vector<ImplicitElement<T>> elements) {
  std::vector<ImplicitElement<T>> result;
  while (!elements.empty()) {
    const std::vector<int> coordinates = columns_of(elements.front().rows);
    std::vector<ImplicitElement<T>> here, others;
    std::size_t products = 0;
    for (ImplicitElement<T>& element : elements) {
      const bool joins = !here.empty() && is_symmetric_alone(here[0]) && is_symmetric_alone(element) &&
                         columns_of(element.rows) == coordinates;
      if (here.empty() || joins) {
        products += stage_products(element);
        here.push_back(std::move(element));
      } else {
        others.push_back(std::move(element));
      }
    }
    if (here.size() > 1 && products > 2 * coordinates.size() * coordinates.size())
      result.push_back(united(coordinates, here));
    else
      std::ranges::move(here, std::back_inserter(result));
    elements = std::move(others);
  }
  return result;
}

}  // namespace detail
}  // namespace mbgen
