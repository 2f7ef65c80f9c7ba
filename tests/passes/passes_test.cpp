// Passes: the exact text that each makes of a small program, and the values of random programs, which none may change.

#include "compiler/passes/passes.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "compiler/program/program.hpp"
#include "tests/support/random_program.hpp"

namespace mbgen {
namespace {

TEST(PassText, DeadValuesAndInputsGo) {
  ProgramBuilder builder("f");
  const Expr unused(builder, builder.input(Array::z, 0)), x(builder, builder.input(Array::z, 1));
  builder.set_section({Step::forces});
  builder.set_owner({OwnerKind::tree_body, 0});
  const Expr s = sin(x), c = cos(x) * unused;
  builder.label(s.value(builder), "s_arm");
  builder.label(c.value(builder), "c_arm");
  builder.output(Array::y, 0, s.value(builder));
  const Program program = remove_dead_values(builder.finish());
  EXPECT_EQ(dump(program),
            "program f\n"
            "%0 = input z[1]\n"
            "; section step 5\n"
            "; owner tree_body 0\n"
            "%1 = sin %0  ; s_arm\n"
            "out y[0] = %1\n");
  EXPECT_EQ(program.inputs, (std::vector<Slot>{{Array::z, 1}}));
  EXPECT_EQ(program.labels, (std::vector<std::string>{"s_arm", "c_arm"}));
}

/// Outputs y[i] = x[i] / divisor, each in its own section.
Program divisions(int count, const std::function<Expr(ProgramBuilder&)>& divisor) {
  ProgramBuilder builder("f");
  const Expr d = divisor(builder);
  for (int i = 0; i < count; ++i) {
    builder.set_section({Step::forces, i});
    const Expr quotient = Expr(builder, builder.input(Array::x, i)) / d;
    builder.label(quotient.value(builder), fmt::format("q{}", i));
    builder.output(Array::y, i, quotient.value(builder));
  }
  return builder.finish();
}

TEST(PassText, ThreeDivisionsByOneValueShareAReciprocal) {
  const auto input = [](ProgramBuilder& builder) { return Expr(builder, builder.input(Array::in, 0)); };
  EXPECT_EQ(dump(merge_divisions(divisions(3, input))),
            "program f\n"
            "%0 = input in[0]\n"
            "%1 = input x[0]\n"
            "%2 = constant 1\n"
            "; section step 5, block 0\n"
            "%3 = div %2 %0\n"
            "%4 = mul %1 %3  ; q0\n"
            "%5 = input x[1]\n"
            "; section step 5, block 1\n"
            "%6 = mul %3 %5  ; q1\n"
            "%7 = input x[2]\n"
            "; section step 5, block 2\n"
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
  const auto x = [&](int i) { return Expr(builder, builder.input(Array::x, i)); };
  const Expr kept = x(0) * x(0), named = x(1) * x(1), shared = x(0) * x(3);
  builder.label(named.value(builder), "named");
  const auto output = [&](int i, const Expr& value) { builder.output(Array::y, i, value.value(builder)); };
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
  const Program program =
      divisions(4, [](ProgramBuilder& builder) { return Expr(builder, builder.input(Array::in, 0)); });
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
      optimise(divisions(5, [](ProgramBuilder& builder) { return sqrt(Expr(builder, builder.input(Array::in, 0))); }));
  EXPECT_EQ(dump(optimise(once)), dump(once));
}

TEST(Passes, KeepTheValuesOfRandomPrograms) {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    const Program program = random_program(seed, 300), lean = remove_dead_values(program), best = optimise(program);
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> unit(-1, 1);
    std::vector<double> given(6);
    for (double& value : given) value = unit(random);
    const auto run = [&](const Program& p) {
      std::vector<double> inputs;
      for (const Slot& slot : p.inputs) inputs.push_back(given[slot.index]);
      return interpret(p, inputs);
    };
    EXPECT_EQ(run(lean), run(program));
    EXPECT_LE(lean.nodes.size(), program.nodes.size());
    const std::vector<double> expected = run(program), actual = run(best);
    for (std::size_t i = 0; i < expected.size(); ++i)
      EXPECT_NEAR(actual[i], expected[i], 1e-12 * (1 + std::abs(expected[i])));
  }
}

TEST(Passes, ManyDivisionsByOneValueBecomeOneReciprocal) {
  const auto divided = [](int count) {
    ProgramBuilder builder("f");
    const Expr divisor(builder, builder.input(Array::in, 0));
    for (int i = 0; i < count; ++i) {
      const Expr x(builder, builder.input(Array::in, i + 1));
      builder.output(Array::y, i, (x / divisor).value(builder));
    }
    return count_operations(optimise(builder.finish()));
  };
  EXPECT_EQ(divided(2).divide, 2);
  EXPECT_EQ(divided(3).divide, 1);
  EXPECT_EQ(divided(3).multiply, 3);
}

}  // namespace
}  // namespace mbgen
