// The symbolic program: rules while appending, invariants, interpretation, counts, derivatives.

#include "compiler/program/program.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <functional>
#include <random>
#include <vector>

#include "compiler/passes/passes.hpp"
#include "tests/support/random_program.hpp"

namespace mbgen {
namespace {

using MakeOfTwo = std::function<Expr(const Expr& x, const Expr& y)>;

/// The program of one output y[0] = f(x, y), dead values gone.
Program program_made(const MakeOfTwo& make) {
  ProgramBuilder builder("f");
  const Expr x(builder, builder.input(Array::in, 0)), y(builder, builder.input(Array::in, 1));
  builder.output(Array::y, 0, make(x, y).value(builder));
  return remove_dead_values(builder.finish());
}

/// Its text without the first line.
std::string text_made(const MakeOfTwo& make) {
  const std::string text = dump(program_made(make));
  return text.substr(text.find('\n') + 1);
}

double value_of(const Program& program, double x, double y) {
  std::vector<double> inputs;
  for (const Slot& slot : program.inputs) inputs.push_back(slot.index == 0 ? x : y);
  return interpret(program, inputs)[0];
}

/// Each rule: what is written on the left becomes the program of the right.
TEST(Rules, OneDirectionEach) {
  const MakeOfTwo same_x = [](const Expr& x, const Expr&) { return x; };
  const MakeOfTwo minus_x = [](const Expr& x, const Expr&) { return -x; };
  const std::vector<std::pair<MakeOfTwo, MakeOfTwo>> rules = {
      {[](const Expr& x, const Expr&) { return x + 0.0; }, same_x},
      {[](const Expr& x, const Expr&) { return Expr(0.0) + x; }, same_x},
      {[](const Expr& x, const Expr&) { return x - 0.0; }, same_x},
      {[](const Expr& x, const Expr&) { return x * 1.0; }, same_x},
      {[](const Expr& x, const Expr&) { return x / 1.0; }, same_x},
      {[](const Expr& x, const Expr&) { return -(-x); }, same_x},
      {[](const Expr& x, const Expr&) { return x * -1.0; }, minus_x},
      {[](const Expr& x, const Expr&) { return x / -1.0; }, minus_x},
      {[](const Expr& x, const Expr&) { return Expr(0.0) - x; }, minus_x},
      {[](const Expr& x, const Expr&) { return x * 0.0; }, [](const Expr&, const Expr&) { return Expr(0.0); }},
      {[](const Expr& x, const Expr&) { return Expr(0.0) / x; }, [](const Expr&, const Expr&) { return Expr(0.0); }},
      {[](const Expr& x, const Expr&) { return x - x; }, [](const Expr&, const Expr&) { return Expr(0.0); }},
      {[](const Expr& x, const Expr& y) { return x + (-y); }, [](const Expr& x, const Expr& y) { return x - y; }},
      {[](const Expr& x, const Expr& y) { return x - (-y); }, [](const Expr& x, const Expr& y) { return x + y; }},
      {[](const Expr& x, const Expr& y) { return (-x) + y; }, [](const Expr& x, const Expr& y) { return y - x; }},
      {[](const Expr& x, const Expr& y) { return (-x) * (-y); }, [](const Expr& x, const Expr& y) { return x * y; }},
      {[](const Expr& x, const Expr& y) { return (-x) * y; }, [](const Expr& x, const Expr& y) { return -(x * y); }},
      {[](const Expr& x, const Expr& y) { return (-x) / y; }, [](const Expr& x, const Expr& y) { return -(x / y); }},
      {[](const Expr& x, const Expr& y) { return (-x) - y; }, [](const Expr& x, const Expr& y) { return -(x + y); }},
      {[](const Expr& x, const Expr& y) { return y + x; }, [](const Expr& x, const Expr& y) { return x + y; }},
      {[](const Expr& x, const Expr& y) { return y * x; }, [](const Expr& x, const Expr& y) { return x * y; }},
      {[](const Expr& x, const Expr&) { return x / 4.0; }, [](const Expr& x, const Expr&) { return x * 0.25; }},
      {[](const Expr& x, const Expr&) { return sin(-x); }, [](const Expr& x, const Expr&) { return -sin(x); }},
      {[](const Expr& x, const Expr&) { return cos(-x); }, [](const Expr& x, const Expr&) { return cos(x); }},
      {[](const Expr& x, const Expr&) { return abs(-x); }, [](const Expr& x, const Expr&) { return abs(x); }},
      {[](const Expr& x, const Expr& y) { return select(Expr(1.0), x, y); }, same_x},
      {[](const Expr& x, const Expr& y) { return select(Expr(-1.0), y, x); }, same_x},
      {[](const Expr& x, const Expr& y) { return select(y, x, x); }, same_x}};
  for (std::size_t r = 0; r < rules.size(); ++r)
    EXPECT_EQ(text_made(rules[r].first), text_made(rules[r].second)) << "rule " << r;
}

TEST(Rules, DivisionByThreeStays) {
  EXPECT_NE(text_made([](const Expr& x, const Expr&) { return x / 3.0; }),
            text_made([](const Expr& x, const Expr&) { return x * (1.0 / 3.0); }));
}

TEST(Rules, WhatWouldNotBeFiniteIsNotFolded) {
  ProgramBuilder builder("f");
  const ValueId zero = builder.constant(0), one = builder.constant(1);
  EXPECT_EQ(builder.node(builder.append(Op::divide, one, zero)).op, Op::divide);
  EXPECT_EQ(builder.node(builder.append(Op::log, builder.constant(-1))).op, Op::log);
}

TEST(Rules, ConstantsThatAreNotFiniteAreComputedWhereTheyAreUsed) {
  // Expr folds 1/0 like double; a program, whose constants are finite, recomputes it.
  for (const Expr& value : {Expr(1.0) / Expr(0.0), Expr(-1.0) / Expr(0.0), Expr(0.0) / Expr(0.0)}) {
    ProgramBuilder builder("f");
    builder.output(Array::y, 0, (Expr(builder, builder.input(Array::x, 0)) + value).value(builder));
    const double result = interpret(builder.finish(), std::vector<double>{1})[0];
    EXPECT_TRUE(result == value.constant() || (std::isnan(result) && std::isnan(value.constant()))) << result;
  }
}

TEST(Interpretation, OfSetsSideBySideHasTheBitsOfOneAfterAnother) {
  ProgramBuilder builder("f");
  const Expr x(builder, builder.input(Array::in, 0)), y(builder, builder.input(Array::in, 1)),
      same(builder, builder.input(Array::in, 2));
  const Expr fixed = sin(same) / (same - 3.0);
  builder.output(Array::y, 0, (select(x - y, fixed * x, -y) + sqrt(abs(x * y)) - fixed).value(builder));
  builder.output(Array::y, 1, fixed.value(builder));
  builder.output(Array::y, 2, (atan2(x, same) + max(y, cos(x))).value(builder));
  const Program program = builder.finish();
  constexpr std::size_t kSets = 19;  // two rows of lanes, and a third that is not full
  std::vector<double> all;
  const auto at = [](std::size_t input, std::size_t set) {
    if (input == 2) return 0.7;
    return set == 11 ? std::nan("") : std::sin(1.0 + 7.0 * static_cast<double>(input) + static_cast<double>(set));
  };
  for (std::size_t i = 0; i < program.inputs.size(); ++i)
    for (std::size_t k = 0; k < kSets; ++k) all.push_back(at(static_cast<std::size_t>(program.inputs[i].index), k));
  const std::vector<double> found = interpret(program, all, kSets);
  for (std::size_t k = 0; k < kSets; ++k) {
    std::vector<double> one;
    for (const Slot& slot : program.inputs) one.push_back(at(static_cast<std::size_t>(slot.index), k));
    const std::vector<double> expected = interpret(program, one);
    for (std::size_t o = 0; o < expected.size(); ++o) {
      const double value = found[o * kSets + k];
      const bool is_same = std::isnan(expected[o])
                               ? std::isnan(value)
                               : std::bit_cast<std::uint64_t>(value) == std::bit_cast<std::uint64_t>(expected[o]);
      EXPECT_TRUE(is_same) << "set " << k << ", output " << o;
    }
  }
  EXPECT_THROW(interpret(program, std::vector<double>(5), 2), std::invalid_argument);
}

TEST(Builder, SharesEqualValuesAndNamesTheFirst) {
  ProgramBuilder builder("f");
  const Expr x(builder, builder.input(Array::in, 0));
  const Expr a = sin(x) * x, b = x * sin(x);
  EXPECT_EQ(a.value(builder), b.value(builder));
  builder.label(a.value(builder), "first");
  builder.label(b.value(builder), "second");
  builder.output(Array::y, 0, b.value(builder));
  EXPECT_EQ(dump(builder.finish()),
            "program f\n"
            "%0 = input in[0]\n"
            "%1 = sin %0\n"
            "%2 = mul %0 %1  ; first\n"
            "out y[0] = %2\n");
}

TEST(Verify, NamesEachBrokenInvariant) {
  const Program sound = program_made([](const Expr& x, const Expr& y) { return sin(x) * y; });
  EXPECT_EQ(verify(sound), "");
  const auto broken = [&](const std::function<void(Program&)>& damage) {
    Program program = sound;
    damage(program);
    return verify(program);
  };
  EXPECT_NE(broken([](Program& p) { p.nodes.back().operands[0] = static_cast<ValueId>(p.nodes.size() - 1); }), "");
  EXPECT_NE(broken([](Program& p) { p.nodes.back().operands[1] = kNoValue; }), "");
  EXPECT_NE(broken([](Program& p) { p.nodes[0].operands[0] = 0; }), "");
  EXPECT_NE(broken([](Program& p) { p.nodes[0].input = 7; }), "");
  EXPECT_NE(broken([](Program& p) { p.nodes.back().section = {Step::solution}; }), "");
  EXPECT_NE(broken([](Program& p) { p.nodes.back().label = 9; }), "");
  EXPECT_NE(broken([](Program& p) { p.outputs[0].value = 99; }), "");
  EXPECT_NE(broken([](Program& p) { p.outputs.push_back(p.outputs[0]); }), "");
  EXPECT_NE(broken([](Program& p) { p.inputs[1] = p.inputs[0]; }), "");
}

TEST(Count, LooksAtLiveValuesBySection) {
  ProgramBuilder builder("f");
  const Expr x(builder, builder.input(Array::in, 0));
  builder.set_section({Step::inertias});
  const Expr a = sin(x) + x;
  builder.set_section({Step::jacobian});
  const Expr b = sqrt(a * a) / x;
  cos(b);  // needed by nobody
  builder.output(Array::y, 0, (-b).value(builder));
  const Program program = builder.finish();
  const OperationCount total = count_operations(program);
  EXPECT_EQ(total.total(), 3);
  EXPECT_EQ(total.trigonometric, 1);
  EXPECT_EQ(total.sqrt, 1);
  const std::vector<OperationCount> sections = count_operations_by_section(program);
  ASSERT_EQ(sections.size(), 3u);
  EXPECT_EQ(sections[1].add, 1);
  EXPECT_EQ(sections[2].multiply + sections[2].divide, 2);
}

/// Smooth functions of two variables, each operation in turn.
const std::vector<MakeOfTwo>& smooth_functions() {
  static const std::vector<MakeOfTwo> functions = {
      [](const Expr& x, const Expr& y) { return x * y + x / y - y; },
      [](const Expr& x, const Expr& y) { return sqrt(x * x + y * y); },
      [](const Expr& x, const Expr& y) { return sin(x * y) * cos(x - y); },
      [](const Expr& x, const Expr& y) { return tan(x * 0.3) + asin(x * 0.2) + acos(y * 0.2); },
      [](const Expr& x, const Expr& y) { return atan(x * y) + atan2(x, y); },
      [](const Expr& x, const Expr& y) { return exp(x * 0.5) * log(y + 3.0) * tanh(x); },
      [](const Expr& x, const Expr& y) { return pow(x + 2.0, y) + pow(y, Expr(3.0)) + pow(x + 2.0, Expr(-1.5)); },
      [](const Expr& x, const Expr& y) { return abs(x) * y + min(x, y) * max(x * x, y) + select(x - y, x * y, -y); }};
  return functions;
}

TEST(Program, HasAsManyOwnersAsAModelHasParts) {
  ProgramBuilder builder("p");
  Expr x(builder, builder.input(Array::z, 0));
  constexpr int kMany = 70000;
  for (int i = 0; i < kMany; ++i) {
    builder.set_section({Step::outputs, i});
    builder.set_owner({OwnerKind::output, i});
    x = sin(x);
  }
  builder.output(Array::y, 0, x.value(builder));
  const Program program = builder.finish();
  EXPECT_EQ(program.nodes.back().owner, (Owner{OwnerKind::output, kMany - 1}));
  EXPECT_EQ(program.sections.size(), kMany + 1u);
}

TEST(Derivative, EqualsCentralDifferences) {
  for (std::size_t f = 0; f < smooth_functions().size(); ++f) {
    const Program program = program_made(smooth_functions()[f]);
    const Program slopes = differentiate(program, std::vector<int>{0, 1});
    std::mt19937_64 random(f);
    std::uniform_real_distribution<double> at(0.4, 1.4);
    for (int trial = 0; trial < 10; ++trial) {
      const double x = at(random), y = at(random), h = 1e-6;
      const double dx = (value_of(program, x + h, y) - value_of(program, x - h, y)) / (2 * h);
      const double dy = (value_of(program, x, y + h) - value_of(program, x, y - h)) / (2 * h);
      const auto along = [&](double seed_x, double seed_y) {
        std::vector<double> inputs;
        for (const Slot& slot : slopes.inputs) {
          const bool is_first = slot.index == 0;
          inputs.push_back(slot.group == Array::seed ? (is_first ? seed_x : seed_y) : (is_first ? x : y));
        }
        return interpret(slopes, inputs).at(1);
      };
      EXPECT_NEAR(along(1, 0), dx, 1e-8 * (1 + std::abs(dx))) << "function " << f;
      EXPECT_NEAR(along(0, 1), dy, 1e-8 * (1 + std::abs(dy))) << "function " << f;
    }
  }
}

TEST(Derivative, FollowsASeedAndVanishesWhereThereIsNone) {
  const Program program = program_made([](const Expr& x, const Expr& y) { return x * x + y; });
  const std::vector<int> only_x = {0, -1};
  const Program slopes = differentiate(program, only_x);
  std::vector<double> inputs;
  for (const Slot& slot : slopes.inputs)
    inputs.push_back(slot.group == Array::seed ? 2.0 : slot.index == 0 ? 3.0 : 5.0);
  const std::vector<double> values = interpret(slopes, inputs);
  ASSERT_EQ(values.size(), 2u);
  EXPECT_EQ(values[0], 14);
  EXPECT_EQ(values[1], 12);  // 2 x dx
}

TEST(Builder, AppendsAHundredThousandValuesQuicklyAndSoundly) {
  const Program program = random_program(99, 100000);
  EXPECT_GT(program.nodes.size(), 50000u);
  EXPECT_EQ(verify(program), "");
}

}  // namespace
}  // namespace mbgen
