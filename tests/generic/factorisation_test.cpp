// The factorisations of the generic runtime against matrices that can be checked by hand, and against their own
// definition on random matrices without full rank.

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <random>

#include "runtime/generic/block_factors.hpp"
#include "runtime/generic/klu_factors.hpp"
#include "runtime/generic/paper_lu.hpp"

namespace mbgen {
namespace {

/// rows x columns of a given rank, entries of the order of one.
Eigen::MatrixXd random_matrix(std::mt19937_64& random, int rows, int columns, int rank) {
  std::uniform_real_distribution<double> unit(-1, 1);
  const auto full = [&](int r, int c) { return Eigen::MatrixXd::NullaryExpr(r, c, [&] { return unit(random); }); };
  const Eigen::MatrixXd left = full(rows, rank), right = full(rank, columns);
  return left * right;
}

void fill(PaperLu& lu, const Eigen::MatrixXd& a) { std::copy_n(a.data(), a.size(), lu.matrix().begin()); }

// Rows 1 + 2 = 3; the fourth column is driven.
const Eigen::MatrixXd kRedundant{{0, 2, 1, 3}, {1, 1, 0, 1}, {1, 3, 1, 4}};

TEST(PaperLu, LeavesRedundantRowsAndDrivenColumnsAside) {
  PaperLu lu(3, 4, {0, 0, 0}, {3});
  fill(lu, kRedundant);
  ASSERT_EQ(lu.factorise(), 2);
  EXPECT_EQ(lu.column(0), 0);
  EXPECT_EQ(lu.column(1), 1);
  EXPECT_EQ(lu.column(2), 2);
  EXPECT_EQ(lu.column(3), 3);
  std::vector<double> x;
  lu.dependence(2, 1, x);  // third = -first/2 + second/2
  EXPECT_NEAR(x[0], -0.5, 1e-15);
  EXPECT_NEAR(x[1], 0.5, 1e-15);
  lu.solve({2, 2, 4}, {0, 1}, x);
  EXPECT_NEAR(x[0], 1.5, 1e-15);
  EXPECT_NEAR(x[1], -0.5, 1e-15);
}

TEST(PaperLu, AColumnWithoutAPivotBecomesIndependent) {
  PaperLu lu(2, 3, {0, 0, 0}, {2});
  fill(lu, Eigen::MatrixXd{{0, 2, 1}, {0, 4, 1}});
  ASSERT_EQ(lu.factorise(), 2);
  EXPECT_EQ(lu.column(0), 1);
  EXPECT_EQ(lu.column(1), 2);
  EXPECT_EQ(lu.column(2), 0);
}

TEST(PaperLu, AColumnWithAPoorPivotWaitsForABetterOne) {
  const Eigen::MatrixXd a{{1, 1, 0}, {1, 1 + 1e-7, 1}};
  PaperLu lu(2, 3, {0, 0, 0}, {2});
  fill(lu, a);
  ASSERT_EQ(lu.factorise(), 2);
  EXPECT_EQ(lu.column(1), 2);
  PaperLu without_choice(2, 2, {0, 0}, {2});
  fill(without_choice, a.leftCols(2));
  EXPECT_EQ(without_choice.factorise(), 2);
  PaperLu rounding(2, 2, {0, 0}, {2});
  fill(rounding, Eigen::MatrixXd{{1, 1}, {1, 1 + 1e-12}});
  EXPECT_EQ(rounding.factorise(), 1);
}

TEST(PaperLu, GroupsKeepTheirLimits) {
  Eigen::MatrixXd a = Eigen::MatrixXd::Zero(4, 4);
  a.topLeftCorner(2, 2) << 1, 2, 3, 4;
  a.bottomRightCorner(2, 2) << 5, 6, 7, 8;
  PaperLu lu(4, 4, {0, 0, 1, 1}, {1, 2});
  fill(lu, a);
  EXPECT_EQ(lu.factorise(), 3);
  EXPECT_EQ(lu.pivots_of(0), 1);
  EXPECT_EQ(lu.pivots_of(1), 2);
}

TEST(PaperLu, FactorisesRandomMatricesOfAnyRank) {
  std::mt19937_64 random(3);
  for (int round = 0; round < 200; ++round) {
    const int rows = 1 + static_cast<int>(random() % 8), columns = 1 + static_cast<int>(random() % 9);
    const int rank = 1 + static_cast<int>(random() % std::min(rows, columns));
    const Eigen::MatrixXd a = random_matrix(random, rows, columns, rank);
    PaperLu lu(rows, columns, std::vector<int>(columns, 0), {rank});
    fill(lu, a);
    ASSERT_EQ(lu.factorise(), rank);
    Eigen::MatrixXd pivots(rows, rank), others(rows, columns - rank);
    for (int place = 0; place < columns; ++place)
      (place < rank ? pivots.col(place) : others.col(place - rank)) = a.col(lu.column(place));
    std::vector<double> x;
    lu.dependence(rank, columns - rank, x);
    const Eigen::Map<const Eigen::MatrixXd> follow(x.data(), rank, columns - rank);
    const double size = 1 + follow.cwiseAbs().sum();
    EXPECT_LT((pivots * follow - others).cwiseAbs().sum(), 1e-12 * size);
    const std::vector<double> given(columns - rank, 0.7);
    const Eigen::VectorXd b = a * Eigen::VectorXd::Ones(columns);
    lu.solve({b.data(), b.data() + rows}, given, x);
    const Eigen::VectorXd solution = Eigen::Map<const Eigen::VectorXd>(x.data(), rank);
    EXPECT_LT((pivots * solution + others * Eigen::VectorXd::Constant(columns - rank, 0.7) - b).norm(), 1e-12 * size);
  }
}

SparseRows rows_of(const Eigen::MatrixXd& a) {
  std::vector<std::vector<double>> rows(static_cast<std::size_t>(a.rows()));
  for (Eigen::Index r = 0; r < a.rows(); ++r)
    for (Eigen::Index c = 0; c < a.cols(); ++c) rows[static_cast<std::size_t>(r)].push_back(a(r, c));
  return sparse_rows(rows);
}

Eigen::MatrixXd as_matrix(const Eigen::MatrixXd& a, int /*columns*/) { return a; }
Eigen::MatrixXd as_matrix(const SparseRows& rows, int columns) {
  const std::vector<double> flat = written_out(rows, columns);
  return Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>(
      flat.data(), static_cast<Eigen::Index>(rows.size()), columns);
}

template <class Pivoted>
class EveryPivoted : public ::testing::Test {};
using PivotedTypes = ::testing::Types<SparseLu, PivotedLu, PivotedQr>;
TYPED_TEST_SUITE(EveryPivoted, PivotedTypes);

TYPED_TEST(EveryPivoted, FactorisesRandomMatricesOfAnyRank) {
  std::mt19937_64 random(4);
  for (int round = 0; round < 200; ++round) {
    const int rows = 1 + static_cast<int>(random() % 8), columns = 1 + static_cast<int>(random() % 9);
    const int rank = 1 + static_cast<int>(random() % std::min(rows, columns));
    const Eigen::MatrixXd a = random_matrix(random, rows, columns, rank);
    TypeParam factors;
    factors.compute(rows_of(a), columns, std::min(rows, columns));
    ASSERT_EQ(factors.rank(), rank);
    Eigen::MatrixXd pivots(rows, rank), others(rows, columns - rank);
    for (int place = 0; place < columns; ++place)
      (place < rank ? pivots.col(place) : others.col(place - rank)) = a.col(factors.column(place));
    const Eigen::MatrixXd follow = as_matrix(factors.dependence(), columns - rank);
    const double size = 1 + follow.cwiseAbs().sum();
    EXPECT_LT((pivots * follow - others).cwiseAbs().sum(), 1e-12 * size);
    const Eigen::VectorXd b = pivots * Eigen::VectorXd::Ones(rank);
    EXPECT_LT((pivots * factors.solve(b) - b).norm(), 1e-12);
    const Eigen::VectorXd f = pivots.transpose() * Eigen::VectorXd::Ones(rows);
    EXPECT_LT((pivots.transpose() * factors.solve_transposed(f) - f).norm(), 1e-11);
  }
}

// The driven column is the largest; without it, the first and the third say it all.
TYPED_TEST(EveryPivoted, BlockFactorsLeaveDrivenColumnsAlone) {
  const SparseRows jacobian = sparse_rows({{4, 100, 0, 2}, {0, 100, 5, 5}, {4, 200, 5, 7}});
  const BlockFactorsOf<TypeParam> factors(jacobian, 4, {1, 3}, 2);
  ASSERT_EQ(factors.rank(), 2);
  EXPECT_EQ(factors.free(), std::vector<int>{});
  std::vector<double> x{9, 0.1, 9, 2};  // the given ones take (14, 20, 34) of the right-hand side
  factors.solve({18, 25, 43}, x);
  EXPECT_NEAR(x[0], 1, 1e-14);
  EXPECT_NEAR(x[2], 1, 1e-14);
  EXPECT_EQ(x[1], 0.1);
  EXPECT_EQ(x[3], 2);
}

// Two equal equations of one coordinate: each carries half of the force by the least multipliers, all of it is carried
// by one that had the pivot.
TYPED_TEST(EveryPivoted, MultipliersOfRedundantEquationsCarryTheForceTogether) {
  const BlockFactorsOf<TypeParam> factors(sparse_rows({{2, 1}, {2, 1}}), 2, {1}, 1);
  const std::vector<double> lambda = factors.multipliers({6, 0});
  EXPECT_NEAR(lambda[0] + lambda[1], 3, 1e-14);
  EXPECT_NEAR(std::abs(lambda[0] - lambda[1]), (std::is_same_v<TypeParam, PivotedQr> ? 0 : 3), 1e-14);
}

TYPED_TEST(EveryPivoted, RzOfABlock) {
  const BlockFactorsOf<TypeParam> factors(sparse_rows({{1, 4, 2}}), 3, {},
                                          1);  // the largest entry depends: x1 = -x0/4 - x2/2
  const std::vector<std::vector<double>> rz = factors.rz();
  ASSERT_EQ(factors.dependent(), std::vector<int>{1});
  for (std::size_t q = 0; q < 2; ++q) {
    EXPECT_EQ(rz[factors.free()[q]][q], 1);
    EXPECT_EQ(rz[factors.free()[q]][1 - q], 0);
    EXPECT_NEAR(rz[1][q], factors.free()[q] == 0 ? -0.25 : -0.5, 1e-15);
  }
}

/// Rows with a few entries in random columns; some repeat others.
Eigen::MatrixXd random_sparse(std::mt19937_64& random, int rows, int columns) {
  std::uniform_real_distribution<double> unit(-1, 1);
  Eigen::MatrixXd a = Eigen::MatrixXd::Zero(rows, columns);
  for (int r = 0; r < rows; ++r)
    for (int e = 0; e < 4; ++e) a(r, static_cast<int>(random() % static_cast<unsigned>(columns))) = unit(random);
  for (int r = 0; r + 7 < rows; r += 7) a.row(r + 3) = 2 * a.row(r);
  return a;
}

// Elimination of a zero changes nothing, so the same pivots come in the same order.
TEST(SparseLu, TakesThePivotsOfDenseElimination) {
  std::mt19937_64 random(11);
  for (int round = 0; round < 50; ++round) {
    const int rows = 20 + static_cast<int>(random() % 30), columns = 20 + static_cast<int>(random() % 30);
    const Eigen::MatrixXd a = random_sparse(random, rows, columns);
    SparseLu sparse;
    sparse.compute(rows_of(a), columns, rows);
    Eigen::FullPivLU<Eigen::MatrixXd> dense(a);
    dense.setThreshold(kRankTolerance<double>);
    ASSERT_EQ(sparse.rank(), dense.rank());
    double smallest = INFINITY;
    for (int k = 0; k < sparse.rank(); ++k) {
      EXPECT_EQ(sparse.column(k), dense.permutationQ().indices()[k]) << "round " << round << " pivot " << k;
      smallest = std::min(smallest, std::abs(dense.matrixLU()(k, k)));
    }
    EXPECT_NEAR(sparse.smallest_pivot(), smallest, 1e-12);
  }
}

TEST(SparseLu, EndsAtItsLimitAndRefusesWhatIsNotFinite) {
  SparseLu lu;
  lu.compute(sparse_rows({{1, 0, 0}, {0, 3, 0}, {0, 0, 2}}), 3, 2);
  EXPECT_EQ(lu.rank(), 2);
  EXPECT_EQ(lu.rows(), (std::vector<int>{1, 2}));
  EXPECT_EQ(lu.column(2), 0);
  lu.compute(sparse_rows({{1, NAN}, {0, 3}}), 2, 2);
  EXPECT_EQ(lu.rank(), 0);
}

// Twice two unknowns, coupled by the first column alone: a machine of many legs on one crank. The column that all legs
// share may change with every pivot; dense elimination grows with the cube of the legs.
TEST(SparseLu, GrowsWithTheLegsOfAMachine) {
  const auto multiplications = [](int legs) {
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> unit(1, 2);
    std::vector<std::vector<double>> rows;
    for (int leg = 0; leg < legs; ++leg)
      for (int e = 0; e < 2; ++e) {
        rows.emplace_back(1 + 2 * legs, 0.0);
        rows.back()[0] = unit(random);
        rows.back()[static_cast<std::size_t>(1 + 2 * leg)] = unit(random);
        rows.back()[static_cast<std::size_t>(2 + 2 * leg)] = -unit(random);
      }
    SparseLu lu;
    lu.compute(sparse_rows(rows), 1 + 2 * legs, 2 * legs);
    EXPECT_EQ(lu.rank(), 2 * legs);
    return lu.multiplications();
  };
  EXPECT_LE(multiplications(40), 40 * 40);
  EXPECT_LE(multiplications(400), 400 * 400);
}

TEST(KluFactors, KeepsItsPivotsWhileTheyAreGood) {
  KluFactors factors({0, 2, 4}, {0, 1, 0, 1});
  const auto solution = [&](std::vector<double> values, std::vector<double> b) {
    factors.values() = std::move(values);
    EXPECT_GT(factors.factorise(), 0);
    factors.solve(static_cast<int>(b.size()) / 2, b);
    return b;
  };
  const auto expect_near = [](const std::vector<double>& actual, const std::vector<double>& expected) {
    ASSERT_EQ(actual.size(), expected.size());
    for (std::size_t i = 0; i < actual.size(); ++i) EXPECT_NEAR(actual[i], expected[i], 1e-15);
  };
  expect_near(solution({2, 1, 1, 3}, {3, 4, 2, 1}), {1, 1, 1, 0});
  expect_near(solution({4, 1, 1, 3}, {5, 4}), {1, 1});
  expect_near(solution({0, 1, 2, 0}, {4, 5}), {5, 2});  // the pivots of last time are zero now
  factors.values() = {1, 1, 1, 1};
  EXPECT_FALSE(factors.factorise() > 1e-15);
  expect_near(solution({2, 1, 1, 3}, {3, 4}), {1, 1});
}

}  // namespace
}  // namespace mbgen
