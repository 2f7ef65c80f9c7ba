#include "compiler/algebra/dense.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/QR>
#include <Eigen/SVD>

namespace mbgen {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

Eigen::CompleteOrthogonalDecomposition<MatrixXd> orthogonal_factors(const MatrixXd& a, double threshold) {
  Eigen::CompleteOrthogonalDecomposition<MatrixXd> factors;
  factors.setThreshold(threshold);
  factors.compute(a);
  return factors;
}

}  // namespace

VectorXd least_squares(const MatrixXd& a, const VectorXd& b, double threshold) {
  return orthogonal_factors(a, threshold).solve(b);
}

MatrixXd indifferent_directions(const MatrixXd& a, double threshold) {
  const auto factors = orthogonal_factors(a, threshold);
  const MatrixXd turned = factors.matrixZ().transpose();
  return factors.colsPermutation() * turned.rightCols(a.cols() - factors.rank());
}

MatrixXd kernel(const MatrixXd& a, double threshold) {
  Eigen::FullPivLU<MatrixXd> factors(a);
  factors.setThreshold(threshold);
  if (factors.dimensionOfKernel() == 0) return MatrixXd(a.cols(), 0);
  return factors.kernel();
}

std::vector<int> pivot_places(const MatrixXd& a) {
  const Eigen::FullPivLU<MatrixXd> factors(a);
  const auto& places = factors.permutationP().indices();
  return {places.data(), places.data() + places.size()};
}

std::vector<int> leading_columns(const MatrixXd& a, double threshold) {
  Eigen::ColPivHouseholderQR<MatrixXd> factors;
  factors.setThreshold(threshold);
  factors.compute(a);
  const auto& order = factors.colsPermutation().indices();
  return {order.data(), order.data() + factors.rank()};
}

MatrixXd overdetermined_solution(const MatrixXd& a, const MatrixXd& b) {
  return Eigen::ColPivHouseholderQR<MatrixXd>(a).solve(b);
}

MatrixXd solved(const MatrixXd& a, const MatrixXd& b) { return Eigen::PartialPivLU<MatrixXd>(a).solve(b); }

VectorXd singular_values(const MatrixXd& a) { return Eigen::JacobiSVD<MatrixXd>(a).singularValues(); }

SingularVectors left_singular_vectors(const MatrixXd& a) {
  const Eigen::JacobiSVD<MatrixXd> factors(a, Eigen::ComputeFullU);
  return {factors.singularValues(), factors.matrixU()};
}

SingularVectors right_singular_vectors(const MatrixXd& a) {
  const Eigen::JacobiSVD<MatrixXd> factors(a, Eigen::ComputeFullV);
  return {factors.singularValues(), factors.matrixV()};
}

VectorXd symmetric_eigenvalues(const MatrixXd& a) {
  return Eigen::SelfAdjointEigenSolver<MatrixXd>(a, Eigen::EigenvaluesOnly).eigenvalues();
}

SymmetricEigenVectors symmetric_eigenvectors(const MatrixXd& a) {
  const Eigen::SelfAdjointEigenSolver<MatrixXd> factors(a);
  return {factors.eigenvalues(), factors.eigenvectors()};
}

Hessenberg hessenberg(const MatrixXd& a) {
  if (a.rows() < 2) return {a, MatrixXd::Identity(a.rows(), a.rows())};
  const Eigen::HessenbergDecomposition<MatrixXd> factors(a);
  return {factors.matrixH(), factors.matrixQ()};
}

EigenVectors eigenvectors(const MatrixXd& a) {
  const Eigen::EigenSolver<MatrixXd> factors(a);
  return {factors.eigenvalues(), factors.eigenvectors()};
}

double spectral_radius(const Eigen::MatrixXcd& a) {
  // The real matrix of the same map has these eigenvalues and their conjugates.
  const Eigen::Index n = a.rows();
  MatrixXd real(2 * n, 2 * n);
  real << a.real(), -a.imag(), a.imag(), a.real();
  return Eigen::EigenSolver<MatrixXd>(real, false).eigenvalues().cwiseAbs().maxCoeff();
}

}  // namespace mbgen
