// Values of two lanes.

#include <gtest/gtest.h>

#include <vector>

#include "compiler/program/program.hpp"

namespace mbgen {
namespace {

/// Two inputs, and what a test appends.
struct Builder {
  ProgramBuilder builder{"f"};
  ValueId x = builder.input(Array::x, 0), y = builder.input(Array::x, 1);

  ValueId append(Op op, ValueId a, ValueId b = kNoValue) { return builder.append(op, a, b); }
  Program finish(ValueId value) {
    builder.output(Array::y, 0, value);
    return builder.finish();
  }
};

TEST(Pairs, AreDoneLaneByLane) {
  Builder b;
  const ValueId pair = b.append(Op::pack, b.x, b.y);
  const ValueId product = b.append(Op::multiply, b.builder.constant(3), b.append(Op::multiply, pair, pair));
  const ValueId difference =
      b.append(Op::subtract, b.append(Op::second_lane, product), b.append(Op::first_lane, product));
  const Program program = b.finish(difference);
  EXPECT_EQ(interpret(program, std::vector<double>{2, 5}), std::vector<double>{3 * 25 - 3 * 4.0});
  EXPECT_EQ(widths_of(program), (std::vector<int>{1, 1, 2, 2, 0, 2, 1, 1, 1}));
  EXPECT_EQ(count_operations(program).multiply, 4) << "one in each lane";
  EXPECT_EQ(count_operations(program).add, 1);
  const Program apart = unfolded(program);
  EXPECT_FALSE(has_pairs(apart));
  EXPECT_EQ(count_operations(apart).total(), 5);
}

TEST(Pairs, FoldWhatIsPackedAndTakenApart) {
  Builder b;
  const ValueId pair = b.append(Op::pack, b.x, b.y);
  EXPECT_EQ(b.append(Op::first_lane, pair), b.x);
  EXPECT_EQ(b.append(Op::second_lane, pair), b.y);
  const ValueId square = b.append(Op::multiply, pair, pair);
  const ValueId first = b.append(Op::first_lane, square), second = b.append(Op::second_lane, square);
  EXPECT_EQ(b.append(Op::pack, first, second), square);
  EXPECT_NE(b.append(Op::pack, second, first), square);
  EXPECT_EQ(b.append(Op::first_lane, b.append(Op::negate, square)), b.append(Op::negate, first));
  EXPECT_EQ(b.append(Op::pack, b.append(Op::negate, b.x), b.append(Op::negate, b.y)), b.append(Op::negate, pair));
  const ValueId two = b.builder.constant(2);
  EXPECT_EQ(b.append(Op::pack, two, two), two) << "a constant counts for every lane";
  EXPECT_EQ(b.append(Op::second_lane, two), two);
}

TEST(Pairs, KeepTheNamesOfBothLanesApart) {
  Builder b;
  const ValueId pair = b.append(Op::pack, b.x, b.y);
  b.builder.set_owner({OwnerKind::body, 1}, {OwnerKind::body, 2});
  const ValueId square = b.append(Op::multiply, pair, pair);
  b.builder.label(square, "left", "right");
  const Program apart =
      unfolded(b.finish(b.append(Op::add, b.append(Op::first_lane, square), b.append(Op::second_lane, square))));
  ASSERT_EQ(apart.nodes[2].op, Op::multiply);
  EXPECT_EQ(apart.labels[static_cast<std::size_t>(apart.nodes[2].label)], "left");
  EXPECT_EQ(apart.labels[static_cast<std::size_t>(apart.nodes[3].label)], "right");
  EXPECT_EQ(apart.nodes[3].owner, (Owner{OwnerKind::body, 2}));
}

TEST(Pairs, MeetNumbersOnlyWherePacked) {
  Builder b;
  Program program = b.finish(b.append(Op::first_lane, b.append(Op::sqrt, b.append(Op::pack, b.x, b.y))));
  EXPECT_EQ(verify(program), "");
  Program mixed = program;
  mixed.nodes.push_back({Op::add, {0, 2, kNoValue}});
  EXPECT_EQ(verify(mixed), "%5: operand 0 of add has width 1");
  Program of_number = program;
  of_number.nodes[4].operands[0] = 0;
  EXPECT_EQ(verify(of_number), "%4: operand 0 of first_lane has width 1");
  program.outputs[0].value = 3;
  EXPECT_EQ(verify(program), "output y[0] is a pair");
}

}  // namespace
}  // namespace mbgen
