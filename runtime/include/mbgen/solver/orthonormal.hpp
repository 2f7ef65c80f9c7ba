#pragma once
// Columns of a small dense matrix made orthonormal, for least squares and least norms.

#include <cmath>

#include "mbgen/number.hpp"

namespace mbgen {

namespace solver_detail {

/// Product of two columns of a matrix with `width` numbers in a row.
template <class Real>
Real product_of_columns(int rows, int width, const Real* matrix, int a, int b) noexcept {
  Real product(0);
  for (int i = 0; i < rows; ++i) product += matrix[i * width + a] * matrix[i * width + b];
  return product;
}

/// Takes from column `to` its part along the column `k` of length 1. Result: the part.
template <class Real>
Real take_part(int rows, int width, Real* matrix, int k, int to) noexcept {
  const Real part = product_of_columns(rows, width, matrix, k, to);
  for (int i = 0; i < rows; ++i) matrix[i * width + to] -= part * matrix[i * width + k];
  return part;
}

template <class Real>
void swap_columns(int rows, int width, Real* matrix, int a, int b) noexcept {
  for (int i = 0; i < rows && a != b; ++i) {
    const Real kept = matrix[i * width + a];
    matrix[i * width + a] = matrix[i * width + b];
    matrix[i * width + b] = kept;
  }
}

}  // namespace solver_detail

/// Q R = A P by Gram and Schmidt, longest column first, each taken twice. matrix: rows x count, row by row, A and then
/// Q, whose columns of length 0 stay 0; r: count x count, row by row, upper triangle; order: column of A in place k.
/// Result: the shortest length on the diagonal of R, in its last place. Cost: rows * count^2.
template <class Real>
Real orthonormalise(int rows, int count, Real* matrix, Real* r, int* order) noexcept {
  using namespace solver_detail;
  using std::sqrt;
  for (int k = 0; k < count; ++k) order[k] = k;
  for (int i = 0; i < count * count; ++i) r[i] = Real(0);
  Real shortest(0);
  for (int k = 0; k < count; ++k) {
    int best = k;
    Real largest = product_of_columns(rows, count, matrix, k, k);
    for (int j = k + 1; j < count; ++j) {
      const Real square = product_of_columns(rows, count, matrix, j, j);
      if (square > largest) largest = square, best = j;
    }
    swap_columns(rows, count, matrix, k, best);
    swap_columns(k, count, r, k, best);
    const int kept = order[k];
    order[k] = order[best];
    order[best] = kept;
    for (int j = 0; j < k; ++j) r[j * count + k] += take_part(rows, count, matrix, j, k);
    const Real square = product_of_columns(rows, count, matrix, k, k);
    const Real length = square > Real(0) ? sqrt(square) : Real(0);
    r[k * count + k] = shortest = length;
    if (!(length > Real(0))) continue;
    for (int i = 0; i < rows; ++i) matrix[i * count + k] /= length;
    for (int j = k + 1; j < count; ++j) r[k * count + j] = take_part(rows, count, matrix, k, j);
  }
  return shortest;
}

/// x of the least |A x - b|, by the factors above. b: per row; x: per column of A; work: `count` numbers.
/// Requires: no length of 0.
template <class Real>
void solve_least_squares(int rows, int count, const Real* q, const Real* r, const int* order, const Real* b, Real* x,
                         Real* work) noexcept {
  for (int k = count - 1; k >= 0; --k) {
    Real value(0);
    for (int i = 0; i < rows; ++i) value += q[i * count + k] * b[i];
    for (int j = k + 1; j < count; ++j) value -= r[k * count + j] * work[j];
    work[k] = value / r[k * count + k];
  }
  for (int k = 0; k < count; ++k) x[order[k]] = work[k];
}

/// The shortest y with A' y = c, by the factors above. c: per column of A; y: per row; work: `count` numbers.
/// Requires: no length of 0.
template <class Real>
void solve_least_norm(int rows, int count, const Real* q, const Real* r, const int* order, const Real* c, Real* y,
                      Real* work) noexcept {
  for (int i = 0; i < rows; ++i) y[i] = Real(0);
  for (int k = 0; k < count; ++k) {
    Real value = c[order[k]];
    for (int j = 0; j < k; ++j) value -= r[j * count + k] * work[j];
    work[k] = value / r[k * count + k];
    for (int i = 0; i < rows; ++i) y[i] += q[i * count + k] * work[k];
  }
}

}  // namespace mbgen
