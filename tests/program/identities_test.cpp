// Values that are equal by algebra.

#include "compiler/program/identities.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <vector>

#include "compiler/passes/passes.hpp"
#include "tests/support/random_program.hpp"

namespace mbgen {
namespace {

using Make = std::function<std::vector<Expr>(const std::vector<Expr>& x)>;

/// Identities of the values of `make` over six inputs, in the numbers of the values themselves.
struct Found {
  std::vector<ValueId> values;
  std::vector<Identity> all;

  bool is_zero(std::size_t i) const { return all[values[i]].sign == 0; }
  /// 1 or -1 where values i and j are equal up to that sign, 0 where nothing says so.
  int sign(std::size_t i, std::size_t j) const {
    const Identity &first = all[values[i]], &second = all[values[j]];
    return first.first == second.first ? first.sign * second.sign : 0;
  }
};

Found found(const Make& make) {
  ProgramBuilder builder("f");
  std::vector<Expr> x;
  for (int i = 0; i < 6; ++i) x.emplace_back(builder, builder.input(Array::in, i));
  Found result;
  for (const Expr& value : make(x)) result.values.push_back(value.value(builder));
  for (std::size_t i = 0; i < result.values.size(); ++i)
    builder.output(Array::y, static_cast<int>(i), result.values[i]);
  result.all = identities(builder.finish());
  return result;
}

TEST(Identities, FindOtherSpellings) {
  const Found f = found([](const auto& x) -> std::vector<Expr> {
    return {(x[0] * x[1]) * x[2], x[0] * (x[1] * x[2]), x[3] * (x[0] - x[1]), x[3] * x[1] - x[3] * x[0],
            (x[0] / x[1]) * x[1] - x[0]};
  });
  EXPECT_EQ(f.sign(0, 1), 1);
  EXPECT_EQ(f.sign(2, 3), -1);
  EXPECT_EQ(f.sign(0, 2), 0);
  EXPECT_TRUE(f.is_zero(4));
}

TEST(Identities, KnowTheCircle) {
  const Found f = found([](const auto& x) -> std::vector<Expr> {
    const Expr c = cos(x[0]), s = sin(x[0]);
    return {c * c + s * s - 1.0, c * c + sin(x[1]) * sin(x[1]) - 1.0, s, sin(x[1] - (x[0] + x[1]))};
  });
  EXPECT_TRUE(f.is_zero(0));
  EXPECT_FALSE(f.is_zero(1));
  EXPECT_EQ(f.sign(2, 3), -1);
}

/// A 2x2 system after elimination: what is left of its first column is zero, the solution solves it.
TEST(Identities, FollowAnElimination) {
  const Found f = found([](const auto& x) -> std::vector<Expr> {
    const Expr factor = x[2] / x[0], pivot = x[3] - factor * x[1];
    const Expr second = (x[5] - factor * x[4]) / pivot, first = (x[4] - x[1] * second) / x[0];
    return {x[2] - factor * x[0], x[2] * first + x[3] * second, x[5], pivot};
  });
  EXPECT_TRUE(f.is_zero(0));
  EXPECT_EQ(f.sign(1, 2), 1);
  EXPECT_FALSE(f.is_zero(3));
}

TEST(Identities, TakeNumbersAsTyped) {
  const Found f = found([](const auto& x) -> std::vector<Expr> {
    return {0.1 * x[0] + 0.2 * x[0] - 0.3 * x[0],               // as doubles 5.6e-17 x
            0.1 * x[0] + 0.2 * x[0] - 0.30000000000001 * x[0],  // differs in the last of 14 digits
            3.0 * (1.0 / 3.0 * x[0]) - x[0],                    // a number that nobody typed
            1e-300 * x[0]};
  });
  EXPECT_TRUE(f.is_zero(0));
  for (const std::size_t i : {1, 2, 3}) EXPECT_FALSE(f.is_zero(i)) << i;
}

TEST(Identities, OtherFunctionsAreVariables) {
  const Found f = found([](const auto& x) -> std::vector<Expr> {
    const Expr sum = x[0] * x[2] + x[1] * x[2], product = x[2] * (x[1] + x[0]);
    return {exp(sum),
            exp(product),
            exp(-sum),
            tanh(sum),
            tanh(-product),
            abs(sum),
            abs(-product),
            select(sum, x[0], x[1]),
            select(-product, x[0], x[1]),
            min(x[0], x[1]),
            sqrt(x[0]) * sqrt(x[0]),
            x[0]};
  });
  EXPECT_EQ(f.sign(0, 1), 1);
  EXPECT_EQ(f.sign(0, 2), 0);
  EXPECT_EQ(f.sign(3, 4), -1);
  EXPECT_EQ(f.sign(5, 6), 1);
  EXPECT_EQ(f.sign(7, 8), 0) << "select of the opposite condition";
  EXPECT_EQ(f.sign(10, 11), 0) << "the root of a negative number is none";
}

/// x^n y^n and (x y)^n, n a power of two: up to a degree they are known to be equal, beyond it nothing is claimed.
TEST(Identities, ClaimNothingOfTooHighADegree) {
  const auto powers = [](int doublings) {
    return found([&](const auto& x) -> std::vector<Expr> {
      Expr a = x[0], b = x[1], both = x[0] * x[1];
      for (int i = 0; i < doublings; ++i) a = a * a, b = b * b, both = both * both;
      return {a * b, both};
    });
  };
  EXPECT_EQ(powers(18).sign(0, 1), 1);
  EXPECT_EQ(powers(30).sign(0, 1), 0);
}

TEST(Identities, HoldInBothLanesOfAPair) {
  ProgramBuilder builder("f");
  const ValueId x = builder.input(Array::x, 0), y = builder.input(Array::x, 1);
  const auto append = [&](Op op, ValueId a, ValueId b = kNoValue) { return builder.append(op, a, b); };
  const ValueId pair = append(Op::pack, x, y), mixed = append(Op::pack, x, x);
  const ValueId twice = append(Op::add, pair, pair), difference = append(Op::subtract, twice, pair);
  const ValueId half = append(Op::subtract, pair, mixed), number = append(Op::first_lane, half);
  builder.output(Array::y, 0, append(Op::second_lane, difference));
  builder.output(Array::y, 1, number);
  builder.output(Array::y, 2, append(Op::second_lane, half));
  const std::vector<Identity> all = identities(builder.finish());
  EXPECT_EQ(all[difference].first, pair);
  EXPECT_EQ(all[number].sign, 0);
  EXPECT_EQ(all[half].first, half) << "zero in its first lane alone";
  EXPECT_EQ(all[mixed].first, mixed) << "a pair is not the number in both its lanes";
}

/// Merging changes no value by more than rounding, in programs with every kind of operation.
TEST(MergeEqualValues, KeepsValues) {
  int merged = 0;
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    const Program program = remove_dead_values(random_program(seed, 300));
    const Program lean = remove_dead_values(merge_equal_values(program));
    ASSERT_EQ(lean.inputs, program.inputs);
    const long saved = count_operations(program).total() - count_operations(lean).total();
    EXPECT_GE(saved, 0);
    merged += saved > 0;
    std::vector<double> inputs;
    for (std::size_t i = 0; i < program.inputs.size(); ++i) inputs.push_back(0.3 + 0.17 * static_cast<double>(i));
    const std::vector<double> before = interpret(program, inputs), after = interpret(lean, inputs);
    for (std::size_t i = 0; i < before.size(); ++i)
      EXPECT_NEAR(after[i], before[i], 1e-9 * (1 + std::abs(before[i]))) << "seed " << seed;
  }
  EXPECT_GT(merged, 0);
}

}  // namespace
}  // namespace mbgen
