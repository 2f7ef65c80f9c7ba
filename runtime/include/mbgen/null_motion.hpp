#pragma once
// Which coordinate a status no_inertia names. Existence (9): accelerations are unique exactly when rank [M; Phi_z] = n;
// otherwise there are motions that violate no closure and move no mass.

#include <cmath>

namespace mbgen {

/// Motions count as without inertia when their kinetic energy is below this part of the largest one, at equal length.
constexpr double kNullEnergy = 1e-12;
/// Coordinates whose shares in these motions differ by less than this part are equal, and the first is named.
constexpr double kEqualShare = 1e-6;

namespace null_detail {

/// Makes the columns of a matrix (rows x columns, row by row) orthonormal, by Gram and Schmidt twice over.
inline void orthonormalise(int rows, int columns, double* matrix) noexcept {
  for (int p = 0; p < columns; ++p) {
    for (int round = 0; round < 2; ++round) {
      for (int q = 0; q < p; ++q) {
        double product = 0;
        for (int i = 0; i < rows; ++i) product += matrix[i * columns + p] * matrix[i * columns + q];
        for (int i = 0; i < rows; ++i) matrix[i * columns + p] -= product * matrix[i * columns + q];
      }
      double square = 0;
      for (int i = 0; i < rows; ++i) square += matrix[i * columns + p] * matrix[i * columns + p];
      for (int i = 0; i < rows; ++i) matrix[i * columns + p] /= std::sqrt(square);
    }
  }
}

/// One rotation of Jacobi's method that makes entry (p, q) of a symmetric matrix zero; the columns of `basis` go along.
inline void rotate(int size, double* matrix, int p, int q, int rows, double* basis) noexcept {
  const double entry = matrix[p * size + q];
  if (entry == 0) return;
  const double theta = (matrix[q * size + q] - matrix[p * size + p]) / (2 * entry);
  const double tangent = (theta < 0 ? -1 : 1) / (std::abs(theta) + std::sqrt(theta * theta + 1));
  const double cosine = 1 / std::sqrt(tangent * tangent + 1), sine = tangent * cosine;
  const auto turn = [&](double& a, double& b) {
    const double kept = a;
    a = cosine * kept - sine * b;
    b = sine * kept + cosine * b;
  };
  for (int i = 0; i < size; ++i) turn(matrix[i * size + p], matrix[i * size + q]);
  for (int i = 0; i < size; ++i) turn(matrix[p * size + i], matrix[q * size + i]);
  for (int i = 0; i < rows; ++i) turn(basis[i * size + p], basis[i * size + q]);
}

/// Jacobi sweeps; ten are plenty.
inline void diagonalise(int size, double* matrix, int rows, double* basis) noexcept {
  for (int sweep = 0; sweep < 10; ++sweep) {
    for (int p = 0; p < size; ++p) {
      for (int q = p + 1; q < size; ++q) rotate(size, matrix, p, q, rows, basis);
    }
  }
}

}  // namespace null_detail

/// The coordinate with the largest share in the motions without inertia, the first of equals. Does not depend on the
/// partition that the directions come from.
/// energy(zd): any multiple of the kinetic energy at velocities zd, per coordinate; directions: coordinates x free, row
/// by row, a basis of the motions that the closures allow, changed; mass: free * free doubles; zd: per coordinate.
/// Requires: free > 0.
template <class Energy>
int coordinate_without_inertia(const Energy& energy, int coordinates, int free, double* directions, double* mass,
                               double* zd) noexcept {
  null_detail::orthonormalise(coordinates, free, directions);
  for (int p = 0; p < free; ++p) {
    for (int q = 0; q <= p; ++q) {
      double sum = 0;
      for (int sign = 1; sign >= -1; sign -= 2) {
        for (int i = 0; i < coordinates; ++i) zd[i] = directions[i * free + p] + sign * directions[i * free + q];
        sum += sign * energy(zd);
      }
      mass[p * free + q] = mass[q * free + p] = sum;
    }
  }
  null_detail::diagonalise(free, mass, coordinates, directions);
  double smallest = mass[0], largest = mass[0];
  for (int p = 0; p < free; ++p) {
    smallest = mass[p * free + p] < smallest ? mass[p * free + p] : smallest;
    largest = mass[p * free + p] > largest ? mass[p * free + p] : largest;
  }
  const double bound = smallest > kNullEnergy * largest ? smallest : kNullEnergy * largest;
  int named = 0;
  double most = -1;
  for (int i = 0; i < coordinates; ++i) {
    double share = 0;
    for (int p = 0; p < free; ++p) {
      if (mass[p * free + p] <= bound) share += directions[i * free + p] * directions[i * free + p];
    }
    if (share > most * (1 + kEqualShare)) {
      named = i;
      most = share;
    }
  }
  return named;
}

}  // namespace mbgen
