#pragma once
// Kinds of values, and the values that the result needs.

#include "compiler/program/program.hpp"

namespace mbgen {

/// Neither a constant nor an input.
constexpr bool is_operation(const Node& node) { return node.op != Op::constant && node.op != Op::input; }

constexpr bool is_sum(const Node& node) { return node.op == Op::add || node.op == Op::subtract; }

/// A pair of two constants, which takes no operation.
inline bool is_constant_pair(const Program& program, const Node& node) {
  return node.op == Op::pack && program.nodes[node.operands[0]].op == Op::constant &&
         program.nodes[node.operands[1]].op == Op::constant;
}

/// Operations that an output needs, in program order.
inline std::vector<ValueId> live_operations(const Program& program) {
  const std::vector<bool> needed = needed_values(program);
  std::vector<ValueId> order;
  for (ValueId v = 0; v < program.nodes.size(); ++v)
    if (needed[v] && is_operation(program.nodes[v])) order.push_back(v);
  return order;
}

}  // namespace mbgen
