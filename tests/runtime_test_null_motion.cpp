// The coordinate that a status no_inertia names: independent of the basis, and of the order of the directions.

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <random>

#include "mbgen/null_motion.hpp"

namespace mbgen {
namespace {

using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

int named(const Matrix& mass, Matrix directions) {
  const int n = static_cast<int>(directions.rows()), free = static_cast<int>(directions.cols());
  Matrix work(free, free);
  Eigen::VectorXd zd(n);
  const auto energy = [&](const double* v) {
    const Eigen::Map<const Eigen::VectorXd> velocity(v, n);
    return velocity.dot(mass * velocity);
  };
  return coordinate_without_inertia(energy, n, free, directions.data(), work.data(), zd.data());
}

Matrix random_matrix(std::mt19937& generator, int rows, int columns) {
  std::uniform_real_distribution<double> entry(-1, 1);
  return Matrix::NullaryExpr(rows, columns, [&] { return entry(generator); });
}

TEST(NullMotion, IsTheLargestEntryOfTheOnlyOne) {
  // Three coordinates, z1 = 2 z0 and z2 free; only z2 has mass: the null motion is (1, 2, 0).
  Matrix mass = Matrix::Zero(3, 3), directions(3, 2);
  mass(2, 2) = 5;
  directions << 1, 0.3, 2, 0.6, 0, 1;
  EXPECT_EQ(named(mass, directions), 1);
}

TEST(NullMotion, FirstOfEqualsIsNamed) {
  Matrix mass = Matrix::Zero(3, 3), directions(3, 1);
  directions << 0.1, -1, 1 + 1e-9;
  EXPECT_EQ(named(mass, directions), 1);
}

TEST(NullMotion, DoesNotDependOnTheBasisNorOnTheScaleOfTheMasses) {
  std::mt19937 generator(7);
  for (int trial = 0; trial < 100; ++trial) {
    const int n = 4 + trial % 6, free = 2 + trial % 3, null = 1 + trial % 2;
    const Matrix directions = random_matrix(generator, n, free);
    // Masses that see all combinations of the directions but some; Eigen says which.
    const Matrix orthonormal = directions.householderQr().householderQ() * Matrix::Identity(n, free);
    const Matrix seen = orthonormal.rightCols(free - null) * random_matrix(generator, free - null, 3);
    const Matrix mass = std::pow(10.0, trial % 9 - 4) * seen * seen.transpose();
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> judge(orthonormal.transpose() * mass * orthonormal);
    Eigen::VectorXd share = Eigen::VectorXd::Zero(n);
    for (int p = 0; p < free; ++p) {
      if (judge.eigenvalues()[p] > 1e-9 * judge.eigenvalues()[free - 1]) continue;
      share += (orthonormal * judge.eigenvectors().col(p)).cwiseAbs2();
    }
    Eigen::Index expected = 0;
    share.maxCoeff(&expected);
    EXPECT_EQ(named(mass, directions), expected) << trial;
    EXPECT_EQ(named(mass, directions * random_matrix(generator, free, free)), expected) << trial;
  }
}

}  // namespace
}  // namespace mbgen
