// The order of values for few registers.

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <vector>

#include "compiler/program/kinds.hpp"
#include "compiler/program/program.hpp"
#include "compiler/schedule/fewest_alive.hpp"
#include "compiler/schedule/schedule.hpp"

namespace mbgen {
namespace {

/// Most operations that are alive at once in this order: computed, and needed by an operation that is not.
int most_alive(const Program& program, const std::vector<ValueId>& order) {
  std::vector<std::size_t> last_use(program.nodes.size(), 0);
  for (std::size_t i = 0; i < order.size(); ++i)
    for (int k = 0; k < arity(program.nodes[order[i]].op); ++k) last_use[program.nodes[order[i]].operands[k]] = i;
  int most = 0;
  for (std::size_t now = 0; now < order.size(); ++now) {
    int alive = 0;
    for (std::size_t i = 0; i <= now; ++i) alive += last_use[order[i]] > now;
    most = std::max(most, alive);
  }
  return most;
}

/// The order with every operation by itself.
std::vector<ValueId> fewest_alive(const Program& program) {
  std::vector<std::vector<ValueId>> bundles;
  for (const ValueId v : live_operations(program)) bundles.push_back({v});
  return fewest_alive(program, bundles);
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
  const Program program = squares_first(8);
  EXPECT_EQ(most_alive(program, live_operations(program)), 9);
  EXPECT_EQ(most_alive(program, fewest_alive(program)), 3);
}

TEST(FewestAlive, EveryOperationStandsOnceAfterItsOperands) {
  ProgramBuilder builder("f");
  const ValueId x = builder.input(Array::z, 0), y = builder.input(Array::z, 1);
  const ValueId product = builder.append(Op::multiply, x, y);
  builder.append(Op::exp, product);  // no output needs it
  builder.output(Array::zdd, 0, builder.append(Op::add, builder.append(Op::sin, product), product));
  const Program program = builder.finish();
  const std::vector<ValueId> order = fewest_alive(program);
  EXPECT_EQ(order, live_operations(program));
  EXPECT_EQ(order.size(), 3u);
}

TEST(FewestAlive, AValueThatEndsALifeComesUp) {
  ProgramBuilder builder("f");
  const ValueId x = builder.input(Array::z, 0), y = builder.input(Array::z, 1);
  const ValueId product = builder.append(Op::multiply, x, y);
  const ValueId sine = builder.append(Op::sin, x);
  const ValueId square = builder.append(Op::multiply, sine, sine);
  const ValueId sum = builder.append(Op::add, square, product);
  builder.output(Array::zdd, 0, sum);
  EXPECT_EQ(fewest_alive(builder.finish()), (std::vector<ValueId>{sine, square, product, sum}));
}

TEST(FewestAlive, OneCallForManyArgumentsStaysOne) {
  ProgramBuilder builder("f");
  ValueId sum = builder.constant(0);
  for (int i = 0; i < 4; ++i) {
    const ValueId slip = builder.append(Op::multiply, builder.input(Array::z, i), builder.input(Array::zd, i));
    const ValueId force = builder.append(Op::multiply, builder.append(Op::atan, slip), slip);
    sum = builder.append(Op::add, sum, force);
  }
  builder.output(Array::zdd, 0, sum);
  const Schedule found = schedule(builder.finish(), {.order = ValueOrder::fewest_alive});
  ASSERT_EQ(found.calls.calls.size(), 1u);
  EXPECT_EQ(found.calls.calls[0].arguments.size(), 4u);
}

/// tanh a, atan b, tanh(atan b): what the first of them gives is needed last.
TEST(Schedule, AVectorsFunctionWaitsForALaterOneOfItsKind) {
  ProgramBuilder builder("f");
  const ValueId a = builder.append(Op::sqrt, builder.input(Array::z, 0));
  const ValueId b = builder.append(Op::sqrt, builder.input(Array::z, 1));
  const ValueId early = builder.append(Op::tanh, a), late = builder.append(Op::tanh, builder.append(Op::atan, b));
  builder.output(Array::zdd, 0, builder.append(Op::multiply, early, late));
  const Program program = builder.finish();
  EXPECT_TRUE(schedule(program).calls.calls.empty());
  const Schedule found = schedule(program, {.gathering = Gathering::of_vectors});
  ASSERT_EQ(found.calls.calls.size(), 1u);
  EXPECT_EQ(found.calls.calls[0].arguments.size(), 2u);
  EXPECT_EQ(found.calls.place[early].call, 0);
  EXPECT_EQ(found.calls.place[late].call, 0);
}

TEST(Schedule, AVectorsFunctionDoesNotWaitForOneThatNeedsIt) {
  ProgramBuilder builder("f");
  const ValueId first = builder.append(Op::tanh, builder.append(Op::sqrt, builder.input(Array::z, 0)));
  builder.output(Array::zdd, 0, builder.append(Op::tanh, builder.append(Op::atan, first)));
  EXPECT_TRUE(schedule(builder.finish(), {.gathering = Gathering::of_vectors}).calls.calls.empty());
}

/// sin a and cos a, sin b, cos c, sin(2 atan b), cos(2.1 atan c): but for a each needs one of the two alone, and twice
/// an arc is within half a turn.
TEST(Schedule, VectorsThatNeedTheSineOrTheCosineAloneHaveCallsOfTheirOwn) {
  ProgramBuilder builder("f");
  ValueId angle[3];
  for (int k = 0; k < 3; ++k) angle[k] = builder.append(Op::sqrt, builder.input(Array::z, k));
  const auto multiple = [&](double factor, ValueId v) {
    return builder.append(Op::multiply, builder.constant(factor), builder.append(Op::atan, v));
  };
  const ValueId near = multiple(2, angle[1]), far = multiple(2.1, angle[2]);
  const ValueId values[] = {builder.append(Op::sin, angle[0]), builder.append(Op::cos, angle[0]),
                            builder.append(Op::sin, angle[1]), builder.append(Op::cos, angle[2]),
                            builder.append(Op::sin, near),     builder.append(Op::cos, far)};
  for (int k = 0; k < 6; ++k) builder.output(Array::zdd, k, values[k]);
  const Program program = builder.finish();
  EXPECT_TRUE(schedule(program).calls.calls.empty()) << "fewer than lanes ask for";
  const ArrayCalls calls = schedule(program, {.gathering = Gathering::of_vectors}).calls;
  std::map<ArrayFunction, std::vector<ValueId>> arguments;
  for (const ArrayCall& call : calls.calls) arguments[call.function] = call.arguments;
  arguments.erase(ArrayFunction::arc_tangent);
  EXPECT_EQ(arguments, (std::map<ArrayFunction, std::vector<ValueId>>{{ArrayFunction::sine, {angle[1]}},
                                                                      {ArrayFunction::cosine, {angle[2], far}},
                                                                      {ArrayFunction::bounded_sine, {near}}}));
  EXPECT_EQ(calls.place[values[0]].call, -1);
}

TEST(FewestAlive, EmptyProgram) { EXPECT_TRUE(fewest_alive(Program{}).empty()); }

TEST(Schedule, StandsInTheOrderThatIsAskedFor) {
  ProgramBuilder builder("f");
  const ValueId x = builder.input(Array::z, 0), y = builder.input(Array::z, 1);
  const ValueId product = builder.append(Op::multiply, x, y);
  const ValueId quotient = builder.append(Op::divide, x, y);
  const ValueId square = builder.append(Op::multiply, quotient, quotient);
  const ValueId sum = builder.append(Op::add, square, product);
  builder.output(Array::zdd, 0, sum);
  const Program program = builder.finish();
  EXPECT_EQ(schedule(program).order, (std::vector<ValueId>{product, quotient, square, sum}));
  EXPECT_EQ(schedule(program, {.order = ValueOrder::fewest_alive}).order,
            (std::vector<ValueId>{quotient, square, product, sum}));
}

}  // namespace
}  // namespace mbgen
