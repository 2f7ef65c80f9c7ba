#include <algorithm>
#include <array>
#include <utility>

#include "compiler/program/program.hpp"

namespace mbgen {

std::vector<int> widths_of(const Program& program) {
  std::vector<int> widths(program.nodes.size(), 0);
  for (std::size_t v = 0; v < widths.size(); ++v) {
    const Node& node = program.nodes[v];
    if (node.op == Op::pack) {
      widths[v] = 2;
    } else if (node.op == Op::input || node.op == Op::first_lane || node.op == Op::second_lane) {
      widths[v] = 1;
    } else {
      for (int k = 0; k < arity(node.op); ++k) widths[v] = std::max(widths[v], widths[node.operands[k]]);
    }
  }
  return widths;
}

bool has_pairs(const Program& program) {
  return std::ranges::any_of(program.nodes, [](const Node& node) { return node.op == Op::pack; });
}

Program unfolded(const Program& program) {
  const std::vector<int> widths = widths_of(program);
  std::vector<std::array<ValueId, 2>> lanes(program.nodes.size(), {kNoValue, kNoValue});  // of each value
  Program result = program;
  result.nodes.clear();
  // Nodes are written as they stand: rules of the builder may fold numbers, and round otherwise.
  for (std::size_t v = 0; v < program.nodes.size(); ++v) {
    const Node& node = program.nodes[v];
    const auto operand = [&](int k, std::size_t lane) { return lanes[node.operands[k]][lane]; };
    if (node.op == Op::pack) {
      lanes[v] = {operand(0, 0), operand(1, 0)};
    } else if (node.op == Op::first_lane) {
      lanes[v] = {operand(0, 0), operand(0, 0)};
    } else if (node.op == Op::second_lane) {
      lanes[v] = {operand(0, 1), operand(0, 1)};
    } else {
      for (std::size_t lane = 0; lane < (widths[v] == 2 ? 2 : 1); ++lane) {
        Node copy = node;
        for (int k = 0; k < arity(node.op); ++k) copy.operands[k] = operand(k, lane);
        if (lane == 1 && node.mirrored != Owner{}) copy.owner = node.mirrored;
        if (lane == 1) copy.label = node.mirrored_label;
        copy.mirrored = {};
        copy.mirrored_label = -1;
        lanes[v][lane] = static_cast<ValueId>(result.nodes.size());
        result.nodes.push_back(copy);
      }
      if (widths[v] != 2) lanes[v][1] = lanes[v][0];
    }
  }
  for (OutputValue& output : result.outputs) output.value = lanes[output.value][0];
  return verified(std::move(result));
}

}  // namespace mbgen
