#include "compiler/program/rounded.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "compiler/program/arithmetic.hpp"
#include "compiler/program/residue.hpp"

namespace mbgen {
namespace {

constexpr double kUnit = std::numeric_limits<double>::epsilon();

/// A smooth function in place of one that is in pieces or has a branch: bounds are finite at every state.
double smooth(Op op, double a, double b, double c) {
  switch (op) {
    case Op::sqrt:
    case Op::atan2:
    case Op::abs:
    case Op::min:
    case Op::max:
    case Op::select:
    case Op::floor:
    case Op::sample:
      return 1.9171 + 0.3 * std::sin(0.83 * a) + 0.21 * std::sin(1.17 * b + 0.3 * a + 0.7) +
             0.17 * std::sin(1.43 * c - 0.4 * a + 0.2 * b + 0.3);
    default:
      return apply(op, a, b, c);
  }
}

using Lanes = std::vector<std::array<Rounded, 2>>;

Rounded operand_or_none(const Node& node, const Lanes& lanes, int k, std::size_t lane) {
  return k < arity(node.op) ? lanes[node.operands[k]][lane] : Rounded{};
}

/// The value of an operation on rounded operands.
Rounded rounded(const Node& node, const std::array<Rounded, 3>& given) {
  if (node.op == Op::constant) return {node.constant, kUnit * std::abs(node.constant)};
  double operands[3] = {given[0].value, given[1].value, given[2].value};
  const auto result = [&] { return smooth(node.op, operands[0], operands[1], operands[2]); };
  const double value = result();
  double error = kUnit * std::abs(value);
  for (int k = 0; k < arity(node.op); ++k) {
    const auto [exact, off] = given[static_cast<std::size_t>(k)];
    double moved = 0;
    for (const double there : {exact - off, exact + off}) {
      operands[k] = there;
      moved = std::max(moved, std::abs(result() - value));
    }
    operands[k] = exact;
    error += moved;
  }
  return {value, error};
}

}  // namespace

std::vector<Rounded> rounded_values(const Program& program, std::span<const double> inputs) {
  const std::vector<int> widths = widths_of(program);
  Lanes lanes(program.nodes.size());
  std::vector<Rounded> all(program.nodes.size());
  for (std::size_t v = 0; v < all.size(); ++v) {
    const Node& node = program.nodes[v];
    const auto operand = [&](int k, std::size_t lane) { return lanes[node.operands[k]][lane]; };
    if (node.op == Op::input)
      lanes[v][0].value = inputs[static_cast<std::size_t>(node.input)];
    else if (node.op == Op::pack)
      lanes[v] = {operand(0, 0), operand(1, 0)};
    else if (node.op == Op::first_lane || node.op == Op::second_lane)
      lanes[v][0] = operand(0, node.op == Op::first_lane ? 0 : 1);
    else
      for (std::size_t lane = 0; lane < (widths[v] == 2 ? 2 : 1); ++lane)
        lanes[v][lane] = rounded(node, {operand_or_none(node, lanes, 0, lane), operand_or_none(node, lanes, 1, lane),
                                        operand_or_none(node, lanes, 2, lane)});
    if (widths[v] != 2) lanes[v][1] = lanes[v][0];
    all[v] = widths[v] == 2 ? Rounded{std::numeric_limits<double>::quiet_NaN(), 0} : lanes[v][0];
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
