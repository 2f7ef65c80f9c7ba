// Loop blocks solved fine block by fine block: against the equations themselves.

#include "mbgen/solver/fine.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace mbgen {
namespace {

constexpr double kRounding = 1e-9;  // of well-conditioned systems of 12 equations

/// Fine blocks of 1, 2 and 3 equations in turn, in a loop block with equations that have no pivot between theirs, under
/// `other_count` other columns, the last of which is driven.
struct Loop {
  static constexpr int kParts = 6, kDependent = 12, kLargest = 3;
  int other_count, coordinates = kDependent + other_count, equations = 2 * kDependent;
  std::vector<FineBlock> blocks;
  std::vector<int> rows, columns, earlier, others;
  std::vector<double> jacobian, open, bias;
  std::vector<unsigned char> is_driven;
  // Results and memory.
  std::vector<double> solved, work;
  std::vector<int> free, places;
  std::vector<unsigned char> movable;
  FineSolution<double> solution;

  explicit Loop(std::mt19937& random, int count) : other_count(count) {
    std::uniform_real_distribution<double> entry(-1, 1);
    std::vector<int> order(coordinates);
    for (int c = 0; c < coordinates; ++c) order[c] = c;
    std::shuffle(order.begin(), order.end(), random);
    others.assign(order.begin(), order.begin() + other_count);
    jacobian.resize(static_cast<std::size_t>(equations) * coordinates, 0.0);
    is_driven.resize(coordinates, 0);
    is_driven[others.back()] = 1;
    for (int e = 0; e < equations; ++e) open.push_back(entry(random)), bias.push_back(entry(random));
    for (int p = 0; p < kParts; ++p) {
      FineBlock block{1 + p % 3, static_cast<int>(rows.size()), static_cast<int>(earlier.size()), 0};
      std::vector<int> known(order.begin(), order.begin() + other_count + block.first);
      for (const int c : known)
        if (entry(random) > 0 || c == others.front() || c == others[others.size() / 2]) earlier.push_back(c);
      block.earlier = static_cast<int>(earlier.size()) - block.first_earlier;
      for (int i = 0; i < block.size; ++i) {
        rows.push_back(2 * (block.first + i) + 1);
        columns.push_back(order[other_count + block.first + i]);
      }
      for (int i = 0; i < block.size; ++i) {
        for (int k = 0; k < block.earlier; ++k)
          at(rows[block.first + i], earlier[block.first_earlier + k]) = entry(random);
        for (int j = 0; j < block.size; ++j)
          at(rows[block.first + i], columns[block.first + j]) = entry(random) + (i == j ? 2 : 0);
      }
      blocks.push_back(block);
    }
  }
  double& at(int equation, int column) { return jacobian[static_cast<std::size_t>(equation) * coordinates + column]; }

  bool solve(double least, const std::vector<double>& told = {}) {
    const FineStructure structure = {blocks.data(), kParts,      rows.data(), columns.data(), earlier.data(),
                                     others.data(), other_count, coordinates, kLargest};
    solved.assign(static_cast<std::size_t>(coordinates) * (other_count + 2), 0.0);
    work.assign(fine_work(kLargest, other_count), 0.0);
    free.assign(other_count, -1);
    places.assign(2 * kLargest, 0);
    movable.assign(other_count, 0);
    solution.rows = solved.data();
    solution.others = free.data();
    return solve_finely(structure, jacobian.data(), open.data(), told.empty() ? bias.data() : nullptr, is_driven.data(),
                        least, solution, work.data(), places.data(), movable.data(),
                        told.empty() ? nullptr : told.data());
  }
  /// Largest part of an equation with a pivot that a column of the solution leaves.
  double left(int column, const std::vector<double>* right_hand_side, double sign) const {
    double largest = 0;
    for (const int e : rows) {
      double sum = right_hand_side != nullptr ? sign * (*right_hand_side)[e] : 0;
      for (int c = 0; c < coordinates; ++c)
        sum += jacobian[static_cast<std::size_t>(e) * coordinates + c] * solution.row(c)[column];
      largest = std::max(largest, std::abs(sum));
    }
    return largest;
  }
  void expect_solved() const {
    for (int t = 0; t < other_count; ++t) {
      EXPECT_LT(left(t, nullptr, 0), kRounding);
      for (int s = 0; s < other_count; ++s) EXPECT_EQ(solution.row(free[s])[t], s == t ? 1 : 0);
    }
    EXPECT_LT(left(other_count, &open, 1), kRounding);
    EXPECT_LT(left(other_count + 1, &bias, -1), kRounding);
    for (int s = 0; s < other_count; ++s) EXPECT_EQ(solution.row(free[s])[other_count], 0);
  }
};

TEST(FineBlocks, SolveTheEquations) {
  std::mt19937 random(20251127);
  for (int n = 0; n < 50; ++n) {
    Loop loop(random, 1 + n % 3);
    ASSERT_TRUE(loop.solve(1e-3)) << n;
    loop.expect_solved();
  }
}

/// Where the equations of a fine block do not hold its own coordinate, that is free from there on, and one that was
/// free depends on it: in whichever fine block, and once more in another one where another coordinate is free.
TEST(FineBlocks, ExchangeAColumnThatIsBadInOne) {
  std::mt19937 random(20251128);
  for (int bad = 0; bad < Loop::kParts; ++bad) {
    for (const int others : {2, 3}) {
      Loop loop(random, others);
      std::vector<int> bad_columns;
      for (const int part : {bad, others == 3 ? (bad + 2) % Loop::kParts : bad}) {
        const FineBlock& block = loop.blocks[part];
        for (int i = 0; i < block.size; ++i) loop.at(loop.rows[block.first + i], loop.columns[block.first]) = 1e-14;
        loop.at(loop.rows[block.first], loop.others[0]) = part == bad ? 1.5 : 0;
        bad_columns.push_back(loop.columns[block.first]);
      }
      ASSERT_TRUE(loop.solve(1e-4)) << bad;
      loop.expect_solved();
      EXPECT_NE(std::find_first_of(loop.free.begin(), loop.free.end(), bad_columns.begin(), bad_columns.end()),
                loop.free.end());
      EXPECT_EQ(loop.free.back(), loop.others.back()) << "the driven column";
    }
  }
}

/// Two equations of a fine block that say the same, as at a singular position: one of them is left out, and a
/// coordinate stays and keeps its velocity; beside another fine block where coordinates are exchanged, or none.
TEST(FineBlocks, AreSolvedAsFarAsTheirPivotsGo) {
  std::mt19937 random(20251130);
  std::uniform_real_distribution<double> entry(-1, 1);
  for (const int singular : {1, 2, 4, 5}) {
    for (const int exchanged : {-1, 0, 3}) {
      Loop loop(random, 2);
      const FineBlock& block = loop.blocks[singular];
      for (int c = 0; c < loop.coordinates; ++c)
        loop.at(loop.rows[block.first + 1], c) = loop.at(loop.rows[block.first], c);
      if (exchanged >= 0) {
        loop.at(loop.rows[loop.blocks[exchanged].first], loop.columns[loop.blocks[exchanged].first]) = 1e-14;
        loop.at(loop.rows[loop.blocks[exchanged].first], loop.others[0]) = 1.5;
      }
      std::vector<double> told(loop.coordinates);
      for (double& velocity : told) velocity = entry(random);
      EXPECT_FALSE(loop.solve(1e-4));
      ASSERT_TRUE(loop.solve(1e-4, told));
      EXPECT_LT(loop.solution.smallest_pivot, 1e-10);
      EXPECT_EQ(loop.free[0] == loop.others[0], exchanged < 0);
      // Positions close all equations but one, at rest of the other columns; velocities hold with these as told.
      int open = 0, held = 0;
      for (const int e : loop.rows) {
        double position = loop.open[e], velocity = 0;
        for (int c = 0; c < loop.coordinates; ++c) {
          const double* const row = loop.solution.row(c);
          position += loop.at(e, c) * row[2];
          velocity += loop.at(e, c) * (row[0] * told[loop.free[0]] + row[1] * told[loop.free[1]] + row[3]);
        }
        EXPECT_LT(std::abs(velocity), kRounding);
        if (std::abs(position) > kRounding) ++open;
      }
      for (int i = 0; i < block.size; ++i) {
        const double* const row = loop.solution.row(loop.columns[block.first + i]);
        if (row[0] == 0 && row[1] == 0 && row[2] == 0 && row[3] == told[loop.columns[block.first + i]]) ++held;
      }
      EXPECT_EQ(open, 1);
      EXPECT_EQ(held, 1);
    }
  }
}

TEST(FineBlocks, RefuseASmallPivot) {
  std::mt19937 random(20251129);
  Loop loop(random, 1);  // the other column is driven
  ASSERT_TRUE(loop.solve(1e-3));
  const double smallest = loop.solution.smallest_pivot;
  EXPECT_TRUE(loop.solve(0.999 * smallest));
  EXPECT_FALSE(loop.solve(1.001 * smallest));
  loop.at(loop.rows[3], loop.columns[3]) = std::nan("");
  EXPECT_FALSE(loop.solve(1e-3));
}

}  // namespace
}  // namespace mbgen
