// The pivoting LU of loop blocks, against Eigen's FullPivLU and against the equations themselves.

#include "mbgen/solver/loop.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace mbgen {
namespace {

using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

// Rounding of the LU of well-conditioned matrices of up to 20 rows, with entries of the order of 1.
constexpr double kLoopRounding = 1e-10;
constexpr double kRankTolerance = 1e-9;

struct Factorised {
  Matrix matrix;
  std::vector<int> rows, columns;
  LoopFactors loop;

  Factorised(const Matrix& jacobian, int rank_limit, const unsigned char* driven) : matrix(jacobian) {
    rows.resize(static_cast<std::size_t>(jacobian.rows()));
    columns.resize(static_cast<std::size_t>(jacobian.cols()));
    loop.equations = static_cast<int>(jacobian.rows());
    loop.coordinates = static_cast<int>(jacobian.cols());
    loop.matrix = matrix.data();
    loop.rows = rows.data();
    loop.columns = columns.data();
    factorise(loop, rank_limit, driven, kRankTolerance);
  }
  Factorised(const Factorised&) = delete;
};

Matrix random_matrix(std::mt19937& generator, int rows, int columns) {
  std::uniform_real_distribution<double> entry(-1, 1);
  return Matrix::NullaryExpr(rows, columns, [&] { return entry(generator); });
}

/// Of the given rank: a product of two random factors.
Matrix random_of_rank(std::mt19937& generator, int rows, int columns, int rank) {
  return random_matrix(generator, rows, rank) * random_matrix(generator, rank, columns);
}

Matrix permuted_product(const Factorised& f) {
  const int rank = f.loop.rank;
  Matrix lower = Matrix::Zero(f.loop.equations, rank), upper = Matrix::Zero(rank, f.loop.coordinates);
  for (int i = 0; i < f.loop.equations; ++i) {
    for (int j = 0; j < f.loop.coordinates; ++j) {
      if (j < rank && j < i) lower(i, j) = f.matrix(i, j);
      if (i < rank && j >= i) upper(i, j) = f.matrix(i, j);
    }
    if (i < rank) lower(i, i) = 1;
  }
  return lower * upper;
}

TEST(LoopFactorise, RankAndProductAgreeWithEigenOnRandomMatrices) {
  std::mt19937 generator(1);
  for (int trial = 0; trial < 300; ++trial) {
    const int rows = 1 + trial % 11, columns = 1 + (trial / 3) % 14;
    const int rank = 1 + trial % std::min(rows, columns);
    const Matrix jacobian = random_of_rank(generator, rows, columns, rank);
    Eigen::FullPivLU<Matrix> judge(jacobian);
    judge.setThreshold(kRankTolerance);
    const Factorised f(jacobian, std::min(rows, columns), nullptr);
    ASSERT_EQ(f.loop.rank, static_cast<int>(judge.rank())) << rows << "x" << columns;
    const Matrix product = permuted_product(f);
    for (int i = 0; i < rows; ++i) {
      const int row = f.rows[static_cast<std::size_t>(i)];
      for (int j = 0; j < columns; ++j) {
        EXPECT_NEAR(product(i, j), jacobian(row, f.columns[static_cast<std::size_t>(j)]), kLoopRounding);
      }
    }
    const double largest = std::abs(judge.matrixLU()(0, 0));
    EXPECT_DOUBLE_EQ(std::abs(f.matrix(0, 0)), largest) << "the first pivot is the largest entry";
  }
}

TEST(LoopFactorise, PivotRatioIsSmallestOverLargest) {
  Matrix diagonal = Matrix::Zero(3, 3);
  diagonal.diagonal() << 0.5, -4, 2;
  const Factorised f(diagonal, 3, nullptr);
  EXPECT_EQ(f.loop.rank, 3);
  EXPECT_DOUBLE_EQ(f.loop.smallest_ratio, 0.125);
  EXPECT_EQ(f.columns, (std::vector<int>{1, 2, 0}));
}

TEST(LoopFactorise, RankLimitStopsEarlyAndNothingIsTakenFromAZeroMatrix) {
  std::mt19937 generator(2);
  const Factorised limited(random_matrix(generator, 6, 8), 4, nullptr);
  EXPECT_EQ(limited.loop.rank, 4);
  const Factorised none(Matrix::Zero(3, 4), 3, nullptr);
  EXPECT_EQ(none.loop.rank, 0);
  EXPECT_EQ(none.loop.smallest_ratio, 0);
}

TEST(LoopFactorise, AMatrixWithAnEntryThatIsNotFiniteHasNoRank) {
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    std::mt19937 generator(3);
    Matrix jacobian = random_matrix(generator, 4, 6);
    jacobian(2, 1) = bad;
    const Factorised f(jacobian, 4, nullptr);
    EXPECT_EQ(f.loop.rank, 0);
  }
}

TEST(LoopFactorise, DrivenColumnsAreNeverDependent) {
  std::mt19937 generator(4);
  for (int trial = 0; trial < 100; ++trial) {
    const int rows = 2 + trial % 5, columns = rows + 4;
    Matrix jacobian = random_matrix(generator, rows, columns);
    std::vector<unsigned char> driven(static_cast<std::size_t>(columns), 0);
    for (const int c : {trial % columns, (3 * trial + 1) % columns}) {
      driven[static_cast<std::size_t>(c)] = 1;
      jacobian.col(c) *= 1000;  // the most tempting pivots
    }
    const Factorised f(jacobian, rows, driven.data());
    ASSERT_EQ(f.loop.rank, rows);
    for (int k = 0; k < f.loop.rank; ++k) {
      EXPECT_EQ(driven[static_cast<std::size_t>(f.columns[static_cast<std::size_t>(k)])], 0);
    }
  }
}

TEST(LoopSolve, DependentCoordinatesSatisfyEveryEquationOfACompatibleRedundantSet) {
  std::mt19937 generator(5);
  for (int trial = 0; trial < 200; ++trial) {
    const int columns = 5 + trial % 9, rank = 2 + trial % 4, rows = rank + trial % 4;
    const Matrix jacobian = random_of_rank(generator, rows, columns, rank);
    const Eigen::VectorXd right = jacobian * random_matrix(generator, columns, 1);
    const Factorised f(jacobian, rank, nullptr);
    ASSERT_EQ(f.loop.rank, rank);
    Eigen::VectorXd x = random_matrix(generator, columns, 1), given = x, work(rows);
    const double residual = solve_dependent(f.loop, right.data(), x.data(), work.data());
    const double scale = x.cwiseAbs().maxCoeff() + 1;
    EXPECT_LT((jacobian * x - right).cwiseAbs().maxCoeff(), kLoopRounding * scale);
    EXPECT_LT(residual, kLoopRounding * scale);
    for (int place = rank; place < columns; ++place) {
      const int c = f.columns[static_cast<std::size_t>(place)];
      EXPECT_EQ(x[c], given[c]) << "independent entries stay";
    }
  }
}

TEST(LoopSolve, ResidualIsThatOfTheRedundantEquation) {
  Matrix jacobian(3, 3);
  jacobian << 2, 1, 0, 0, 1, 3, 2, 2, 3;  // the third is the sum of the others
  Eigen::Vector3d right(1, 2, 3.25), x(0.3, 0.4, 0.5), work;
  const Factorised f(jacobian, 3, nullptr);
  ASSERT_EQ(f.loop.rank, 2);
  EXPECT_NEAR(solve_dependent(f.loop, right.data(), x.data(), work.data()), 0.25, 1e-14);
  const int dropped = f.rows[2];
  EXPECT_NEAR(std::abs((jacobian * x - right)[dropped]), 0.25, 1e-14);
}

TEST(LoopSolve, ResidualThatIsNotANumberIsReported) {
  Matrix jacobian(2, 2);
  jacobian << 1, 2, 1, 2;
  Eigen::Vector2d right(1, std::numeric_limits<double>::quiet_NaN()), x(0, 0), work;
  const Factorised f(jacobian, 2, nullptr);
  ASSERT_EQ(f.loop.rank, 1);
  const double residual = solve_dependent(f.loop, right.data(), x.data(), work.data());
  EXPECT_TRUE(std::isnan(residual) || std::isnan(x[f.columns[0]]));
}

TEST(LoopFreeDirections, SpanTheNullSpaceWithUnitFreeEntriesInAscendingOrder) {
  std::mt19937 generator(6);
  for (int trial = 0; trial < 200; ++trial) {
    const int rank = 1 + trial % 5, columns = rank + 3 + trial % 4, rows = rank + trial % 3;
    const Matrix jacobian = random_of_rank(generator, rows, columns, rank);
    std::vector<unsigned char> driven(static_cast<std::size_t>(columns), 0);
    driven[static_cast<std::size_t>(trial % columns)] = 1;
    const Factorised f(jacobian, rank, driven.data());
    ASSERT_EQ(f.loop.rank, rank);
    const int free = columns - rank - 1;
    Matrix rz = Matrix::Constant(columns, free, 99.0);
    Eigen::VectorXd work(rows);
    free_directions(f.loop, driven.data(), rz.data(), work.data());
    EXPECT_LT((jacobian * rz).cwiseAbs().maxCoeff(), kLoopRounding * (1 + rz.cwiseAbs().maxCoeff()));
    int q = 0;
    for (int c = 0; c < columns; ++c) {
      const bool dependent = std::find(f.columns.begin(), f.columns.begin() + rank, c) != f.columns.begin() + rank;
      if (dependent) continue;
      const bool is_driven = driven[static_cast<std::size_t>(c)] != 0;
      for (int k = 0; k < free; ++k) EXPECT_EQ(rz(c, k), !is_driven && k == q ? 1.0 : 0.0);
      q += is_driven ? 0 : 1;
    }
    EXPECT_EQ(q, free);
  }
}

TEST(LoopMultipliers, TakeTheForcesOfTheDependentCoordinates) {
  std::mt19937 generator(5);
  for (int trial = 0; trial < 100; ++trial) {
    const int rows = 1 + trial % 7, columns = 2 + trial % 9, rank = 1 + trial % std::min(rows, columns - 1);
    const Matrix jacobian = random_of_rank(generator, rows, columns, rank);
    std::vector<unsigned char> driven(static_cast<std::size_t>(columns), 0);
    if (trial % 3 == 0) driven[static_cast<std::size_t>(trial % columns)] = 1;
    const Factorised f(jacobian, rank, driven.data());
    const Eigen::VectorXd force = random_matrix(generator, columns, 1);
    Eigen::VectorXd left = force, lambda(rows), work(rows);
    solve_transposed(f.loop, left.data(), lambda.data(), work.data());
    EXPECT_LT((force - jacobian.transpose() * lambda - left).cwiseAbs().maxCoeff(), kLoopRounding);
    for (int k = 0; k < f.loop.rank; ++k) EXPECT_EQ(left[f.columns[static_cast<std::size_t>(k)]], 0);
    for (int i = f.loop.rank; i < rows; ++i) EXPECT_EQ(lambda[f.rows[static_cast<std::size_t>(i)]], 0);
  }
}

/// The same factors when the largest entry of each row is kept, and when elimination touches few entries alone, to the
/// last bit: sparse rows, ties, driven and late ones.
TEST(LoopFactors, KeptMaximaAndPlacesChangeNothing) {
  std::mt19937 generator(7);
  std::uniform_int_distribution<int> size(2, 14), digit(-2, 2), coin(0, 3);
  for (int trial = 0; trial < 400; ++trial) {
    const int scale = trial % 4 == 0 ? 3 : 1;
    const int rows = scale * size(generator), columns = scale * size(generator);
    const Matrix jacobian = Matrix::NullaryExpr(
        rows, columns, [&] { return coin(generator) == 0 && coin(generator) < 5 - scale ? digit(generator) : 0; });
    std::vector<unsigned char> driven(columns), late(rows);
    for (auto& d : driven) d = coin(generator) == 0 ? 1 : 0;
    for (auto& l : late) l = coin(generator) == 0 ? 1 : 0;
    const LatePivots order = {trial % 2 == 0 ? nullptr : late.data(), rows / 2};
    Matrix plain = jacobian;
    std::vector<int> plain_rows(rows), plain_columns(columns);
    LoopFactors loop{rows, columns};
    loop.matrix = plain.data();
    loop.rows = plain_rows.data();
    loop.columns = plain_columns.data();
    factorise(loop, rows, driven.data(), kRankTolerance, order);
    for (const bool with_places : {false, true}) {
      Matrix kept = jacobian;
      std::vector<int> kept_rows(rows), kept_columns(columns), largest_at(rows), places(columns);
      std::vector<double> largest(rows);
      LoopFactors other{rows, columns};
      other.matrix = kept.data();
      other.rows = kept_rows.data();
      other.columns = kept_columns.data();
      other.largest = largest.data();
      other.largest_at = largest_at.data();
      other.places = with_places ? places.data() : nullptr;
      factorise(other, rows, driven.data(), kRankTolerance, order);
      ASSERT_EQ(loop.rank, other.rank);
      ASSERT_EQ(plain_rows, kept_rows);
      ASSERT_EQ(plain_columns, kept_columns);
      ASSERT_TRUE(plain == kept);
    }
  }
}

}  // namespace
}  // namespace mbgen
