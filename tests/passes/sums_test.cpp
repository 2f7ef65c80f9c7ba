// The passes that rewrite and reorder sums.

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <random>

#include "compiler/passes/passes.hpp"
#include "compiler/program/rounded.hpp"

namespace mbgen {
namespace {

/// A program of one output over inputs x[0..5].
Program program_of(const std::function<Expr(const std::vector<Expr>&)>& body) {
  ProgramBuilder builder("f");
  std::vector<Expr> x;
  for (int i = 0; i < 6; ++i) x.emplace_back(builder, builder.input(Array::x, i));
  builder.set_section({Step::inertias});
  builder.output(Array::y, 0, body(x).value(builder));
  return builder.finish();
}

long operations(const Program& program) { return count_operations(remove_dead_values(program)).total(); }

TEST(FactorSums, TakesACommonFactorOut) {
  const Program program = program_of([](const auto& x) { return x[0] * x[1] + x[0] * x[2] + x[3] - x[0] * x[4]; });
  EXPECT_EQ(operations(program), 6);
  EXPECT_EQ(operations(factor_sums(program)), 4);  // x3 + x0 (x1 + x2 - x4)
}

TEST(FactorSums, CancelsAcrossTheSum) {
  const Program program = program_of([](const auto& x) { return (x[0] * x[1] + x[2]) - (x[0] * x[1] - x[3]); });
  EXPECT_EQ(operations(factor_sums(program)), 1);  // x2 + x3
  const Program nothing = program_of([](const auto& x) { return (x[0] + x[1]) - (x[1] + x[0]); });
  EXPECT_EQ(operations(factor_sums(nothing)), 0);
  EXPECT_EQ(interpret(factor_sums(nothing), std::vector<double>(nothing.inputs.size(), 3.0))[0], 0.0);
}

TEST(FactorSums, PutsConstantsTogether) {
  const Program program = program_of([](const auto& x) { return (2.5 + x[0] * x[1]) + (x[2] - 0.5); });
  EXPECT_EQ(operations(factor_sums(program)), 3);
}

TEST(FactorSums, LeavesConstantsApartWhoseSumIsTooLarge) {
  const Program program = program_of([](const auto& x) { return (1e308 + x[0]) + (1e308 + x[1]); });
  const std::vector<double> inputs = {-1e308, -1e308, 0, 0, 0, 0};
  EXPECT_EQ(interpret(program, inputs)[0], 0.0);
  EXPECT_FALSE(std::isnan(interpret(factor_sums(program), inputs)[0]));
}

TEST(FactorSums, TakesSumsOfAnyLength) {
  const Program program = program_of([](const auto& x) {
    Expr sum = x[0];
    for (int i = 0; i < 300'000; ++i) sum = (i % 2 == 0 ? x[1] : x[2]) - sum;
    return sum;
  });
  // Every second term is the opposite of the one two before: 150000 (x2 - x1) + x0.
  const std::vector<double> inputs = {0.5, 2, 3, 0, 0, 0};
  EXPECT_EQ(interpret(factor_sums(program), inputs)[0], 150'000.5);
}

TEST(FactorSums, LeavesNamedValuesAndThoseOfTwoUsersAlone) {
  ProgramBuilder builder("f");
  const Expr a(builder, builder.input(Array::x, 0)), b(builder, builder.input(Array::x, 1)),
      c(builder, builder.input(Array::x, 2));
  const Expr product = a * b, sum = product + a * c;
  builder.label(product.value(builder), "named");
  builder.output(Array::y, 0, sum.value(builder));
  builder.output(Array::y, 1, (sum * c).value(builder));
  const Program rewritten = factor_sums(builder.finish());
  EXPECT_EQ(rewritten.labels, std::vector<std::string>{"named"});
  EXPECT_EQ(operations(rewritten), 4);
}

TEST(FactorSums, NegativeSumsKeepTheirSign) {
  const Program program = program_of([](const auto& x) { return -(x[0] * x[1]) - x[2] * x[1] - x[3] * x[4]; });
  const Program rewritten = factor_sums(program);
  EXPECT_EQ(interpret(rewritten, std::vector<double>{2, 3, 5, 7, 11, 13})[0], -(6.0 + 15.0 + 77.0));
}

/// Random straight-line programs of sums and products.
Program random_program(unsigned seed) {
  std::mt19937 random(seed);
  ProgramBuilder builder("f");
  std::vector<Expr> values;
  for (int i = 0; i < 5; ++i) values.emplace_back(builder, builder.input(Array::x, i));
  const auto any = [&] { return values[random() % values.size()]; };
  for (int i = 0; i < 60; ++i) {
    builder.set_section({Step::forces, i / 20});
    switch (random() % 4) {
      case 0:
        values.push_back(any() + any());
        break;
      case 1:
        values.push_back(any() - any());
        break;
      case 2:
        values.push_back(any() * any());
        break;
      default:
        values.push_back(any() * 0.25 - any());
    }
    values.back() = values.back() * 0.5;  // so that values stay small
  }
  for (int i = 0; i < 4; ++i) builder.output(Array::y, i, any().value(builder));
  return builder.finish();
}

TEST(Passes, RandomSumsKeepTheirValuesAndGetNoDearer) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> number(-1, 1);
  for (unsigned seed = 0; seed < 300; ++seed) {
    const Program program = remove_dead_values(random_program(seed)), rewritten = factor_sums(program);
    EXPECT_LE(operations(rewritten), operations(program)) << seed;
    std::vector<double> inputs(program.inputs.size());
    for (double& value : inputs) value = number(random);
    ASSERT_EQ(rewritten.inputs, program.inputs);
    const std::vector<double> expected = interpret(program, inputs), actual = interpret(rewritten, inputs);
    for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_NEAR(actual[i], expected[i], 1e-12) << seed;
  }
}

/// Largest bound of the roundings of an output over that before, at states whose inputs are known to a rounding.
double factor_of_bounds(const Program& before, const Program& now) {
  double most = 0;
  for (std::size_t number = 0; number < 2; ++number) {
    std::vector<Rounded> inputs;
    for (const double input : ordinary_inputs(before, number))
      inputs.push_back({input, std::numeric_limits<double>::epsilon() * std::abs(input)});
    RoundedValues old_values(inputs), new_values(inputs);
    for (const Node& node : before.nodes) old_values.append(node);
    for (const Node& node : now.nodes) new_values.append(node);
    for (std::size_t i = 0; i < before.outputs.size(); ++i) {
      const double old_error = old_values[before.outputs[i].value].first.error;
      const double new_error = new_values[now.outputs[i].value].first.error;
      if (new_error > 0) most = std::max(most, new_error / old_error);
    }
  }
  return most;
}

TEST(FactorSums, OpenedBracketsAreAddedBeforeALargeTerm) {
  const Program program = program_of([](const auto& x) {
    return 1e4 + ((x[0] * x[1] + x[2]) - (x[3] * x[4] - (x[0] * x[5] - (x[1] * x[2] + x[3] * x[5]))));
  });
  const Program rewritten = factor_sums(program);
  EXPECT_LE(factor_of_bounds(program, rewritten), 1);
  EXPECT_LT(operations(rewritten), operations(program));
}

TEST(FactorSums, ASumThatItCannotKeepStandsAsItStood) {
  const Program program =
      program_of([](const auto& x) { return 1e4 - (x[0] + (x[1] + (x[2] + (x[3] + x[4] * x[5])))); });
  const Program rewritten = remove_dead_values(factor_sums(program));
  EXPECT_LE(factor_of_bounds(program, rewritten), 1);
  EXPECT_EQ(operations(rewritten), operations(program));
  const Node& last = rewritten.nodes[rewritten.outputs[0].value];
  EXPECT_EQ(last.op, Op::subtract);
  EXPECT_EQ(rewritten.nodes[last.operands[0]].constant, 1e4);
}

TEST(FactorSums, BoundsOfRoundingsStayWithinTwice) {
  std::mt19937 random(38);
  const auto constant = [&] { return std::pow(10.0, static_cast<double>(random() % 9) - 4); };
  for (int k = 0; k < 500; ++k) {
    const Program program = program_of([&](const std::vector<Expr>& x) {
      std::vector<Expr> values = x;
      const auto any = [&] { return values[random() % values.size()]; };
      for (int i = 0; i < 20; ++i) {
        const Expr a = any(), b = any(), c = any(), d = any();
        values.push_back(i % 3 == 0   ? a * b
                         : i % 3 == 1 ? a * constant() - (b - c * d)
                                      : (a - b) + (c * a - constant()));
      }
      return values.back() - values[values.size() - 2];
    });
    EXPECT_LE(factor_of_bounds(program, factor_sums(program)), 2 + 1e-9) << k << "\n" << dump(program);
  }
}

TEST(FactorSums, TermsStandInTheOrderInWhichTheyAreKnown) {
  ProgramBuilder builder("f");
  const Expr x(builder, builder.input(Array::x, 0)), y(builder, builder.input(Array::x, 1));
  const Expr first = sin(x) * sin(y), second = cos(x), third = cos(y);
  builder.output(Array::y, 0, (third + (second + first)).value(builder));
  const Program program = factor_sums(builder.finish());
  const Node& last = program.nodes[program.outputs[0].value];
  ASSERT_EQ(last.op, Op::add);
  const auto is_third = [&](ValueId v) {
    const Node& node = program.nodes[v];
    return node.op == Op::cos && program.nodes[node.operands[0]].input == 1;
  };
  EXPECT_TRUE(is_third(last.operands[0]) || is_third(last.operands[1]));
}

TEST(FactorSums, ASumTakesTermsOfEarlierSteps) {
  ProgramBuilder builder("f");
  const Expr a(builder, builder.input(Array::x, 0)), b(builder, builder.input(Array::x, 1)),
      c(builder, builder.input(Array::x, 2));
  builder.set_section({Step::inertias});
  const Expr part = a * b;
  builder.set_section({Step::jacobian});
  builder.output(Array::y, 0, (part + a * c).value(builder));
  const Program program = remove_dead_values(factor_sums(builder.finish()));
  EXPECT_EQ(operations(program), 2);  // a (b + c)
}

}  // namespace
}  // namespace mbgen
