// A program and its derivatives in two programs, against the derivatives in one.

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "compiler/passes/passes.hpp"
#include "compiler/program/program.hpp"
#include "tests/support/random_program.hpp"
#include "tests/support/slot_numbers.hpp"

namespace mbgen {
namespace {

using Numbers = SlotNumbers;

constexpr auto kAll = [](const Slot&) { return true; };

/// Outputs and their derivatives; derivatives that `along` does not give are 0.
Numbers apart_at(const Program& program, const Numbers& at, const Numbers& rates, double slope_cost = 1) {
  const DerivativesApart apart = take_derivatives_apart(program, kAll, kAll, slope_cost);
  Numbers values = outputs_at(apart.values, at), given = at;
  for (const auto& [slot, value] : values)
    if (slot.group == SlotGroup(Array::slope)) given[slot] = value;
  for (const auto& [slot, rate] : rates) given[{derivative_of(slot.group), slot.index}] = rate;
  for (const auto& [slot, value] : outputs_at(apart.along, given)) values[slot] = value;
  return values;
}

/// The same by the derivatives in one program.
Numbers together_at(const Program& program, const Numbers& at, const Numbers& rates) {
  std::vector<int> seeds;
  Numbers given = at;
  for (const Slot& slot : program.inputs) {
    given[{Array::seed, static_cast<int>(seeds.size())}] = rates.at(slot);
    seeds.push_back(static_cast<int>(seeds.size()));
  }
  return outputs_at(differentiate(program, seeds), given);
}

void expect_same(const Program& program, const Numbers& at, const Numbers& rates, const std::string& what) {
  const Numbers together = together_at(unfolded(program), at, rates);
  for (const double slope_cost : {0.0, 0.4, 1.0}) {
    const Numbers apart = apart_at(program, at, rates, slope_cost);
    for (const auto& [slot, expected] : together) {
      const auto found = apart.find(slot);
      const double actual = found == apart.end() ? 0 : found->second;
      EXPECT_NEAR(actual, expected, 1e-12 * (1 + std::abs(expected))) << what << ", " << text_of(slot);
    }
  }
}

Program program_of(const std::function<Expr(const Expr&, const Expr&)>& function) {
  ProgramBuilder builder("f");
  const Expr x(builder, builder.input(Array::x, 0)), y(builder, builder.input(Array::x, 1));
  builder.output(Array::y, 0, function(x, y).value(builder));
  return builder.finish();
}

TEST(DerivativesApart, TextOfAProduct) {
  ProgramBuilder builder("f");
  const Expr x(builder, builder.input(Array::x, 0)), y(builder, builder.input(Array::x, 1));
  builder.output(Array::y, 0, (sin(x) * y).value(builder));
  const DerivativesApart apart = take_derivatives_apart(builder.finish(), kAll, kAll);
  EXPECT_EQ(apart.slopes, 2);
  EXPECT_EQ(dump(apart.along),
            "program f\n"
            "%0 = input d_x[0]\n"
            "%1 = input d_x[1]\n"
            "%2 = input slope[0]\n"
            "%3 = mul %0 %2\n"
            "%4 = input x[1]\n"
            "%5 = mul %3 %4\n"
            "%6 = input slope[1]\n"
            "%7 = muladd %1 %6 %5\n"
            "out d_y[0] = %7\n");
}

/// Operations of `along`.
OperationCount count_along(const Program& program, double slope_cost) {
  return count_operations(take_derivatives_apart(program, kAll, kAll, slope_cost).along);
}

TEST(DerivativesApart, PassOverDerivativesWhereThatIsCheaper) {
  const Program chain = program_of([](auto x, auto y) { return sin(cos(sin(x))) + 0.0 * y; });
  EXPECT_EQ(count_along(chain, 0.2).multiply, 1);
  EXPECT_EQ(count_along(chain, 2).multiply, 3);
  // d(x^2) = 2 x dx, not x dx + x dx
  const Program square = program_of([](auto x, auto y) { return x * x * y; });
  EXPECT_EQ(count_along(square, 0.2).multiply, 2);
  EXPECT_EQ(count_along(square, 0.2).add, 1);
}

/// The slopes of a table are chosen before the product.
TEST(DerivativesApart, ChoiceBetweenMultiplesOfOneDerivativeIsOneProduct) {
  const Program table =
      program_of([](auto x, auto y) { return select(y, 3 * x, select(y - 1.0, x / 7, select(y - 2.0, 2.0, 5 - x))); });
  const OperationCount count = count_along(table, 1);
  EXPECT_EQ(count.multiply, 1);
  EXPECT_EQ(count.other, 0);
}

TEST(DerivativesApart, OfEachOperation) {
  const std::pair<const char*, std::function<Expr(const Expr&, const Expr&)>> cases[] = {
      {"sum", [](auto x, auto y) { return x + 2 * y - (x - 1) - (3 - y); }},
      {"product", [](auto x, auto y) { return x * y * x; }},
      {"quotient", [](auto x, auto y) { return x / y + 1 / y + x / 3; }},
      {"roots", [](auto x, auto y) { return sqrt(x) + log(y) + exp(x * y); }},
      {"angles", [](auto x, auto y) { return sin(x) * cos(y) + tan(x) + asin(x) - acos(y); }},
      {"arcs", [](auto x, auto y) { return atan(x) + atan2(y, x) + tanh(x * y); }},
      {"powers", [](auto x, auto y) { return pow(x, y) + pow(x, 2.5) + pow(3.0, y); }},
      {"kinks", [](auto x, auto y) { return abs(x - y) + min(x, y) * max(x, 0.5) + select(x - 1.0, x * x, y * y); }},
      {"steps", [](auto x, auto y) { return floor(3 * x) * y; }},
      {"tables", [](auto x, auto y) { return select(y - 0.5, 3 * x, select(x - 0.5, 1.0, x / 7)) * sin(cos(x)); }},
      {"constant branches", [](auto x, auto y) { return max(0.0, x - 1) + select(y - 1.0, 0.0, y) + min(2.0, x); }}};
  for (const auto& [name, function] : cases)
    for (const auto& [x, y] : {std::pair{0.3, 0.7}, {0.9, 0.2}}) {
      const Program program = program_of(function);
      for (const Program& form : {program, contract(program)})
        expect_same(form, {{{Array::x, 0}, x}, {{Array::x, 1}, y}}, {{{Array::x, 0}, 0.4}, {{Array::x, 1}, -1.3}},
                    name);
    }
}

TEST(DerivativesApart, OfRandomPrograms) {
  for (int seed = 1; seed <= 20; ++seed) {
    Numbers at, rates;
    for (int i = 0; i < 6; ++i) {
      at[{Array::in, i}] = 0.37 * i - 0.9;
      rates[{Array::in, i}] = 1 - 0.21 * i;
    }
    expect_same(contract(random_program(static_cast<std::uint64_t>(seed), 60)), at, rates, std::to_string(seed));
  }
}

/// Both lanes of a pair have derivatives of their own.
TEST(DerivativesApart, OfPairs) {
  ProgramBuilder builder("f");
  const ValueId pair = builder.append(Op::pack, builder.input(Array::x, 0), builder.input(Array::x, 1));
  const ValueId sine = builder.append(Op::sin, pair), product = builder.append(Op::multiply, sine, pair);
  const ValueId less = builder.append(Op::divide, product, builder.append(Op::add, builder.constant(2), pair));
  builder.output(Array::y, 0, builder.append(Op::first_lane, less));
  builder.output(Array::y, 1, builder.append(Op::second_lane, builder.append(Op::multiply, less, less)));
  expect_same(builder.finish(), {{{Array::x, 0}, 0.3}, {{Array::x, 1}, 0.8}},
              {{{Array::x, 0}, 0.4}, {{Array::x, 1}, -1.3}}, "pairs");
}

/// A sum of squares and of a positive number has a root with bounded slopes: no choice guards it.
TEST(DerivativesApart, RootsOfPositiveSumsHaveBounds) {
  const Program bounded = contract(program_of([](auto x, auto y) { return sqrt(x * x + (y * y + 1e-30)); }));
  const Program unbounded = contract(program_of([](auto x, auto y) { return sqrt(x * x + y * y); }));
  EXPECT_EQ(count_along(bounded, 1).other, 0);
  EXPECT_GT(count_along(unbounded, 1).other, 0);
  const Numbers at{{{Array::x, 0}, 0.0}, {{Array::x, 1}, 0.0}}, rates{{{Array::x, 0}, 1.0}, {{Array::x, 1}, -1.0}};
  EXPECT_EQ(apart_at(bounded, at, rates).at({derivative_of(Array::y), 0}), 0);
}

/// Where a slope has no bound, what rests gets no derivative, and what moves gets infinity.
TEST(DerivativesApart, SlopesWithoutBoundCountWhereSomethingMoves) {
  const Program program = program_of([](auto x, auto y) { return sqrt(x) * y; });
  const auto by = [&](double rate) {
    return apart_at(program, {{{Array::x, 0}, 0.0}, {{Array::x, 1}, 2.0}},
                    {{{Array::x, 0}, rate}, {{Array::x, 1}, 1.0}})
        .at({derivative_of(Array::y), 0});
  };
  EXPECT_EQ(by(0), 0);
  EXPECT_TRUE(std::isinf(by(1)));
}

TEST(DerivativesApart, OutputsThatNobodyWantsAndInputsThatRestHaveNone) {
  const Program program = program_of([](auto x, auto y) { return x * y; });
  const auto none = [](const Slot&) { return false; };
  EXPECT_EQ(take_derivatives_apart(program, kAll, none).slopes, 0);
  EXPECT_TRUE(take_derivatives_apart(program, none, kAll).along.outputs.empty());
  const auto first = [](const Slot& slot) { return slot.index == 0; };
  EXPECT_EQ(take_derivatives_apart(program, first, kAll).along.inputs,
            (std::vector<Slot>{{derivative_of(Array::x), 0}, {Array::x, 1}}));
}

}  // namespace
}  // namespace mbgen
