#include <map>
#include <utility>

#include "compiler/passes/passes.hpp"

namespace mbgen {

Program remove_dead_values(const Program& program) {
  const std::vector<bool> needed = needed_values(program);
  Program result = program;
  result.nodes.clear();
  result.inputs.clear();
  std::map<std::int32_t, std::int32_t> renumbered_input;
  for (std::size_t i = 0; i < needed.size(); ++i)
    if (needed[i] && program.nodes[i].op == Op::input) renumbered_input[program.nodes[i].input] = 0;
  for (auto& [input, number] : renumbered_input) {
    number = static_cast<std::int32_t>(result.inputs.size());
    result.inputs.push_back(program.inputs[static_cast<std::size_t>(input)]);
  }
  std::vector<ValueId> renumbered(program.nodes.size(), kNoValue);
  for (std::size_t i = 0; i < needed.size(); ++i) {
    if (!needed[i]) continue;
    Node node = program.nodes[i];
    for (int k = 0; k < arity(node.op); ++k) node.operands[k] = renumbered[node.operands[k]];
    if (node.op == Op::input) node.input = renumbered_input.at(node.input);
    renumbered[i] = static_cast<ValueId>(result.nodes.size());
    result.nodes.push_back(node);
  }
  for (OutputValue& output : result.outputs) output.value = renumbered[output.value];
  return verified(std::move(result));
}

}  // namespace mbgen
