#include "compiler/passes/kinds.hpp"

namespace mbgen {

std::vector<ValueId> live_operations(const Program& program) {
  const std::vector<bool> needed = needed_values(program);
  std::vector<ValueId> order;
  for (ValueId v = 0; v < program.nodes.size(); ++v)
    if (needed[v] && is_operation(program.nodes[v])) order.push_back(v);
  return order;
}

}  // namespace mbgen
