#include "compiler/passes/contract.hpp"

#include <span>
#include <utility>

#include "compiler/passes/dead_values.hpp"

namespace mbgen {
namespace {

/// Products that one value needs and nothing else, one flag per node.
std::vector<bool> single_products(const Program& program) {
  std::vector<int> users(program.nodes.size(), 0);
  for (const Node& node : program.nodes) {
    for (int k = 0; k < arity(node.op); ++k) ++users[node.operands[k]];
  }
  for (const OutputValue& output : program.outputs) users[output.value] += 2;
  std::vector<bool> single(program.nodes.size(), false);
  for (std::size_t i = 0; i < users.size(); ++i) {
    single[i] = users[i] == 1 && program.nodes[i].op == Op::multiply && program.nodes[i].label < 0;
  }
  return single;
}

/// Which operand of a sum or difference goes into it, -1 for none.
int contracted_operand(const Node& node, const std::vector<bool>& single) {
  if (node.op != Op::add && node.op != Op::subtract) return -1;
  const bool first = single[node.operands[0]], second = single[node.operands[1]];
  if (first && second) return node.operands[0] > node.operands[1] ? 0 : 1;
  return first ? 0 : second ? 1 : -1;
}

// a b + c -> muladd(a, b, c)
// a b - c -> mulsub(a, b, c)
// c - a b -> submul(c, a, b)
ValueId contracted(ProgramBuilder& builder, const Program& program, const Node& sum, int operand,
                   std::span<const ValueId> renamed) {
  const Node& product = program.nodes[sum.operands[operand]];
  const ValueId a = renamed[product.operands[0]], b = renamed[product.operands[1]];
  const ValueId c = renamed[sum.operands[1 - operand]];
  if (sum.op == Op::add) return builder.append(Op::multiply_add, a, b, c);
  return operand == 0 ? builder.append(Op::multiply_subtract, a, b, c) : builder.append(Op::subtract_product, c, a, b);
}

}  // namespace

Program contract(const Program& program) {
  const std::vector<bool> single = single_products(program);
  ProgramBuilder builder = ProgramBuilder::like(program);
  std::vector<ValueId> renamed;
  renamed.reserve(program.nodes.size());
  for (const Node& node : program.nodes) {
    const int operand = contracted_operand(node, single);
    if (operand < 0) {
      renamed.push_back(builder.copy(program, node, renamed));
      continue;
    }
    builder.set_section(program.sections[node.section]);
    builder.set_block(program.blocks[node.block]);
    const ValueId value = contracted(builder, program, node, operand, renamed);
    if (node.label >= 0) builder.label(value, program.labels[static_cast<std::size_t>(node.label)]);
    renamed.push_back(value);
  }
  for (const auto& [slot, value] : program.outputs) builder.output(slot.group, slot.index, renamed[value]);
  return remove_dead_values(builder.finish());
}

}  // namespace mbgen
