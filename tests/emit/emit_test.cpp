// Emitted text: whole programs, and the schedules that they follow.

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

#include "compiler/emit/names.hpp"
#include "compiler/emit/text.hpp"
#include "compiler/emit/texts.hpp"
#include "tests/emit/emit_support.hpp"

namespace mbgen::test {
namespace {

ProgramShape bead_shape() {
  const Example example = bead_on_circle();
  const WrittenPrograms written{example.programs};
  const EmitContext context(written, example.model, example.topology, example.analysis, {});
  ProgramShape shape = shaped_programs(context).front().shape;
  shape.order = ValueOrder::by_section;
  shape.titles = {};
  return shape;
}

std::string written(const Program& program, const ProgramShape& shape = bead_shape()) {
  return program_text(program, schedule(program, schedule_options(shape, kRollAbove)), shape);
}

TEST(EmittedProgram, readsLikeTheFormulation) {
  EXPECT_EQ(written(bead_accelerations()), R"(/// Result of compute_accelerations.
struct Accelerations {
  double zdd[2];  ///< accelerations
  double xd[1];  ///< rates of the auxiliary states
  double pivot[1];  ///< smallest pivot of each block over its reference
  double inertia[1];  ///< pivots of the final equations
};

/// All accelerations with the frozen partition of the loop blocks.
void compute_accelerations(const Tuned& parameters, const Inputs& inputs, const State& state,
    const double* tau, Accelerations& __restrict result) noexcept {
  // --- step 1 ---
  const double force_x = inputs.push + tau[Coordinate::x];
  const double s1_1 = tau[Coordinate::y] - 9.81*parameters.mass;
  // operations: 2 add, 1 multiply

  // --- step 2 ---
  // tree_body 0
  const double z_x = state.z[Coordinate::x];
  const double s2_1 = state.z[Coordinate::y]/z_x;
  const double zd_x = state.zd[Coordinate::x];
  const double zd_y = state.zd[Coordinate::y];
  const double s2_2 = 2.0*(zd_x*zd_x + zd_y*zd_y)/(2.0*z_x);
  // operations: 1 add, 4 multiply, 2 divide

  // --- step 3 ---
  // tree_body 1
  const double s3_1 = parameters.mass*(1.0 + s2_1*s2_1);
  result.inertia[0] = s3_1;
  const double s3_2 = (s1_1 - s2_1*(force_x + parameters.mass*s2_2))/s3_1;
  result.zdd[Coordinate::y] = s3_2;
  result.zdd[Coordinate::x] = -(s2_2 + s2_1*s3_2);
  result.pivot[0] = std::abs(z_x);
  // operations: 4 add, 5 multiply, 1 divide, 1 other
}
)");
}

TEST(EmittedProgram, keepsSineAndCosineTogetherAndNamesWhatIsUsedTwice) {
  ProgramBuilder builder("accelerations");
  const Expr angle = Expr(builder, builder.input(Array::z, 0)) * Expr(builder, builder.input(Array::zd, 1));
  const Expr s = sin(angle);
  const Expr far = s * s + 1.0;
  const Expr c = cos(angle);
  output(builder, Array::zdd, 0, far * c);
  output(builder, Array::zdd, 1, 2.5);
  const std::string text = written(builder.finish_in_canonical_order());
  const std::string body = text.substr(text.find("{\n", text.find("void ")) + 2);
  EXPECT_EQ(body, R"(  // Results that need no operation.
  result.inertia[0] = 1.0;
  result.pivot[0] = 1.0;
  result.zdd[Coordinate::y] = 2.5;

  const double s0_1 = state.z[Coordinate::x]*state.zd[Coordinate::y];
  double s0_2, s0_3;
  mbgen::sincos(s0_1, s0_3, s0_2);
  result.zdd[Coordinate::x] = s0_2*(1.0 + s0_3*s0_3);
}
)");
}

/// Sines and cosines as rotations in a row meet them: by section, with work between them.
Program rotations() {
  ProgramBuilder builder("accelerations");
  const auto z = [&](int i) { return Expr(builder, builder.input(Array::z, i)); };
  builder.set_section({Step::inertias});
  const Expr first = sin(z(0)) * cos(z(0));
  const Expr second = first + sin(z(1)) - cos(z(0) + z(1));
  const Expr third = second * sin(2.0 * z(0) - z(1));
  const Expr inner = sin(first);
  builder.set_section({Step::jacobian});
  output(builder, Array::zdd, 0, third);
  output(builder, Array::zdd, 1, inner + cos(z(1)));
  return builder.finish_in_canonical_order();
}

TEST(EmittedProgram, callsForManyAnglesAtOnceWhereTheirSectionBegins) {
  const std::string text = written(rotations());
  const std::string body = text.substr(text.find("{\n", text.find("void ")) + 2);
  EXPECT_EQ(body, R"(  // Results that need no operation.
  result.inertia[0] = 1.0;
  result.pivot[0] = 1.0;

  // --- step 1 ---
  const double z_x = state.z[Coordinate::x];
  const double z_y = state.z[Coordinate::y];
  const double angles[] = {
      z_x, 2.0*z_x - z_y, z_y, z_x + z_y};
  double sines[4], cosines[4];
  mbgen::sincos(angles, sines, cosines);
  const double s1_1 = sines[0]*cosines[0];
  const double s1_2 = mbgen::sine(s1_1);
  result.zdd[Coordinate::x] = sines[1]*(s1_1 + sines[2] - cosines[3]);
  // operations: 4 add, 3 multiply, 6 sin cos

  // --- step 2 ---
  result.zdd[Coordinate::y] = s1_2 + mbgen::cosine(z_y);
  // operations: 1 add, 1 sin cos
}
)");
}

TEST(Schedules, gatherOnlyWhatIsManyEnough) {
  const Program program = rotations();
  const ArrayCalls calls = schedule(program).calls;
  ASSERT_EQ(calls.calls.size(), 1u);
  EXPECT_EQ(calls.calls[0].arguments.size(), 4u) << "z0, z1, z0 + z1, 2 z0 - z1";
  for (ValueId v = 0; v < program.nodes.size(); ++v) {
    const Node& node = program.nodes[v];
    if (calls.place[v].call < 0) continue;
    EXPECT_EQ(calls.calls[0].arguments[calls.place[v].argument], node.operands[0]);
    EXPECT_EQ(node.section, Section{Step::inertias});
  }
}

TEST(Schedules, gatherWhatOneCallAfterTheOtherNeeds) {
  ProgramBuilder builder("accelerations");
  for (int wheel = 0; wheel < 4; ++wheel) {
    const Expr slip = Expr(builder, builder.input(Array::z, wheel)) * Expr(builder, builder.input(Array::zd, wheel));
    builder.output(Array::zdd, wheel, sin(1.5 * atan(slip)).value(builder));
  }
  const Program program = builder.finish_in_canonical_order();
  const Schedule scheduled = schedule(program);
  std::string ops;
  for (const ValueId v : scheduled.order) ops += std::string(op_name(program.nodes[v].op)) + " ";
  EXPECT_EQ(ops, "mul mul mul mul atan atan atan atan mul mul mul mul sin sin sin sin ");
  ASSERT_EQ(scheduled.calls.calls.size(), 2u);
  EXPECT_EQ(scheduled.calls.calls[0].function, ArrayFunction::arc_tangent);
  EXPECT_EQ(scheduled.calls.calls[1].function, ArrayFunction::sine_and_cosine);
}

TEST(EmittedProgram, refusesSlotsThatHaveNoPlace) {
  ProgramBuilder builder("accelerations");
  builder.output(Array::zdd, 2, builder.input(Array::z, 0));
  EXPECT_THROW(written(builder.finish_in_canonical_order()), std::logic_error);
  ProgramBuilder second("accelerations");
  second.output(Array::zdd, 1, second.input(Array::zdd, 0));
  EXPECT_THROW(written(second.finish()), std::logic_error);
}

TEST(EmittedProgram, keepsLinesShort) {
  ProgramBuilder builder("accelerations");
  const Expr x(builder, builder.input(Array::z, 0)), y(builder, builder.input(Array::z, 1));
  Expr sum = 0.0;
  for (int i = 0; i < 200; ++i) {
    sum = sum * (x * (1.0 / (3 + i)) + y) + x / (y + double(i));
    builder.label(sum.value(builder), "a rather long name of an intermediate result, number " + std::to_string(i));
  }
  output(builder, Array::zdd, 0, sum);
  std::istringstream text(written(builder.finish_in_canonical_order()));
  for (std::string line; std::getline(text, line);) EXPECT_LE(line.size(), 110u) << line;
}

TEST(Schedules, divideLargeProgramsWhereFewValuesCross) {
  ProgramBuilder builder("p");
  Expr x(builder, builder.input(Array::z, 0));
  // Bundles of 50 values that are needed together, one thread between them.
  for (int bundle = 0; bundle < 60; ++bundle) {
    Expr sum = 0.0;
    std::vector<Expr> values;
    for (int i = 0; i < 25; ++i) values.push_back(x * (1.0 + i + 100 * bundle));
    for (const Expr& value : values) sum += value * value;
    x = sum;
  }
  output(builder, Array::zdd, 0, x);
  const Program program = builder.finish_in_canonical_order();
  const Schedule result = schedule(program);
  ASSERT_GE(result.parts.size(), 4u);
  for (const PlaceRange& part : result.parts) {
    EXPECT_GE(part.last - part.first, kLargestPart / 2);
    EXPECT_LE(part.last - part.first, kLargestPart);
  }
  std::vector<std::size_t> part_of(program.nodes.size(), 0);
  for (std::size_t p = 0; p < result.parts.size(); ++p) {
    for (std::size_t i = result.parts[p].first; i < result.parts[p].last; ++i) part_of[result.order[i]] = p;
  }
  std::vector<ValueId> crossing;
  for (const ValueId v : result.order) {
    const Node& node = program.nodes[v];
    for (int k = 0; k < arity(node.op); ++k) {
      const ValueId operand = node.operands[k];
      const bool computed = program.nodes[operand].op != Op::constant && program.nodes[operand].op != Op::input;
      if (computed && part_of[operand] != part_of[v]) crossing.push_back(operand);
    }
  }
  std::sort(crossing.begin(), crossing.end());
  crossing.erase(std::unique(crossing.begin(), crossing.end()), crossing.end());
  EXPECT_EQ(crossing.size(), result.parts.size() - 1);
}

/// A program of three sections, the middle one longer than a part.
Program three_sections() {
  ProgramBuilder builder("p");
  Expr x(builder, builder.input(Array::z, 0));
  for (const auto& [step, length] : {std::pair{Step::inertias, 3}, {Step::velocities, 1500}, {Step::solution, 2}}) {
    builder.set_section({step});
    for (int i = 0; i < length; ++i) x = x * x + (1.0 + i);
  }
  output(builder, Array::zdd, 0, x);
  return builder.finish_in_canonical_order();
}

TEST(Schedules, canFollowTheSections) {
  const Program program = three_sections();
  const Schedule result = schedule(program, {Division::by_section});
  EXPECT_EQ(result.parts.size(), 6u) << "3000 values in four parts, and one part for each other section";
  std::size_t next = 0;
  for (const PlaceRange& part : result.parts) {
    EXPECT_EQ(part.first, next);
    next = part.last;
    EXPECT_EQ(program.nodes[result.order[part.first]].section, program.nodes[result.order[part.last - 1]].section);
  }
  EXPECT_EQ(next, result.order.size());
}

TEST(ProgramText, tellsTheClockTheEndOfEverySection) {
  ProgramShape shape = bead_shape();
  shape.clock = "clock";
  shape.arguments.push_back({"clock", "mbgen::StepClock& clock"});
  const std::string text = written(three_sections(), shape);
  std::string calls = text.substr(text.rfind("Work1 w1;"));
  calls.erase(std::remove(calls.begin(), calls.end(), '\n'), calls.end());
  const std::string f = shape.function;
  EXPECT_EQ(calls, "Work1 w1;  " + f + "_1(state, w1, result);  clock.at_end_of(1);  " + f + "_2(w1);  " + f +
                       "_3(w1);  " + f + "_4(w1);  " + f + "_5(w1);  clock.at_end_of(4);  " + f +
                       "_6(w1, result);  clock.at_end_of(9);}");
}

TEST(Schedules, leaveDeadValuesOut) {
  ProgramBuilder builder("p");
  const Expr x(builder, builder.input(Array::z, 0));
  builder.append(Op::sin, x.value(builder));
  output(builder, Array::zdd, 0, cos(x));
  EXPECT_EQ(schedule(builder.finish_in_canonical_order()).order.size(), 1u);
}

}  // namespace
}  // namespace mbgen::test
