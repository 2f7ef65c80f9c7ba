// Derivatives of every operation against closed forms, and second application.

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <tuple>
#include <vector>

#include "compiler/passes/passes.hpp"
#include "compiler/program/program.hpp"

namespace mbgen {
namespace {

/// Values of a program whose inputs are x[0], x[1] and seeds.
std::vector<double> values_at(const Program& program, const std::vector<double>& x,
                              const std::vector<double>& seeds = {}) {
  std::vector<double> inputs;
  for (const Slot& slot : program.inputs) {
    inputs.push_back((slot.group == Array::seed ? seeds : x).at(static_cast<std::size_t>(slot.index)));
  }
  return interpret(program, inputs);
}

using Function = std::function<Expr(const Expr& x, const Expr& y)>;

Program program_of(const Function& function) {
  ProgramBuilder builder("f");
  const Expr x(builder, builder.input(Array::x, 0)), y(builder, builder.input(Array::x, 1));
  builder.output(Array::y, 0, function(x, y).value(builder));
  return builder.finish();
}

/// Both slopes by forward differentiation.
std::vector<double> slopes_at(const Function& function, double x, double y) {
  const Program slope = differentiate(program_of(function), std::vector<int>{0, 1});
  return {values_at(slope, {x, y}, {1, 0}).at(1), values_at(slope, {x, y}, {0, 1}).at(1)};
}

TEST(Derivative, OfSamplesIsThatOfTheWeightsAroundThem) {
  const auto table = std::make_shared<const std::vector<double>>(std::vector<double>{3, 5, 4, 7});
  ProgramBuilder builder("f");
  builder.set_samples(table);
  const Expr x(builder, builder.input(Array::x, 0)), whole = floor(x), t = x - whole;
  builder.output(Array::y, 0, ((1 - t) * sample(*table, whole) + t * sample(*table, whole + 1)).value(builder));
  const Program program = builder.finish_in_canonical_order();
  const Program slope = differentiate(program, std::vector<int>{0});
  for (const auto& [at, value, rise] :
       {std::tuple(0.25, 3.5, 2.0), {1.0, 5.0, -1.0}, {2.5, 5.5, 3.0}, {-4.0, 3.0, 0.0}, {9.5, 7.0, 0.0}}) {
    EXPECT_EQ(interpret(program, std::vector<double>{at}).at(0), value) << at;
    const std::vector<double> both = values_at(slope, {at}, {1});
    EXPECT_EQ(both.at(0), value) << at;
    EXPECT_EQ(both.at(1), rise) << at;
  }
  EXPECT_TRUE(std::isnan(interpret(program, std::vector<double>{std::nan("")}).at(0)));
  const Program dead = remove_dead_values(program);
  EXPECT_EQ(interpret(dead, std::vector<double>{0.25}).at(0), 3.5);
}

TEST(Derivative, OfEachOperationIsItsClosedForm) {
  struct Case {
    const char* name;
    Function function;
    double by_x, by_y;
  };
  const double x = 0.3, y = 0.7;
  const std::vector<Case> cases = {
      {"add", [](const Expr& a, const Expr& b) { return a + b; }, 1, 1},
      {"sub", [](const Expr& a, const Expr& b) { return a - b; }, 1, -1},
      {"mul", [](const Expr& a, const Expr& b) { return a * b; }, y, x},
      {"square", [](const Expr& a, const Expr&) { return a * a; }, 2 * x, 0},
      {"div", [](const Expr& a, const Expr& b) { return a / b; }, 1 / y, -x / (y * y)},
      {"neg", [](const Expr& a, const Expr&) { return -a; }, -1, 0},
      {"sqrt", [](const Expr& a, const Expr&) { return sqrt(a); }, 0.5 / std::sqrt(x), 0},
      {"sin", [](const Expr& a, const Expr&) { return sin(a); }, std::cos(x), 0},
      {"cos", [](const Expr& a, const Expr&) { return cos(a); }, -std::sin(x), 0},
      {"tan", [](const Expr& a, const Expr&) { return tan(a); }, 1 / (std::cos(x) * std::cos(x)), 0},
      {"asin", [](const Expr& a, const Expr&) { return asin(a); }, 1 / std::sqrt(1 - x * x), 0},
      {"acos", [](const Expr& a, const Expr&) { return acos(a); }, -1 / std::sqrt(1 - x * x), 0},
      {"atan", [](const Expr& a, const Expr&) { return atan(a); }, 1 / (1 + x * x), 0},
      {"atan2", [](const Expr& a, const Expr& b) { return atan2(a, b); }, y / (x * x + y * y), -x / (x * x + y * y)},
      {"exp", [](const Expr& a, const Expr&) { return exp(a); }, std::exp(x), 0},
      {"log", [](const Expr& a, const Expr&) { return log(a); }, 1 / x, 0},
      {"tanh", [](const Expr& a, const Expr&) { return tanh(a); }, 1 / (std::cosh(x) * std::cosh(x)), 0},
      {"pow", [](const Expr& a, const Expr& b) { return pow(a, b); }, y * std::pow(x, y - 1),
       std::pow(x, y) * std::log(x)},
      {"cube", [](const Expr& a, const Expr&) { return pow(a, 3); }, 3 * x * x, 0},
      {"exponential", [](const Expr&, const Expr& b) { return pow(2, b); }, 0, std::pow(2, y) * std::log(2)},
      {"abs", [](const Expr& a, const Expr& b) { return abs(a - b); }, -1, 1},
      {"min", [](const Expr& a, const Expr& b) { return min(a, b); }, 1, 0},
      {"min, exchanged", [](const Expr& a, const Expr& b) { return min(b, 2 * a); }, 2, 0},
      {"max", [](const Expr& a, const Expr& b) { return max(a, b); }, 0, 1},
      {"select, first", [](const Expr& a, const Expr& b) { return select(b - a, a * a, b); }, 2 * x, 0},
      {"select, second", [](const Expr& a, const Expr& b) { return select(a - b, a * a, 3 * b); }, 0, 3},
  };
  for (const Case& c : cases) {
    const std::vector<double> slopes = slopes_at(c.function, x, y);
    const double by_x = slopes.at(0), by_y = slopes.at(1);
    // A few roundings of each closed form; no difference quotient is involved.
    EXPECT_NEAR(by_x, c.by_x, 1e-15 * (1 + std::abs(c.by_x))) << c.name;
    EXPECT_NEAR(by_y, c.by_y, 1e-15 * (1 + std::abs(c.by_y))) << c.name;
  }
}

TEST(Derivative, OfAPowerIsSoundWhereTheLogarithmIsNot) {
  const Function cube = [](const Expr& a, const Expr&) { return pow(a, 3); };
  EXPECT_EQ(slopes_at(cube, 0, 0)[0], 0);
  EXPECT_EQ(slopes_at(cube, -2, 0)[0], 12);
}

TEST(Derivative, AppliedTwiceGivesSecondDerivatives) {
  // f = x^3 y: f_xy = 3 x^2, with both applications seeded apart: seed[0] = dx, seed[1] = dy.
  const Program program = program_of([](const Expr& x, const Expr& y) { return x * x * x * y; });
  const Program first = differentiate(program, std::vector<int>{0, -1});
  ASSERT_EQ(first.inputs.size(), 3u);
  const Program second = differentiate(first, std::vector<int>{-1, 1, -1});
  ASSERT_EQ(second.outputs.size(), 3u);
  EXPECT_EQ(second.outputs[1].slot, (Slot{derivative_of(Array::y), 0}));
  EXPECT_EQ(second.outputs[2].slot, (Slot{derivative_of(derivative_of(Array::y)), 0}));
  const std::vector<double> values = values_at(second, {2, 5}, {1, 1});
  EXPECT_EQ(values[0], 40);
  EXPECT_EQ(values[1], 60);
  EXPECT_EQ(values[2], 12);
}

TEST(Derivative, TextIsTheProgramItsSeedsAndTheirProducts) {
  ProgramBuilder builder("f");
  const Expr z(builder, builder.input(Array::z, 0)), t(builder, builder.input(Array::t, 0));
  builder.set_section({Step::inertias});
  builder.output(Array::y, 0, (sin(z) + t).value(builder));
  EXPECT_EQ(dump(differentiate(builder.finish(), std::vector<int>{0, -1})),
            "program f\n"
            "%0 = input t[0]\n"
            "%1 = input z[0]\n"
            "; section step 1\n"
            "%2 = sin %1\n"
            "%3 = input seed[0]\n"
            "%4 = add %0 %2\n"
            "%5 = cos %1\n"
            "%6 = mul %3 %5\n"
            "out y[0] = %4\n"
            "out d_y[0] = %6\n");
}

TEST(Derivative, SharesThePrimalValuesAndKeepsStructuralZeros) {
  ProgramBuilder builder("f");
  const Expr a(builder, builder.input(Array::z, 0)), b(builder, builder.input(Array::z, 2));
  builder.output(Array::y, 0, (sin(a) * b).value(builder));
  builder.output(Array::y, 1, (b * 2.0).value(builder));
  EXPECT_EQ(dump(optimise(differentiate(builder.finish(), std::vector<int>{0, -1}))),
            "program f\n"
            "%0 = input z[0]\n"
            "%1 = input z[2]\n"
            "%2 = sin %0\n"
            "%3 = constant 2\n"
            "%4 = mul %1 %2\n"
            "%5 = input seed[0]\n"
            "%6 = mul %3 %1\n"
            "%7 = cos %0\n"
            "%8 = mul %5 %7\n"
            "%9 = mul %1 %8\n"
            "%10 = constant 0\n"
            "out y[0] = %4\n"
            "out y[1] = %6\n"
            "out d_y[0] = %9\n"
            "out d_y[1] = %10\n");
}

TEST(Builder, CostGrowsLinearly) {
  // A chain: each value depends on the one before, nothing is shared. Well under a second in release; ten times that
  // allowed.
  const auto start = std::chrono::steady_clock::now();
  ProgramBuilder builder("chain");
  const Expr x(builder, builder.input(Array::x, 0));
  Expr sum = x;
  for (int i = 0; i < 30000; ++i) sum = sin(sum) * x + static_cast<double>(i);
  builder.output(Array::y, 0, sum.value(builder));
  const Program program = builder.finish();
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  EXPECT_GT(program.nodes.size(), 90000u);
  EXPECT_LT(seconds.count(), 10);
  EXPECT_EQ(count_operations(optimise(program)).add, 29999);
}

}  // namespace
}  // namespace mbgen
