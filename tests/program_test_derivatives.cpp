// Derivatives of every operation against closed forms, second application, and the exact text of passes.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <string>
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
    inputs.push_back((slot.group == "seed" ? seeds : x).at(static_cast<std::size_t>(slot.index)));
  }
  return interpret(program, inputs);
}

using Function = std::function<Expr(const Expr& x, const Expr& y)>;

Program program_of(const Function& function) {
  ProgramBuilder builder("f");
  const Expr x(builder, builder.input("x", 0)), y(builder, builder.input("x", 1));
  builder.output("y", 0, function(x, y).value(builder));
  return builder.finish();
}

/// Both slopes by forward differentiation.
std::vector<double> slopes_at(const Function& function, double x, double y) {
  return values_at(jacobian(program_of(function), "y", "x"), {x, y});
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
  EXPECT_EQ(second.outputs[1].slot, (Slot{"d_y", 0}));
  EXPECT_EQ(second.outputs[2].slot, (Slot{"d_d_y", 0}));
  const std::vector<double> values = values_at(second, {2, 5}, {1, 1});
  EXPECT_EQ(values[0], 40);
  EXPECT_EQ(values[1], 60);
  EXPECT_EQ(values[2], 12);
}

TEST(Derivative, TextIsTheProgramItsSeedsAndTheirProducts) {
  ProgramBuilder builder("f");
  const Expr z(builder, builder.input("z", 0)), t(builder, builder.input("t", 0));
  builder.set_section("positions");
  builder.output("y", 0, (sin(z) + t).value(builder));
  EXPECT_EQ(dump(differentiate(builder.finish(), std::vector<int>{0, -1})),
            "program f\n"
            "%0 = input t[0]\n"
            "%1 = input z[0]\n"
            "; section positions\n"
            "%2 = sin %1\n"
            "%3 = input seed[0]\n"
            "%4 = add %0 %2\n"
            "%5 = cos %1\n"
            "%6 = mul %3 %5\n"
            "out y[0] = %4\n"
            "out d_y[0] = %6\n");
}

TEST(Jacobian, SharesThePrimalValuesAndKeepsStructuralZeros) {
  ProgramBuilder builder("f");
  const Expr a(builder, builder.input("z", 0)), b(builder, builder.input("z", 2));
  builder.output("y", 0, (sin(a) * b).value(builder));
  builder.output("y", 1, (b * 2.0).value(builder));
  builder.output("other", 0, a.value(builder));
  EXPECT_EQ(dump(optimise(jacobian(builder.finish(), "y", "z"))),
            "program f\n"
            "%0 = input z[0]\n"
            "%1 = input z[2]\n"
            "%2 = sin %0\n"
            "%3 = constant 2\n"
            "%4 = cos %0\n"
            "%5 = mul %1 %4\n"
            "%6 = constant 0\n"
            "out d_y_d_z[0] = %5\n"
            "out d_y_d_z[3] = %6\n"
            "out d_y_d_z[1] = %6\n"
            "out d_y_d_z[4] = %6\n"
            "out d_y_d_z[2] = %2\n"
            "out d_y_d_z[5] = %3\n");
}

TEST(PassText, DeadValuesAndInputsGo) {
  ProgramBuilder builder("f");
  const Expr unused(builder, builder.input("z", 0)), x(builder, builder.input("z", 1));
  builder.set_section("only");
  builder.set_block("arm");
  const Expr s = sin(x), c = cos(x) * unused;
  builder.label(s.value(builder), "s_arm");
  builder.label(c.value(builder), "c_arm");
  builder.output("y", 0, s.value(builder));
  const Program program = remove_dead_values(builder.finish());
  EXPECT_EQ(dump(program),
            "program f\n"
            "%0 = input z[1]\n"
            "; section only\n"
            "; block arm\n"
            "%1 = sin %0  ; s_arm\n"
            "out y[0] = %1\n");
  EXPECT_EQ(program.inputs, (std::vector<Slot>{{"z", 1}}));
  EXPECT_EQ(program.labels, (std::vector<std::string>{"s_arm", "c_arm"}));
}

/// Outputs y[i] = x[i] / divisor, each in its own section.
Program divisions(int count, const std::function<Expr(ProgramBuilder&)>& divisor) {
  ProgramBuilder builder("f");
  const Expr d = divisor(builder);
  for (int i = 0; i < count; ++i) {
    builder.set_section(fmt::format("step {}", i));
    const Expr quotient = Expr(builder, builder.input("x", i)) / d;
    builder.label(quotient.value(builder), fmt::format("q{}", i));
    builder.output("y", i, quotient.value(builder));
  }
  return builder.finish();
}

TEST(PassText, ThreeDivisionsByOneValueShareAReciprocal) {
  const auto input = [](ProgramBuilder& builder) { return Expr(builder, builder.input("d", 0)); };
  EXPECT_EQ(dump(merge_divisions(divisions(3, input))),
            "program f\n"
            "%0 = input d[0]\n"
            "%1 = input x[0]\n"
            "%2 = constant 1\n"
            "; section step 0\n"
            "%3 = div %2 %0\n"
            "%4 = mul %1 %3  ; q0\n"
            "%5 = input x[1]\n"
            "; section step 1\n"
            "%6 = mul %3 %5  ; q1\n"
            "%7 = input x[2]\n"
            "; section step 2\n"
            "%8 = mul %3 %7  ; q2\n"
            "out y[0] = %4\n"
            "out y[1] = %6\n"
            "out y[2] = %8\n");
  EXPECT_EQ(dump(merge_divisions(divisions(2, input))), dump(divisions(2, input)));
  const auto three = [](ProgramBuilder&) { return Expr(3.0); };
  EXPECT_EQ(count_operations(optimise(divisions(3, three))).divide, 0);
}

TEST(PassText, ProductsThatOnlySumsNeedGoIntoThem) {
  ProgramBuilder builder("f");
  const auto x = [&](int i) { return Expr(builder, builder.input("x", i)); };
  const Expr kept = x(0) * x(0), named = x(1) * x(1), shared = x(0) * x(3);
  builder.label(named.value(builder), "named");
  const auto output = [&](int i, const Expr& value) { builder.output("y", i, value.value(builder)); };
  output(0, x(0) * x(1) + x(1));
  output(1, x(0) * x(2) - x(1));
  output(2, x(1) - x(2) * x(2));
  const Expr earlier = 2.0 * x(0), later = 3.0 * x(1);
  output(3, earlier + later);
  output(4, kept + x(1));
  output(5, sqrt(kept) - named);
  output(6, shared + x(1));
  output(7, x(2) - shared);
  EXPECT_EQ(dump(contract(builder.finish())),
            "program f\n"
            "%0 = input x[0]\n"
            "%1 = mul %0 %0\n"
            "%2 = input x[1]\n"
            "%3 = mul %2 %2  ; named\n"
            "%4 = input x[3]\n"
            "%5 = muladd %0 %2 %2\n"
            "%6 = input x[2]\n"
            "%7 = mulsub %0 %6 %2\n"
            "%8 = submul %2 %6 %6\n"
            "%9 = constant 2\n"
            "%10 = mul %9 %0\n"
            "%11 = constant 3\n"
            "%12 = muladd %11 %2 %10\n"
            "%13 = add %1 %2\n"
            "%14 = sqrt %1\n"
            "%15 = sub %14 %3\n"
            "%16 = muladd %0 %4 %2\n"
            "%17 = submul %6 %0 %4\n"
            "out y[0] = %5\n"
            "out y[1] = %7\n"
            "out y[2] = %8\n"
            "out y[3] = %12\n"
            "out y[4] = %13\n"
            "out y[5] = %15\n"
            "out y[6] = %16\n"
            "out y[7] = %17\n");
}

TEST(Passes, MergedQuotientsAreWithinTheStatedRounding) {
  const Program program = divisions(4, [](ProgramBuilder& builder) { return Expr(builder, builder.input("d", 0)); });
  const Program merged = optimise(program);
  ASSERT_EQ(merged.inputs, program.inputs);
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> mantissa(-2, 2), exponent(-100, 100);
  for (int trial = 0; trial < 10000; ++trial) {
    std::vector<double> inputs(program.inputs.size());
    for (double& value : inputs) value = mantissa(random) * std::pow(10, exponent(random));
    const std::vector<double> expected = interpret(program, inputs), actual = interpret(merged, inputs);
    for (std::size_t i = 0; i < expected.size(); ++i) {
      // Half a unit each for the reciprocal and the product, half for the quotient itself: 1.5 * 2^-52.
      const double tolerance = 1.5 * std::numeric_limits<double>::epsilon() * std::abs(expected[i]);
      ASSERT_LE(std::abs(actual[i] - expected[i]), tolerance);
    }
  }
}

TEST(Passes, RewritingAProgramOnceMoreChangesNothing) {
  const Program once =
      optimise(divisions(5, [](ProgramBuilder& builder) { return sqrt(Expr(builder, builder.input("d", 0))); }));
  EXPECT_EQ(dump(optimise(once)), dump(once));
}

TEST(Builder, CostGrowsLinearly) {
  // A chain: each value depends on the one before, nothing is shared. Well under a second in release; ten times that
  // allowed.
  const auto start = std::chrono::steady_clock::now();
  ProgramBuilder builder("chain");
  const Expr x(builder, builder.input("x", 0));
  Expr sum = x;
  for (int i = 0; i < 100000; ++i) sum = sin(sum) * x + static_cast<double>(i);
  builder.output("y", 0, sum.value(builder));
  const Program program = builder.finish();
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  EXPECT_GT(program.nodes.size(), 300000u);
  EXPECT_LT(seconds.count(), 10);
  EXPECT_EQ(count_operations(optimise(program)).add, 99999);
}

}  // namespace
}  // namespace mbgen
