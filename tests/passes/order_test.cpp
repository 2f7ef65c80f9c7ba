// The order of values for few registers.

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "compiler/passes/passes.hpp"
#include "compiler/program/program.hpp"

namespace mbgen {
namespace {

/// Most operations that are alive at once: computed, and needed by an operation that is not.
int most_alive(const Program& program) {
  const auto is_operation = [&](ValueId v) {
    return program.nodes[v].op != Op::constant && program.nodes[v].op != Op::input;
  };
  std::vector<ValueId> last_use(program.nodes.size(), 0);
  for (ValueId v = 0; v < program.nodes.size(); ++v)
    for (int k = 0; k < arity(program.nodes[v].op); ++k) last_use[program.nodes[v].operands[k]] = v;
  int most = 0;
  for (ValueId now = 0; now < program.nodes.size(); ++now) {
    int alive = 0;
    for (ValueId v = 0; v <= now; ++v) alive += is_operation(v) && last_use[v] > now;
    most = std::max(most, alive);
  }
  return most;
}

/// All squares first, then their products in pairs, then the sum: the worst order there is.
Program squares_first(int count) {
  ProgramBuilder builder("squares");
  std::vector<ValueId> values;
  for (int i = 0; i < count; ++i) values.push_back(builder.append(Op::sqrt, builder.input(Array::z, i)));
  for (ValueId& value : values) value = builder.append(Op::add, value, builder.append(Op::sin, value));
  ValueId sum = values[0];
  for (int i = 1; i < count; ++i) sum = builder.append(Op::add, sum, values[i]);
  builder.output(Array::zdd, 0, sum);
  return builder.finish();
}

TEST(FewestAlive, TermsJoinTheirSumAtOnce) {
  const Program before = squares_first(8);
  const Program after = fewest_alive(before);
  EXPECT_EQ(most_alive(before), 9);
  EXPECT_EQ(most_alive(after), 3);
}

TEST(FewestAlive, KeepsOperationsAndBits) {
  const Program before = squares_first(8);
  const Program after = fewest_alive(before);
  EXPECT_EQ(before.nodes.size(), after.nodes.size());
  EXPECT_EQ(count_operations(before).total(), count_operations(after).total());
  const std::vector<double> inputs = {0.1, 2, 3e5, 0.7, 11, 1e-9, 5, 6};
  EXPECT_EQ(interpret(before, inputs), interpret(after, inputs));
}

TEST(FewestAlive, AValueThatEndsALifeComesUp) {
  ProgramBuilder builder("f");
  const ValueId x = builder.input(Array::z, 0), y = builder.input(Array::z, 1);
  const ValueId product = builder.append(Op::multiply, x, y);
  const ValueId sine = builder.append(Op::sin, x);
  const ValueId square = builder.append(Op::multiply, sine, sine);
  builder.output(Array::zdd, 0, builder.append(Op::add, square, product));
  const Program after = fewest_alive(builder.finish());
  ASSERT_EQ(after.nodes.size(), 6u);
  EXPECT_EQ(after.nodes[2].op, Op::sin);
  EXPECT_EQ(after.nodes[3].op, Op::multiply);
  EXPECT_EQ(after.nodes[3].operands[0], after.nodes[3].operands[1]);
}

TEST(FewestAlive, EmptyProgram) { EXPECT_TRUE(fewest_alive(Program{}).nodes.empty()); }

}  // namespace
}  // namespace mbgen
