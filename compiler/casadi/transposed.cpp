// The transpose of a program that is linear in its direction.
#include <algorithm>
#include <stdexcept>

#include "compiler/casadi/explicit_motion.hpp"
#include "compiler/passes/passes.hpp"

namespace mbgen {
namespace {

/// Weights of the values of a linear program, from its outputs to its inputs.
class Transposition {
 public:
  explicit Transposition(const Program& program)
      : program_(program),
        builder_(ProgramBuilder::like(program)),
        moves_(along_direction(program)),
        weight_(program.nodes.size(), kNoValue) {
    for (ValueId v = 0; v < program.nodes.size(); ++v)
      still_.push_back(moves_[v] ? kNoValue : builder_.copy(program, program.nodes[v], still_));
  }

  Program program(const std::vector<Slot>& rows, int arguments) {
    for (const auto& [slot, value] : program_.outputs) {
      const auto row = std::ranges::find(rows, slot);
      if (row == rows.end()) throw std::logic_error("no row of " + text_of(slot));
      add(value, builder_.input(Array::seed, static_cast<int>(row - rows.begin())));
    }
    std::vector<ValueId> sums(static_cast<std::size_t>(arguments), kNoValue);
    for (ValueId v = static_cast<ValueId>(program_.nodes.size()); v-- > 0;) {
      if (!moves_[v] || weight_[v] == kNoValue) continue;
      const Node& node = program_.nodes[v];
      builder_.set_origin(node);
      if (node.op == Op::input)
        sums[static_cast<std::size_t>(slot_of(node).index)] = weight_[v];
      else
        pass_on(node, weight_[v]);
    }
    for (int j = 0; j < arguments; ++j) {
      const ValueId sum = sums[static_cast<std::size_t>(j)];
      builder_.output(derivative_of(Array::seed), j, sum == kNoValue ? builder_.constant(0) : sum);
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
        is_linear(!moves_[a]);
        add(b, builder_.append(Op::select, still_[a], weight, zero));
        return add(c, builder_.append(Op::select, still_[a], zero, weight));
      default:
        is_linear(false);
    }
  }

  const Program& program_;
  ProgramBuilder builder_;
  std::vector<bool> moves_;      ///< values that depend on the direction
  std::vector<ValueId> still_;   ///< the others, in the transpose
  std::vector<ValueId> weight_;  ///< of values that move
};

}  // namespace

Program transposed(const Program& directions, const std::vector<Slot>& rows, int arguments) {
  return Transposition(directions).program(rows, arguments);
}

}  // namespace mbgen
