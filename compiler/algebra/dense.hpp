#pragma once
// Factorisations of dense matrices, compiled once: each takes Eigen several seconds in every file that names it.

#include <Eigen/Core>
#include <complex>
#include <vector>

namespace mbgen {

/// The x nearest to zero of all x with the least |a x - b|. Pivots below `threshold` times the largest count as zero.
Eigen::VectorXd least_squares(const Eigen::MatrixXd& a, const Eigen::VectorXd& b, double threshold);

/// Orthonormal directions, as columns, in which a x does not change; threshold as in least_squares.
Eigen::MatrixXd indifferent_directions(const Eigen::MatrixXd& a, double threshold);

/// A basis, as columns, of the null space of `a`, by Gauss elimination with full pivoting; threshold as in
/// least_squares. No columns when there is nothing but zero.
Eigen::MatrixXd kernel(const Eigen::MatrixXd& a, double threshold);

/// Place of every row in the order in which full pivoting takes them.
std::vector<int> pivot_places(const Eigen::MatrixXd& a);

/// The columns that a QR factorisation with column pivoting takes, in its order, up to the rank; threshold as in
/// least_squares.
std::vector<int> leading_columns(const Eigen::MatrixXd& a, double threshold);

/// The X with the least |a X - b|, column by column. Requires: a of full column rank.
Eigen::MatrixXd overdetermined_solution(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);

/// a^-1 b by Gauss elimination with row pivoting. Requires: a square and regular.
Eigen::MatrixXd solved(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);

/// Largest first.
Eigen::VectorXd singular_values(const Eigen::MatrixXd& a);

/// Singular values, largest first, and all vectors of one side as columns in their order.
struct SingularVectors {
  Eigen::VectorXd values;
  Eigen::MatrixXd vectors;
};
SingularVectors left_singular_vectors(const Eigen::MatrixXd& a);
SingularVectors right_singular_vectors(const Eigen::MatrixXd& a);

/// Smallest first. Requires: a symmetric; its lower half is read.
Eigen::VectorXd symmetric_eigenvalues(const Eigen::MatrixXd& a);

/// Eigenvalues, smallest first, and orthonormal vectors as columns in their order. Requires: as symmetric_eigenvalues.
struct SymmetricEigenVectors {
  Eigen::VectorXd values;
  Eigen::MatrixXd vectors;
};
SymmetricEigenVectors symmetric_eigenvectors(const Eigen::MatrixXd& a);

/// a v = value v; vectors are columns, normalised.
struct EigenVectors {
  Eigen::VectorXcd values;
  Eigen::MatrixXcd vectors;
};
EigenVectors eigenvectors(const Eigen::MatrixXd& a);

/// a = vectors h vectors', h zero below its first subdiagonal, vectors orthonormal.
struct Hessenberg {
  Eigen::MatrixXd h, vectors;
};
Hessenberg hessenberg(const Eigen::MatrixXd& a);

/// The largest absolute value of an eigenvalue of a complex matrix.
double spectral_radius(const Eigen::MatrixXcd& a);

}  // namespace mbgen
