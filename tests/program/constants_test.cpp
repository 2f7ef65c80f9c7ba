// Numbers of a model in programs: folded as the decimals that people typed, named where the formulation names them.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <random>
#include <string>

#include "compiler/decimal/decimal.hpp"
#include "compiler/passes/passes.hpp"
#include "compiler/program/arithmetic.hpp"

namespace mbgen {
namespace {

TEST(Decimal, SumsAndProductsOfTypedNumbersAreTypedNumbers) {
  EXPECT_EQ(decimal_sum(0.41, -0.40), 0.01);
  EXPECT_EQ(decimal_sum(0.1, 0.2), 0.3);
  EXPECT_EQ(decimal_sum(1e-7, 3), 3.0000001);
  EXPECT_EQ(decimal_sum(-0.25, 0.25), 0.0);
  EXPECT_EQ(decimal_product(0.8, 0.05), 0.04);
  EXPECT_EQ(decimal_product(-1.1, 1.1), -1.21);
  EXPECT_EQ(decimal_product(7e-4, 1e3), 0.7);
}

__extension__ typedef __int128 Wide;

/// The double that the C library reads.
double read(Wide digits, int exponent) {
  std::string text;
  for (Wide rest = digits < 0 ? -digits : digits; rest != 0; rest /= 10)
    text.insert(text.begin(), static_cast<char>('0' + static_cast<int>(rest % 10)));
  return std::strtod(((digits < 0 ? "-" : "") + text + "e" + std::to_string(exponent)).c_str(), nullptr);
}

TEST(Decimal, NumbersOfEveryLengthAreReadAsTheyWereTyped) {
  std::mt19937_64 random(7);
  const auto below = [&](std::int64_t count) {
    return static_cast<std::int64_t>(random() % static_cast<std::uint64_t>(count));
  };
  double previous = 0.1;
  TypedDecimal typed_previous{1, -1};
  for (int i = 0; i < 20000; ++i) {
    std::int64_t most = 10;
    for (std::int64_t digit = below(15); digit > 0; --digit) most *= 10;
    std::int64_t digits = 10 * below(most / 10) + 1 + below(9);  // none at the end that is zero
    if (below(2) == 0) digits = -digits;
    const int exponent = static_cast<int>(below(30)) - 20;
    const double value = read(digits, exponent);
    const std::optional<TypedDecimal> typed = typed_decimal(value);
    ASSERT_TRUE(typed) << value;
    EXPECT_EQ(typed->digits, digits) << value;
    EXPECT_EQ(typed->exponent, exponent) << value;
    const Wide product = static_cast<Wide>(digits) * typed_previous.digits;
    EXPECT_EQ(decimal_product(value, previous), read(product, exponent + typed_previous.exponent)) << value;
    previous = value;
    typed_previous = *typed;
  }
  EXPECT_FALSE(typed_decimal(1.0 / 3));
  EXPECT_EQ(typed_decimal(0.0)->digits, 0);
}

TEST(Decimal, WhatNobodyTypedIsAddedAsDoubles) {
  EXPECT_EQ(decimal_sum(1.0 / 3, 0.1), 1.0 / 3 + 0.1);
  EXPECT_EQ(decimal_product(1.0 / 3, 3), (1.0 / 3) * 3);
  EXPECT_EQ(decimal_sum(1e300, 1e-300), 1e300);
  EXPECT_EQ(decimal_product(1e-200, 1e-200), 0.0);
  EXPECT_TRUE(std::isinf(decimal_sum(1e308, 1e308)));
}

TEST(Decimal, WhatRoundingBlurredIsTheShortDecimalAgain) {
  const double third = 1.0 / 3;
  EXPECT_EQ(decimal_sum(third, -third + 1e-17), 0);
  EXPECT_EQ(decimal_sum(1.2500000000000002, -1.2), 0.05) << "and not 0.050000000000000266";
  EXPECT_EQ(decimal_product(0.033333333333333333, 3), 0.1);
  EXPECT_EQ(fold(Op::divide, 0.6, 0.2, 0), 3) << "and not 2.9999999999999996";
  EXPECT_EQ(fold(Op::divide, 1, 3, 0), third);
  EXPECT_EQ(fold(Op::sqrt, 0.1156, 0, 0), 0.34) << "and not 0.33999999999999997";
  EXPECT_EQ(decimal_sum(third, -0.33333333333333), third - 0.33333333333333) << "a difference, and not rounding";
  EXPECT_EQ(without_rounding(0.12345678901, 0.1), 0.12345678901);
  EXPECT_EQ(without_rounding(0.123456789012345, 0.1), 0.123456789012345) << "longer than what rounding is told from";
  EXPECT_EQ(without_rounding(1e-310, 1e-310), 1e-310);
  EXPECT_TRUE(std::isnan(without_rounding(std::nan(""), 1)));
  EXPECT_TRUE(std::isinf(fold(Op::divide, 1e308, 1e-8, 0)));
}

Expr named(ProgramBuilder& builder, double value, const std::string& name) {
  return Expr(value).named(builder.name_constant(value, name));
}

TEST(NamedConstants, KeepTheirNamesThroughWhatLeavesThemAlone) {
  ProgramBuilder builder("program");
  const Expr z(builder, builder.input(Array::z, 0)), mass = named(builder, 0.8, "m_crank");
  builder.output(Array::y, 0, (1.0 * mass * z + 0.0).value(builder));
  builder.output(Array::y, 1, (z * -mass).value(builder));
  builder.output(Array::y, 2, ((mass + 0.2) * z).value(builder));
  const std::string text = dump(optimise(builder.finish()));
  EXPECT_NE(text.find("constant 0.8  ; m_crank"), std::string::npos) << text;
  EXPECT_EQ(text.find("constant 1"), std::string::npos) << text;
}

TEST(NamedConstants, OfOneValueStayApartAndShareTheirOperations) {
  ProgramBuilder builder("program");
  const Expr z(builder, builder.input(Array::z, 0)), zd(builder, builder.input(Array::zd, 0));
  const Expr left = named(builder, 0.5, "p_left"), right = named(builder, 0.5, "p_right");
  builder.output(Array::y, 0, (left * z).value(builder));
  builder.output(Array::y, 1, (right * z).value(builder));
  builder.output(Array::y, 2, (right * zd).value(builder));
  builder.output(Array::y, 3, (0.5 * (zd * zd)).value(builder));
  const Program program = builder.finish();
  EXPECT_EQ(program.outputs[0].value, program.outputs[1].value);
  EXPECT_EQ(count_operations(program).multiply, 4);
  const auto name_in = [&](std::size_t output) {
    const Node& product = program.nodes[program.outputs[output].value];
    for (const ValueId operand : {product.operands[0], product.operands[1]}) {
      const Node& node = program.nodes[operand];
      if (node.op == Op::constant)
        return node.label < 0 ? std::string() : program.constants[static_cast<std::size_t>(node.label)].name;
    }
    return std::string("no constant");
  };
  EXPECT_EQ(name_in(0), "p_left");
  EXPECT_EQ(name_in(2), "p_right");
  EXPECT_EQ(name_in(3), "");
}

TEST(NamedConstants, AreCheckedAgainstTheirValues) {
  ProgramBuilder builder("program");
  const Expr z(builder, builder.input(Array::z, 0));
  builder.output(Array::y, 0, (named(builder, 0.5, "p_left") * z).value(builder));
  Program program = builder.finish();
  EXPECT_EQ(verify(program), "");
  program.constants[0].value = 0.25;
  EXPECT_NE(verify(program).find("0.5 is not p_left"), std::string::npos) << verify(program);
}

}  // namespace
}  // namespace mbgen
