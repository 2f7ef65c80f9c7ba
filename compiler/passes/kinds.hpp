#pragma once
// Kinds of values that passes tell apart. Inside the passes room.

#include "compiler/program/program.hpp"

namespace mbgen {

/// Neither a constant nor an input.
constexpr bool is_operation(const Node& node) { return node.op != Op::constant && node.op != Op::input; }

constexpr bool is_sum(const Node& node) { return node.op == Op::add || node.op == Op::subtract; }

/// A sum with a product in it.
constexpr bool is_contracted(const Node& node) {
  return node.op == Op::multiply_add || node.op == Op::multiply_subtract || node.op == Op::subtract_product;
}

/// Operations that an output needs, in program order.
std::vector<ValueId> live_operations(const Program& program);

}  // namespace mbgen
