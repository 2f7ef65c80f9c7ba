#include "compiler/passes/passes.hpp"

namespace mbgen {
namespace {

/// From this many divisions by one value on, a reciprocal and products are cheaper.
constexpr int kWorthwhile = 3;

std::vector<int> count_divisions_by(const Program& program) {
  std::vector<int> count(program.nodes.size(), 0);
  for (const Node& node : program.nodes) {
    if (node.op == Op::divide) ++count[node.operands[1]];
  }
  return count;
}

}  // namespace

Program merge_divisions(const Program& program) {
  const std::vector<int> divisions_by = count_divisions_by(program);
  ProgramBuilder builder = ProgramBuilder::like(program);
  std::vector<ValueId> renamed;
  renamed.reserve(program.nodes.size());
  for (const Node& node : program.nodes) {
    if (node.op != Op::divide || divisions_by[node.operands[1]] < kWorthwhile) {
      renamed.push_back(builder.copy(program, node, renamed));
      continue;
    }
    // a / d -> a * (1 / d)
    builder.set_origin(node);
    const ValueId reciprocal = builder.append(Op::divide, builder.constant(1), renamed[node.operands[1]]);
    const ValueId quotient = builder.append(Op::multiply, renamed[node.operands[0]], reciprocal);
    if (node.label >= 0) builder.label(quotient, program.labels[static_cast<std::size_t>(node.label)]);
    renamed.push_back(quotient);
  }
  for (const auto& [slot, value] : program.outputs) builder.output(slot.group, slot.index, renamed[value]);
  return builder.finish();
}

}  // namespace mbgen
