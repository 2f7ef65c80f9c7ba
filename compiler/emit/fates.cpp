#include "compiler/emit/fates.hpp"

namespace mbgen {
namespace {

bool is_angle_pair(const Program& program, const Arrangement& arrangement, ValueId a, ValueId b) {
  if (arrangement.array_calls.place[a].call >= 0 || arrangement.array_calls.place[b].call >= 0) return false;
  const Node& first = program.nodes[a];
  const Node& second = program.nodes[b];
  return ((first.op == Op::sin && second.op == Op::cos) || (first.op == Op::cos && second.op == Op::sin)) &&
         first.operands[0] == second.operands[0] && first.section == second.section;
}

}  // namespace

std::vector<Fate> decide_fates(const Program& program, const Arrangement& arrangement) {
  std::vector<Fate> fates(program.nodes.size());
  for (std::size_t p = 0; p < arrangement.parts.size(); ++p) {
    for (std::size_t i = arrangement.parts[p].first; i < arrangement.parts[p].last; ++i) {
      const ValueId v = arrangement.order[i];
      const Node& node = program.nodes[v];
      fates[v].part = p;
      for (int k = 0; k < arity(node.op); ++k) {
        Fate& operand = fates[node.operands[k]];
        ++operand.users;
        operand.user = v;
        if (operand.part != p) operand.crosses = true;
      }
      if (i > 0 && is_angle_pair(program, arrangement, arrangement.order[i - 1], v)) {
        fates[v].partner = arrangement.order[i - 1];
        fates[arrangement.order[i - 1]].partner = v;
      }
    }
  }
  return fates;
}

bool can_be_inlined(const Program& program, const std::vector<Fate>& fates, ValueId value) {
  const Fate& fate = fates[value];
  const Node& node = program.nodes[value];
  if (fate.users != 1 || fate.crosses || fate.partner != kNoValue || !fate.outputs.empty() || node.label >= 0) {
    return false;
  }
  const Node& user = program.nodes[fate.user];
  return user.section == node.section && user.block == node.block;
}

std::vector<std::size_t> section_ends(const Program& program, const Arrangement& arrangement) {
  std::vector<std::size_t> ends(program.sections.size(), 0);
  for (std::size_t i = 0; i < arrangement.order.size(); ++i) ends[program.nodes[arrangement.order[i]].section] = i;
  return ends;
}

}  // namespace mbgen
