// Numbers that fold from named ones: programs for reading keep their operations, fast programs forget them.

#include <gtest/gtest.h>

#include "compiler/program/program.hpp"

namespace mbgen {
namespace {

Expr named_number(ProgramBuilder& builder, double value, const std::string& name) {
  return Expr(value).named(builder.name_constant(value, name), &builder);
}

/// A program that gives z times I + m c c.
Program with_fold(Spelling spelling, const std::string& name = "") {
  ProgramBuilder builder("program", spelling);
  const Expr z(builder, builder.input(Array::z, 0));
  const Expr mass = named_number(builder, 1.1, "m"), at = named_number(builder, 0.12, "c"),
             central = named_number(builder, 0.006, "I");
  const Expr whole = central + mass * (at * at);
  if (!name.empty() && whole.builder_of_name() != nullptr) builder.name_fold(whole.name(), name);
  builder.output(Array::y, 0, (whole * z).value(builder));
  return builder.finish_in_canonical_order();
}

const NamedConstant* constant_of(const Program& program, const std::string& name) {
  for (const NamedConstant& constant : program.constants)
    if (constant.name == name) return &constant;
  return nullptr;
}

TEST(Folds, OfFastProgramsHaveNoName) {
  const Program program = with_fold(Spelling::fast, "Io");
  EXPECT_TRUE(program.constants.empty());
}

TEST(Folds, OfProgramsForReadingKeepTheirOperation) {
  const Program program = with_fold(Spelling::reading, "Io");
  const NamedConstant* const inertia = constant_of(program, "Io");
  ASSERT_NE(inertia, nullptr);
  EXPECT_EQ(inertia->value, 0.02184);
  EXPECT_EQ(inertia->op, Op::add);
  ASSERT_GE(inertia->labels[0], 0);
  ASSERT_GE(inertia->labels[1], 0);
  EXPECT_EQ(program.constants[static_cast<std::size_t>(inertia->labels[0])].name, "I");
  const NamedConstant& product = program.constants[static_cast<std::size_t>(inertia->labels[1])];
  EXPECT_TRUE(product.is_anonymous);
  EXPECT_EQ(product.name, "m mul (c mul c)");
  EXPECT_FALSE(inertia->is_anonymous);
}

TEST(Folds, WithoutANameAreToldByTheirOperation) {
  const Program program = with_fold(Spelling::reading);
  const NamedConstant* const inertia = constant_of(program, "I add (m mul (c mul c))");
  ASSERT_NE(inertia, nullptr);
  EXPECT_TRUE(inertia->is_anonymous);
}

TEST(Folds, ToZeroAndOneAreStructure) {
  ProgramBuilder builder("program", Spelling::reading);
  const Expr a = named_number(builder, 0.4, "a"), b = named_number(builder, 0.4, "b"),
             z(builder, builder.input(Array::z, 0));
  EXPECT_EQ((a - b).name(), -1);
  EXPECT_EQ((a / b).name(), -1);
  builder.output(Array::y, 0, ((a - b) * z + (a / b) * z).value(builder));
  const Program program = builder.finish();
  EXPECT_EQ(program.outputs[0].value, 0u) << "the input itself";
}

TEST(Folds, OfEqualNumbersOfTwoPartsStayApart) {
  ProgramBuilder builder("program", Spelling::reading);
  const Expr left = named_number(builder, 0.3, "m_left"), right = named_number(builder, 0.3, "m_right"),
             z(builder, builder.input(Array::z, 0));
  builder.output(Array::y, 0, (left * z).value(builder));
  builder.output(Array::y, 1, (right * z).value(builder));
  const Program program = builder.finish();
  EXPECT_NE(program.outputs[0].value, program.outputs[1].value) << "the right one would bear the left one's name";
}

}  // namespace
}  // namespace mbgen
