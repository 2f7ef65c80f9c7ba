#include <algorithm>
#include <span>
#include <utility>
#include <vector>

#include "compiler/passes/passes.hpp"
#include "compiler/program/kinds.hpp"
#include "compiler/program/rewrite.hpp"

namespace mbgen {
namespace {

/// The sums that need a product, empty when something else needs it too.
std::vector<std::vector<ValueId>> sums_of_products(const Program& program) {
  std::vector<std::vector<ValueId>> sums(program.nodes.size());
  std::vector<bool> is_kept(program.nodes.size(), false);
  for (const OutputValue& output : program.outputs) is_kept[output.value] = true;
  for (std::size_t i = 0; i < program.nodes.size(); ++i) {
    const Node& node = program.nodes[i];
    for (int k = 0; k < arity(node.op); ++k) {
      const ValueId operand = node.operands[k];
      const Node& given = program.nodes[operand];
      if (!is_sum(node) || node.operands[0] == node.operands[1] || given.op != Op::multiply || given.label >= 0)
        is_kept[operand] = true;
    }
  }
  for (std::size_t i = 0; i < program.nodes.size(); ++i) {
    const Node& node = program.nodes[i];
    for (int k = 0; k < arity(node.op); ++k)
      if (!is_kept[node.operands[k]]) sums[node.operands[k]].push_back(static_cast<ValueId>(i));
  }
  return sums;
}

/// Per node, which operand goes into it, -1 for none. A product goes into all sums that need it or stays; the later of
/// two in one sum goes first, for the other is known before.
std::vector<int> contracted_operands(const Program& program) {
  const std::vector<std::vector<ValueId>> sums = sums_of_products(program);
  std::vector<int> contracted(program.nodes.size(), -1);
  for (std::size_t product = sums.size(); product-- > 0;) {
    const bool all_free = std::ranges::all_of(sums[product], [&](ValueId sum) { return contracted[sum] < 0; });
    if (!all_free) continue;
    for (const ValueId sum : sums[product]) contracted[sum] = program.nodes[sum].operands[0] == product ? 0 : 1;
  }
  return contracted;
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
  const std::vector<int> operands = contracted_operands(program);
  return remove_dead_values(
      rewritten(program, [&](ProgramBuilder& builder, ValueId v, std::span<const ValueId> renamed) {
        return operands[v] < 0 ? kNoValue : contracted(builder, program, program.nodes[v], operands[v], renamed);
      }));
}

}  // namespace mbgen
