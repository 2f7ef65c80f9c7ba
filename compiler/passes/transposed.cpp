#include <map>
#include <stdexcept>

#include "compiler/passes/passes.hpp"

namespace mbgen {
namespace {

/// Weights of the values of a linear program, from its outputs to its inputs.
class Transposition {
 public:
  Transposition(const Program& program, const std::vector<SlotPlace>& columns)
      : program_(program), builder_(ProgramBuilder::like(program)), weight_(program.nodes.size(), kNoValue) {
    for (const SlotPlace& column : columns) columns_.insert({column.slot, kNoValue});
    for (ValueId v = 0; v < program.nodes.size(); ++v) {
      const Node& node = program.nodes[v];
      bool moves = node.op == Op::input && columns_.contains(slot_of(node));
      for (int k = 0; k < arity(node.op); ++k) moves = moves || moves_[node.operands[k]];
      moves_.push_back(moves);
      still_.push_back(moves ? kNoValue : builder_.copy(program, node, still_));
    }
  }

  Program program(const std::vector<SlotPlace>& rows, const std::vector<SlotPlace>& columns) {
    std::map<Slot, Slot> weights;
    for (const SlotPlace& row : rows) weights.insert({row.slot, row.place});
    for (const auto& [slot, value] : program_.outputs) {
      const auto weight = weights.find(slot);
      if (weight == weights.end()) throw std::logic_error("no row of " + text_of(slot));
      builder_.set_origin(program_.nodes[value]);
      add(value, builder_.input(weight->second.group, weight->second.index));
    }
    for (ValueId v = static_cast<ValueId>(program_.nodes.size()); v-- > 0;) {
      if (!moves_[v] || weight_[v] == kNoValue) continue;
      const Node& node = program_.nodes[v];
      builder_.set_origin(node);
      if (node.op == Op::input)
        columns_.at(slot_of(node)) = weight_[v];
      else
        pass_on(node, weight_[v]);
    }
    for (const SlotPlace& column : columns) {
      const ValueId sum = columns_.at(column.slot);
      builder_.output(column.place.group, column.place.index, sum == kNoValue ? builder_.constant(0) : sum);
    }
    return optimise(remove_dead_values(builder_.finish()));
  }

 private:
  const Slot& slot_of(const Node& node) const { return program_.inputs[static_cast<std::size_t>(node.input)]; }

  void add(ValueId v, ValueId weight) {
    if (!moves_[v]) return;
    weight_[v] = weight_[v] == kNoValue ? weight : builder_.append(Op::add, weight_[v], weight);
  }

  // y = a + b: a += w, b += w        y = a - b: a += w, b -= w    y = -a: a -= w
  // y = f a: a += f w                y = a / f: a += w / f
  // y = select(c, a, b): a += select(c, w, 0), b += select(c, 0, w)
  void pass_on(const Node& node, ValueId weight) {
    const auto [a, b, c] = node.operands;
    const ValueId zero = builder_.constant(0);
    const auto is_linear = [&](bool holds) {
      if (!holds) throw std::logic_error(std::string("a program is not linear: ") + op_name(node.op));
    };
    switch (node.op) {
      case Op::add:
        add(a, weight);
        return add(b, weight);
      case Op::subtract:
        add(a, weight);
        return add(b, builder_.append(Op::negate, weight));
      case Op::negate:
        return add(a, builder_.append(Op::negate, weight));
      case Op::multiply:
        is_linear(moves_[a] != moves_[b]);
        return add(moves_[a] ? a : b, builder_.append(Op::multiply, still_[moves_[a] ? b : a], weight));
      case Op::divide:
        is_linear(moves_[a] && !moves_[b]);
        return add(a, builder_.append(Op::divide, weight, still_[b]));
      case Op::select:
        if (moves_[a]) {  // 0 where the argument of a slope without bound stands still: the slope says so by itself
          is_linear(!moves_[b]);
          return add(c, weight);
        }
        add(b, builder_.append(Op::select, still_[a], weight, zero));
        return add(c, builder_.append(Op::select, still_[a], zero, weight));
      default:
        is_linear(false);
    }
  }

  const Program& program_;
  ProgramBuilder builder_;
  std::vector<bool> moves_;          ///< values that depend on the direction
  std::vector<ValueId> still_;       ///< the others, in the transpose
  std::vector<ValueId> weight_;      ///< of values that move
  std::map<Slot, ValueId> columns_;  ///< sums of the inputs of the direction
};

}  // namespace

Program transposed(const Program& linear, const std::vector<SlotPlace>& rows, const std::vector<SlotPlace>& columns) {
  return Transposition(linear, columns).program(rows, columns);
}

}  // namespace mbgen
