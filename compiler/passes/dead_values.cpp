#include <algorithm>

#include "compiler/passes/passes.hpp"

namespace mbgen {

Program remove_dead_values(Program program) {
  const std::vector<bool> needed = needed_values(program);
  std::vector<std::int32_t> renumbered_input(program.inputs.size(), -1);
  for (std::size_t i = 0; i < needed.size(); ++i)
    if (needed[i] && program.nodes[i].op == Op::input)
      renumbered_input[static_cast<std::size_t>(program.nodes[i].input)] = 0;
  if (std::ranges::count(needed, false) + std::ranges::count(renumbered_input, -1) == 0) return program;
  std::size_t inputs = 0;
  for (std::size_t i = 0; i < renumbered_input.size(); ++i) {
    if (renumbered_input[i] < 0) continue;
    renumbered_input[i] = static_cast<std::int32_t>(inputs);
    program.inputs[inputs++] = program.inputs[i];
  }
  program.inputs.resize(inputs);
  std::vector<ValueId> renumbered(program.nodes.size(), kNoValue);
  std::size_t count = 0;
  for (std::size_t i = 0; i < needed.size(); ++i) {
    if (!needed[i]) continue;
    Node& node = program.nodes[count] = program.nodes[i];
    for (int k = 0; k < arity(node.op); ++k) node.operands[k] = renumbered[node.operands[k]];
    if (node.op == Op::input) node.input = renumbered_input[static_cast<std::size_t>(node.input)];
    renumbered[i] = static_cast<ValueId>(count++);
  }
  program.nodes.resize(count);
  for (OutputValue& output : program.outputs) output.value = renumbered[output.value];
  return program;
}

}  // namespace mbgen
