#pragma once
// Small programs of z[0] to z[6], and what pairs make of them.

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <vector>

#include "compiler/passes/passes.hpp"
#include "compiler/program/kinds.hpp"

namespace mbgen {

inline Program program_of(const std::function<std::vector<Expr>(const std::vector<Expr>&)>& body) {
  ProgramBuilder builder("f");
  std::vector<Expr> z;
  for (int i = 0; i < 7; ++i) z.emplace_back(builder, builder.input(Array::z, i));
  builder.set_section({Step::inertias});
  int index = 0;
  for (const Expr& y : body(z)) builder.output(Array::y, index++, y.value(builder));
  return remove_dead_values(builder.finish());
}

/// Operations that are done on pairs and on numbers; those that pack numbers and take lanes out.
struct Counts {
  int pairs = 0, numbers = 0, packs = 0, lanes = 0;
};

inline Counts counts_of(const Program& program) {
  const std::vector<int> widths = widths_of(program);
  Counts counts;
  for (const ValueId v : live_operations(program)) {
    const Node& node = program.nodes[v];
    if (node.op == Op::negate || is_constant_pair(program, node)) continue;
    if (node.op == Op::pack)
      ++counts.packs;
    else if (node.op == Op::first_lane || node.op == Op::second_lane)
      ++counts.lanes;
    else
      ++(widths[v] == 2 ? counts.pairs : counts.numbers);
  }
  return counts;
}

/// Inputs 0.3 + scale * index.
inline std::vector<double> inputs_of(const Program& program, double scale) {
  std::vector<double> inputs;
  for (const Slot& slot : program.inputs) inputs.push_back(0.3 + scale * slot.index);
  return inputs;
}

inline void expect_values(const Program& program, const Program& other, const std::vector<double>& inputs,
                          double tolerance) {
  ASSERT_EQ(program.inputs, other.inputs);
  const std::vector<double> expected = interpret(program, inputs), found = interpret(other, inputs);
  for (std::size_t i = 0; i < expected.size(); ++i)
    EXPECT_NEAR(found[i], expected[i], tolerance * (1 + std::abs(expected[i]))) << i;
}

}  // namespace mbgen
