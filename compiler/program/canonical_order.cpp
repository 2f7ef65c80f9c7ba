#include "compiler/program/canonical_order.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "compiler/program/arithmetic.hpp"
#include "compiler/program/rules.hpp"

namespace mbgen {
namespace {

using Rank = std::uint32_t;

/// Per node, the longest chain of operands of the same moment below it.
std::vector<std::uint32_t> depths_within_moments(const Program& program, std::span<const std::uint32_t> moments) {
  std::vector<std::uint32_t> depths(program.nodes.size(), 0);
  for (std::size_t i = 0; i < depths.size(); ++i) {
    const Node& node = program.nodes[i];
    for (int k = 0; k < arity(node.op); ++k) {
      if (moments[node.operands[k]] == moments[i]) depths[i] = std::max(depths[i], depths[node.operands[k]] + 1);
    }
  }
  return depths;
}

/// Ranks of the operands, in ascending order when they commute.
std::array<Rank, 3> operand_ranks(const Node& node, std::span<const Rank> ranks) {
  std::array<Rank, 3> result = {0, 0, 0};
  for (std::size_t k = 0; k < static_cast<std::size_t>(arity(node.op)); ++k) result[k] = ranks[node.operands[k]];
  if (is_commutative(node.op) && result[1] < result[0]) std::swap(result[0], result[1]);
  return result;
}

/// A node of a moment as it is sorted.
struct Placed {
  std::uint32_t depth = 0;
  ValueId value = kNoValue;
  Op op = Op::constant;
  std::array<Rank, 3> operands = {0, 0, 0};  ///< known when its depth is reached
};

/// By operation, then constants by value and name, inputs by slot, operations by the ranks of their operands.
bool comes_first(const Program& program, const Placed& a, const Placed& b) {
  if (a.op != b.op) return a.op < b.op;
  const Node &one = program.nodes[a.value], &other = program.nodes[b.value];
  if (a.op == Op::input)
    return program.inputs[static_cast<std::size_t>(one.input)] < program.inputs[static_cast<std::size_t>(other.input)];
  if (a.op != Op::constant) return a.operands < b.operands;
  if (one.constant != other.constant) return one.constant < other.constant;
  const auto name = [&](const Node& node) {
    return node.label < 0 ? std::string_view() : program.constants[static_cast<std::size_t>(node.label)].name;
  };
  return name(one) < name(other);
}

/// Calls use(first, last) for the nodes of each moment.
template <class Use>
void each_moment(std::span<const std::uint32_t> moments, const Use& use) {
  for (std::size_t first = 0, last = 0; first < moments.size(); first = last) {
    while (last < moments.size() && moments[last] == moments[first]) ++last;
    use(first, last);
  }
}

/// Places of the nodes in an order by computation: by moment, depth, operation and the ranks of the operands.
std::vector<Rank> ranks_of_nodes(const Program& program, std::span<const std::uint32_t> moments) {
  const std::vector<std::uint32_t> depths = depths_within_moments(program, moments);
  std::vector<Rank> ranks(program.nodes.size());
  std::vector<Placed> order;
  each_moment(moments, [&](std::size_t first, std::size_t last) {
    order.clear();
    for (std::size_t i = first; i < last; ++i)
      order.push_back({depths[i], static_cast<ValueId>(i), program.nodes[i].op});
    std::ranges::sort(order, {}, &Placed::depth);
    for (auto begin = order.begin(); begin != order.end();) {
      const auto end = std::find_if(begin, order.end(), [&](const Placed& node) { return node.depth != begin->depth; });
      for (auto node = begin; node != end; ++node) node->operands = operand_ranks(program.nodes[node->value], ranks);
      std::sort(begin, end, [&](const Placed& a, const Placed& b) { return comes_first(program, a, b); });
      for (; begin != end; ++begin) ranks[begin->value] = static_cast<Rank>(first + (begin - order.begin()));
    }
  });
  return ranks;
}

bool is_labelled(const Node& node) { return node.op != Op::constant && node.label >= 0; }

/// Starting points of the walk of a moment: its named values, in the order of naming, then values without users in the
/// moment.
std::vector<ValueId> starts_of_moments(const Program& program, std::span<const std::uint32_t> moments,
                                       std::span<const Rank> ranks) {
  std::vector<bool> is_start(program.nodes.size(), true);
  for (std::size_t i = 0; i < is_start.size(); ++i) {
    const Node& node = program.nodes[i];
    for (int k = 0; k < arity(node.op); ++k) {
      const ValueId operand = node.operands[k];
      if (moments[operand] == moments[i] && !is_labelled(program.nodes[operand])) is_start[operand] = false;
    }
  }
  std::vector<ValueId> starts;
  each_moment(moments, [&](std::size_t first, std::size_t last) {
    const std::size_t before = starts.size();
    for (std::size_t i = first; i < last; ++i)
      if (is_start[i]) starts.push_back(static_cast<ValueId>(i));
    std::ranges::sort(starts.begin() + static_cast<std::ptrdiff_t>(before), starts.end(), {}, [&](ValueId value) {
      const std::int32_t label = is_labelled(program.nodes[value]) ? program.nodes[value].label : -1;
      return std::tuple(label < 0, label, ranks[value]);
    });
  });
  return starts;
}

/// The operands that follow from `value`, first one last, so that a stack takes it first.
void push_operands(const Node& node, std::span<const Rank> ranks, std::vector<ValueId>& stack) {
  std::array<ValueId, 3> operands = {node.operands[0], node.operands[1], node.operands[2]};
  if (is_commutative(node.op) && ranks[operands[1]] < ranks[operands[0]]) std::swap(operands[0], operands[1]);
  for (int k = arity(node.op); k-- > 0;) stack.push_back(operands[static_cast<std::size_t>(k)]);
}

/// Operands before users, depth first from the starts.
std::vector<ValueId> depth_first(const Program& program, std::span<const ValueId> starts, std::span<const Rank> ranks) {
  std::vector<ValueId> order, stack;
  std::vector<bool> entered(program.nodes.size(), false), placed(program.nodes.size(), false);
  for (const ValueId start : starts) {
    stack.push_back(start);
    while (!stack.empty()) {
      const ValueId value = stack.back();
      if (!entered[value]) {
        entered[value] = true;
        push_operands(program.nodes[value], ranks, stack);
        continue;
      }
      stack.pop_back();
      if (!placed[value]) order.push_back(value);
      placed[value] = true;
    }
  }
  return order;
}

/// Named constants in the order in which operations take them first: compilers name several in one expression in orders
/// of their own.
void order_constants(Program& program) {
  std::vector<NamedConstant> constants;
  std::vector<std::int32_t> place(program.constants.size(), -1);
  const auto meet_label = [&](auto& meet_operand, std::int32_t label) -> void {
    if (label < 0 || place[static_cast<std::size_t>(label)] >= 0) return;
    NamedConstant& constant = program.constants[static_cast<std::size_t>(label)];
    for (const std::int32_t operand : constant.labels) meet_operand(meet_operand, operand);
    place[static_cast<std::size_t>(label)] = static_cast<std::int32_t>(constants.size());
    constants.push_back(std::move(constant));
  };
  const auto meet = [&](const Node& node) {
    if (node.op == Op::constant) meet_label(meet_label, node.label);
  };
  for (const Node& node : program.nodes)
    for (int k = 0; k < arity(node.op); ++k) meet(program.nodes[node.operands[k]]);
  for (const Node& node : program.nodes) meet(node);
  for (Node& node : program.nodes)
    if (node.op == Op::constant && node.label >= 0) node.label = place[static_cast<std::size_t>(node.label)];
  for (NamedConstant& constant : constants)
    for (std::int32_t& operand : constant.labels)
      if (operand >= 0) operand = place[static_cast<std::size_t>(operand)];
  program.constants = std::move(constants);
}

}  // namespace

Program in_canonical_order(Program program, std::span<const std::uint32_t> moments) {
  const std::vector<Rank> ranks = ranks_of_nodes(program, moments);
  const std::vector<ValueId> order = depth_first(program, starts_of_moments(program, moments, ranks), ranks);
  std::vector<ValueId> renumbered(program.nodes.size(), kNoValue);
  for (std::size_t i = 0; i < order.size(); ++i) renumbered[order[i]] = static_cast<ValueId>(i);
  const std::vector<Node> as_recorded = program.nodes;
  for (std::size_t i = 0; i < order.size(); ++i) {
    Node& node = program.nodes[i] = as_recorded[order[i]];
    for (int k = 0; k < arity(node.op); ++k) node.operands[k] = renumbered[node.operands[k]];
    order_operands(program.nodes, node.op, node.operands);
  }
  for (OutputValue& output : program.outputs) output.value = renumbered[output.value];
  order_constants(program);
  return program;
}

}  // namespace mbgen
