#include "compiler/passes/shorten_lifetimes.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "compiler/passes/kinds.hpp"

namespace mbgen {
namespace {

/// Numbers of uses, and of the last user per value; outputs live to the end.
struct Uses {
  std::vector<int> count;
  std::vector<ValueId> first, last;  ///< users, kNoValue for none

  explicit Uses(const Program& program)
      : count(program.nodes.size(), 0), first(program.nodes.size(), kNoValue), last(program.nodes.size(), kNoValue) {
    for (ValueId v = 0; v < program.nodes.size(); ++v)
      for (int k = 0; k < arity(program.nodes[v].op); ++k) {
        const ValueId operand = program.nodes[v].operands[k];
        ++count[operand];
        if (first[operand] == kNoValue) first[operand] = v;
        last[operand] = v;
      }
  }
};

/// The program with its values sorted by key, those of one key as they were.
Program sorted(const Program& program, const std::vector<ValueId>& key) {
  std::vector<ValueId> order(program.nodes.size());
  std::iota(order.begin(), order.end(), ValueId{0});
  std::stable_sort(order.begin(), order.end(), [&](ValueId a, ValueId b) { return key[a] < key[b]; });
  Program result = program;
  std::vector<ValueId> renamed(program.nodes.size());
  for (ValueId place = 0; place < order.size(); ++place) renamed[order[place]] = place;
  for (ValueId place = 0; place < order.size(); ++place) {
    Node node = program.nodes[order[place]];
    const Node& neighbour = program.nodes[key[order[place]]];
    if (is_operation(node) && is_operation(neighbour)) {
      node.section = neighbour.section;
      node.owner = neighbour.owner;
    }
    for (int k = 0; k < arity(node.op); ++k) node.operands[k] = renamed[node.operands[k]];
    result.nodes[place] = node;
  }
  for (OutputValue& output : result.outputs) output.value = renamed[output.value];
  return verified(std::move(result));
}

/// Whether the value, computed as soon as its operands are known, makes no more of them live on.
bool comes_early(const Program& program, const Uses& uses, ValueId value) {
  const Node& node = program.nodes[value];
  const auto lives_on = [&](ValueId operand) { return uses.count[operand] > 1; };
  if (is_sum(node)) return !lives_on(node.operands[0]) || !lives_on(node.operands[1]);
  if (is_contracted(node)) return !lives_on(node.operands[node.op == Op::subtract_product ? 0 : 2]);
  if (node.op != Op::multiply || uses.count[value] != 1) return false;
  const Node& user = program.nodes[uses.first[value]];
  return is_sum(user) || is_contracted(user);
}

/// Sums of values that have no other use, and the products in them, as early as their operands allow.
Program with_early_sums(const Program& program) {
  const Uses uses(program);
  std::vector<ValueId> key(program.nodes.size());
  for (ValueId v = 0; v < program.nodes.size(); ++v) {
    key[v] = v;
    if (!comes_early(program, uses, v)) continue;
    const Node& node = program.nodes[v];
    key[v] = 0;
    for (int k = 0; k < arity(node.op); ++k) key[v] = std::max(key[v], key[node.operands[k]]);
  }
  return sorted(program, key);
}

/// Values that end the life of no operand, as late as their first use allows.
Program with_late_values(const Program& program) {
  const Uses uses(program);
  std::vector<ValueId> key(program.nodes.size()), needed(program.nodes.size(), kNoValue);
  for (ValueId v = static_cast<ValueId>(program.nodes.size()); v-- > 0;) {
    const Node& node = program.nodes[v];
    const bool is_angle = node.op == Op::sin || node.op == Op::cos;  // they are taken together
    bool stays = !is_operation(node) || needed[v] == kNoValue || is_angle;
    for (int k = 0; k < arity(node.op); ++k) {
      const ValueId operand = node.operands[k];
      stays = stays || (is_operation(program.nodes[operand]) && uses.last[operand] == v);
    }
    key[v] = stays ? v : needed[v];
    for (int k = 0; k < arity(node.op); ++k) needed[node.operands[k]] = std::min(needed[node.operands[k]], key[v]);
  }
  return sorted(program, key);
}

}  // namespace

Program shorten_lifetimes(const Program& program) { return with_late_values(with_early_sums(program)); }

}  // namespace mbgen
