// Values written as one operation on others.

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "compiler/passes/passes.hpp"
#include "tests/support/random_program.hpp"

namespace mbgen {
namespace {

using Make = std::function<std::vector<Expr>(const std::vector<Expr>& x)>;

Program outputs_of(const Make& make) {
  ProgramBuilder builder("f");
  std::vector<Expr> x;
  for (int i = 0; i < 6; ++i) x.emplace_back(builder, builder.input(Array::in, i));
  const std::vector<Expr> values = make(x);
  for (std::size_t i = 0; i < values.size(); ++i)
    builder.output(Array::y, static_cast<int>(i), values[i].value(builder));
  return remove_dead_values(builder.finish());
}

/// Operations with shorter forms, whose values are those of before.
long operations(const Make& make) {
  const Program program = outputs_of(make), shorter = remove_dead_values(write_shorter_forms(program));
  std::vector<double> inputs;
  for (std::size_t i = 0; i < program.inputs.size(); ++i) inputs.push_back(0.7 + 0.3 * static_cast<double>(i));
  const std::vector<double> before = interpret(program, inputs);
  std::vector<double> kept;  // an input that is no more needed has gone
  for (const Slot& slot : shorter.inputs)
    for (std::size_t i = 0; i < program.inputs.size(); ++i)
      if (program.inputs[i] == slot) kept.push_back(inputs[i]);
  const std::vector<double> after = interpret(shorter, kept);
  for (std::size_t i = 0; i < before.size(); ++i) EXPECT_NEAR(after[i], before[i], 1e-14 * std::abs(before[i])) << i;
  return count_operations(shorter).total();
}

TEST(ShorterForms, ProductsOfProducts) {
  EXPECT_EQ(operations([](const auto& x) -> std::vector<Expr> {
              return {x[0] * x[1], (x[0] * x[2]) * x[1], -((x[3] * x[0]) * x[1])};
            }),
            3);
}

TEST(ShorterForms, SumsOfSums) {
  EXPECT_EQ(operations([](const auto& x) -> std::vector<Expr> {
              return {x[0] + x[1], (x[2] + x[0]) + x[1], (x[3] - x[0]) - x[1], x[0] - (x[4] - x[1])};
            }),
            4);
}

TEST(ShorterForms, ValuesThatOthersNeedStay) {
  EXPECT_EQ(operations([](const auto& x) -> std::vector<Expr> {
              const Expr shared = x[0] * x[2];
              return {x[0] * x[1], shared * x[1], shared};
            }),
            3);
}

/// x - 0.99999999 x is 1e-8 x with eight digits lost: the product as it stands is kept.
TEST(ShorterForms, NoDifferenceOfLargeNumbers) {
  const Program program = outputs_of([](const auto& x) -> std::vector<Expr> {
    const Expr p = x[0] * x[1], large = 0.99999999 * p, small = (1e-8 * x[1]) * x[0];
    return {p, large, tanh(p) - large, exp(small) * x[0]};
  });
  const Program shorter = remove_dead_values(write_shorter_forms(program));
  std::vector<double> inputs(program.inputs.size(), 1.25);
  ASSERT_EQ(shorter.inputs.size(), inputs.size());
  const double exact = std::exp(1.25 * 1.25 * 1e-8);
  EXPECT_NEAR(interpret(shorter, inputs)[3] / 1.25, exact, 4e-16);
  EXPECT_LT(count_operations(shorter).total(), count_operations(program).total()) << "1e-8 p is one product";
}

TEST(ShorterForms, RandomProgramsKeepTheirValues) {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    const Program program = remove_dead_values(random_program(seed, 300));
    const Program shorter = write_shorter_forms(program);
    EXPECT_LE(count_operations(shorter).total(), count_operations(program).total());
    std::vector<double> inputs;
    for (std::size_t i = 0; i < program.inputs.size(); ++i) inputs.push_back(0.3 + 0.17 * static_cast<double>(i));
    const std::vector<double> before = interpret(program, inputs), after = interpret(shorter, inputs);
    for (std::size_t i = 0; i < before.size(); ++i)
      EXPECT_NEAR(after[i], before[i], 1e-9 * (1 + std::abs(before[i]))) << "seed " << seed;
  }
}

}  // namespace
}  // namespace mbgen
