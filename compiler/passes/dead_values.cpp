#include "compiler/passes/passes.hpp"

#include <stdexcept>

namespace mbgen {

Program remove_dead_values(const Program& program) {
  std::vector<bool> live(program.nodes.size(), false);
  for (const OutputValue& output : program.outputs) live[output.value] = true;
  for (std::size_t i = program.nodes.size(); i-- > 0;)
    if (live[i])
      for (int k = 0; k < arity(program.nodes[i].op); ++k) live[program.nodes[i].operands[k]] = true;
  Program result = program;
  result.nodes.clear();
  result.inputs.clear();
  std::vector<ValueId> moved(program.nodes.size(), kNoValue);
  for (std::size_t i = 0; i < program.nodes.size(); ++i) {
    if (!live[i]) continue;
    Node node = program.nodes[i];
    for (int k = 0; k < arity(node.op); ++k) node.operands[k] = moved[node.operands[k]];
    if (node.op == Op::input) {
      result.inputs.push_back(program.inputs[node.input]);
      node.input = static_cast<std::int32_t>(result.inputs.size() - 1);
    }
    moved[i] = static_cast<ValueId>(result.nodes.size());
    result.nodes.push_back(node);
  }
  for (OutputValue& output : result.outputs) output.value = moved[output.value];
  if (const std::string fault = verify(result); !fault.empty()) throw std::logic_error("remove_dead_values: " + fault);
  return result;
}

Program optimise(const Program& program) { return remove_dead_values(program); }

}  // namespace mbgen
