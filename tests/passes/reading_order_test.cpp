// The order of programs for reading: the paper's steps, each once, and in a step from one part to the next.

#include <gtest/gtest.h>

#include "compiler/passes/passes.hpp"

namespace mbgen {
namespace {

/// As the formulation goes: forces, then a block with steps 2, 7 and 8, then another block.
Program two_blocks() {
  ProgramBuilder builder("program", Spelling::reading);
  const Expr z(builder, builder.input(Array::z, 0)), zd(builder, builder.input(Array::zd, 0));
  const auto at = [&](Step step, int block, int body) {
    builder.set_section({step, block});
    builder.set_owner({OwnerKind::tree_body, body});
  };
  at(Step::inertias, -1, 0);
  const Expr sine = sin(z);
  at(Step::forces, -1, 0);
  const Expr square = sine * sine, force = square * zd;
  at(Step::jacobian, 0, 0);
  const Expr entry = square + z;  // needs a value of step 5
  at(Step::accelerations, 0, 0);
  const Expr inertia = entry * z;
  at(Step::reduced_system, 0, 0);
  const Expr left = inertia * force;
  at(Step::jacobian, 1, 1);
  const Expr other = sine + z;
  at(Step::accelerations, 1, 1);
  const Expr waiting = left + other;  // waits for the elimination of the first block
  at(Step::reduced_system, 1, 1);
  builder.output(Array::y, 0, (waiting * zd).value(builder));
  return builder.finish();
}

std::vector<int> steps_of(const Program& program) {
  std::vector<int> steps;
  for (const Node& node : program.nodes)
    if (node.op != Op::input && node.op != Op::constant) steps.push_back(number_of(node.section.step));
  return steps;
}

TEST(ReadingOrder, StepsAscend) {
  const Program ordered = in_reading_order(two_blocks());
  EXPECT_EQ(steps_of(ordered), (std::vector<int>{1, 2, 2, 2, 5, 7, 8, 8, 8}));
  for (const Section& section : ordered.sections) EXPECT_EQ(section.block, -1);
}

TEST(ReadingOrder, LeavesTheOutputs) {
  const Program program = two_blocks();
  const std::vector<double> inputs = {0.7, -1.3};
  EXPECT_EQ(interpret(in_reading_order(program), inputs), interpret(program, inputs));
}

TEST(ReadingOrder, AStepGoesFromPartToPart) {
  ProgramBuilder builder("program", Spelling::reading);
  const Expr z(builder, builder.input(Array::z, 0));
  builder.set_section({Step::inertias, -1});
  std::vector<Expr> of_body = {z, z};
  for (int turn = 1; turn < 4; ++turn)
    for (int body = 0; body < 2; ++body) {
      builder.set_owner({OwnerKind::tree_body, body});
      of_body[static_cast<std::size_t>(body)] = of_body[static_cast<std::size_t>(body)] * z + Expr(body + 2.0);
    }
  builder.output(Array::y, 0, of_body[0].value(builder));
  builder.output(Array::y, 1, of_body[1].value(builder));
  std::vector<int> owners;
  for (const Node& node : in_reading_order(builder.finish()).nodes)
    if (node.owner.index >= 0 && (owners.empty() || owners.back() != node.owner.index))
      owners.push_back(node.owner.index);
  EXPECT_EQ(owners, (std::vector<int>{0, 1}));
}

}  // namespace
}  // namespace mbgen
