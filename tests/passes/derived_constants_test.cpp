// Constants that follow from parameters: taken out of programs once, with the values and operations they had.

#include <gtest/gtest.h>

#include <vector>

#include "compiler/passes/passes.hpp"

namespace mbgen {
namespace {

/// y0 = z (p0 p1 - 2) - p1, y1 = p0 p1, and y2 = 3 with nothing to derive.
Program first_program() {
  ProgramBuilder b("first");
  const ValueId z = b.input(Array::z, 0), p0 = b.input(Array::par, 0), p1 = b.input(Array::par, 1);
  const ValueId product = b.append(Op::multiply, p0, p1);
  const ValueId factor = b.append(Op::subtract, product, b.constant(2));
  b.output(Array::y, 0, b.append(Op::subtract, b.append(Op::multiply, z, factor), p1));
  b.output(Array::y, 1, product);
  b.output(Array::y, 2, b.constant(3));
  return b.finish();
}

/// y0 = sin z / (p0 p1), y1 = -(p0 p1) z.
Program second_program() {
  ProgramBuilder b("second");
  const ValueId p1 = b.input(Array::par, 1), p0 = b.input(Array::par, 0), z = b.input(Array::z, 0);
  const ValueId product = b.append(Op::multiply, p1, p0);
  b.output(Array::y, 0, b.append(Op::divide, b.append(Op::sin, z), product));
  b.output(Array::y, 1, b.append(Op::multiply, b.append(Op::negate, product), z));
  return b.finish();
}

double value_of(const Slot& slot, const std::vector<double>& z, const std::vector<double>& par,
                const std::vector<double>& derived) {
  return (slot.group == Array::z ? z : slot.group == Array::par ? par : derived).at(slot.index);
}

std::vector<double> run(const Program& program, const std::vector<double>& z, const std::vector<double>& par,
                        const std::vector<double>& derived) {
  std::vector<double> inputs;
  for (const Slot& slot : program.inputs) inputs.push_back(value_of(slot, z, par, derived));
  return interpret(program, inputs);
}

TEST(DerivedConstants, LeaveTheProgramsAndKeepTheirValues) {
  Program first = first_program(), second = second_program();
  const Program firsts = first, seconds = second;
  Program* const both[] = {&first, &second};
  const Program derived = take_out_derived(both, Array::par, "derived_constants");

  EXPECT_EQ(derived.name, "derived_constants");
  ASSERT_EQ(derived.outputs.size(), 2u) << "p0 p1 once for both programs, and p0 p1 - 2\n" << dump(derived);
  EXPECT_EQ(count_operations(derived).total(), 2);
  EXPECT_EQ(count_operations(first).total(), 2) << dump(first);
  EXPECT_EQ(count_operations(second).total(), count_operations(seconds).total() - 1) << dump(second);

  const std::vector<double> z{0.7}, par{1.25, -3};
  const std::vector<double> constants = run(derived, z, par, {});
  EXPECT_EQ(run(first, z, par, constants), run(firsts, z, par, {}));
  EXPECT_EQ(run(second, z, par, constants), run(seconds, z, par, {}));
}

TEST(DerivedConstants, AreNoneWithoutParametersOrWithParametersAlone) {
  ProgramBuilder b("plain");
  const ValueId z = b.input(Array::z, 0), p = b.input(Array::par, 4);
  b.output(Array::y, 0, b.append(Op::multiply, p, z));
  b.output(Array::y, 1, p);
  Program plain = b.finish(), nothing;
  const std::string before = dump(plain);
  Program* const both[] = {&plain, &nothing};
  EXPECT_TRUE(take_out_derived(both, Array::par, "derived_constants").outputs.empty());
  EXPECT_EQ(dump(plain), before);
  EXPECT_TRUE(nothing.nodes.empty());
}

}  // namespace
}  // namespace mbgen
