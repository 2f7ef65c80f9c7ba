#include "compiler/program/rounded.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "compiler/program/arithmetic.hpp"
#include "compiler/program/residue.hpp"

namespace mbgen {
namespace {

/// A smooth function in place of one that is in pieces or has a branch, odd or even as that one is: values that are
/// equal with it are equal whatever piece they are in.
double smooth(Op op, double a, double b, double c) {
  const double number = static_cast<double>(op);
  switch (op) {
    case Op::abs:
      return 1.7134 + 0.41 * std::cos(1.37 * a);
    case Op::atan2:
      return std::sin(1.31 * a) * (1.7 + 0.4 * std::cos(0.9 * b) + 0.3 * std::sin(1.1 * b));
    case Op::sqrt:
    case Op::min:
    case Op::max:
    case Op::select:
    case Op::floor:
    case Op::sample:
      return 1.9171 + 0.3 * std::sin(0.83 * a + 0.1 * number) + 0.21 * std::sin(1.17 * b + 0.3 * a + 0.7) +
             0.17 * std::sin(1.43 * c - 0.4 * a + 0.2 * b + 0.3);
    default:
      return apply(op, a, b, c);
  }
}

}  // namespace

std::vector<Rounded> rounded_values(const Program& program, std::span<const double> inputs) {
  constexpr double kUnit = std::numeric_limits<double>::epsilon();
  std::vector<Rounded> all(program.nodes.size());
  for (std::size_t v = 0; v < all.size(); ++v) {
    const Node& node = program.nodes[v];
    if (node.op == Op::input) {
      all[v].value = inputs[static_cast<std::size_t>(node.input)];
      continue;
    }
    double operands[3] = {0, 0, 0};
    const auto result = [&] {
      if (node.op == Op::constant) return node.constant;
      return smooth(node.op, operands[0], operands[1], operands[2]);
    };
    for (int k = 0; k < arity(node.op); ++k) operands[k] = all[node.operands[k]].value;
    const double value = result();
    double error = kUnit * std::abs(value);
    for (int k = 0; k < arity(node.op); ++k) {
      const auto [exact, off] = all[node.operands[k]];
      double moved = 0;
      for (const double there : {exact - off, exact + off}) {
        operands[k] = there;
        moved = std::max(moved, std::abs(result() - value));
      }
      operands[k] = exact;
      error += moved;
    }
    all[v] = {value, error};
  }
  return all;
}

std::vector<double> ordinary_inputs(const Program& program, std::size_t number) {
  std::vector<double> inputs;
  for (const Slot& slot : program.inputs) {
    const Residue random = random_residue(number * program.inputs.size() + inputs.size());
    const double unit = static_cast<double>(random.parts[0] % 2048) / 1024 - 1;  // -1 to 1
    const bool is_position = slot.group.array == Array::z || slot.group.array == Array::x;
    const bool is_scale = slot.group.array == Array::par || slot.group.array == Array::t;
    inputs.push_back(is_position ? 0.2 * unit : is_scale ? 1 + 0.5 * unit : unit);
  }
  return inputs;
}

}  // namespace mbgen
