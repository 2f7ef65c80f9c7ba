#include "compiler/program/rounded.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

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

/// The value of a function of the first `count` of rounded operands.
template <class Function>
Rounded rounded_by(const Function& function, int count, const std::array<Rounded, 3>& given) {
  double operands[3] = {given[0].value, given[1].value, given[2].value};
  const auto result = [&] { return function(operands[0], operands[1], operands[2]); };
  const double value = result();
  double error = kUnit * std::abs(value);
  for (int k = 0; k < count; ++k) {
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

/// The value of an operation on rounded operands. Most operations are of the first three kinds.
Rounded rounded(const Node& node, const std::array<Rounded, 3>& given) {
  switch (node.op) {
    case Op::constant:
      return {node.constant, kUnit * std::abs(node.constant)};
    case Op::add:
      return rounded_by([](double a, double b, double) { return a + b; }, 2, given);
    case Op::subtract:
      return rounded_by([](double a, double b, double) { return a - b; }, 2, given);
    case Op::multiply:
      return rounded_by([](double a, double b, double) { return a * b; }, 2, given);
    default:
      return rounded_by([&](double a, double b, double c) { return smooth(node.op, a, b, c); }, arity(node.op), given);
  }
}

}  // namespace

RoundedLanes RoundedValues::lanes_of(const Node& node) const {
  const auto given = [&](int k) -> const RoundedLanes& { return all_[node.operands[k]]; };
  const auto number = [](const Rounded& value) { return RoundedLanes{value, value}; };
  if (node.op == Op::input) return number(inputs_[static_cast<std::size_t>(node.input)]);
  if (node.op == Op::pack) return {given(0).first, given(1).first, true};
  if (node.op == Op::first_lane) return number(given(0).first);
  if (node.op == Op::second_lane) return number(given(0).second);
  RoundedLanes lanes;
  for (int k = 0; k < arity(node.op); ++k) lanes.is_pair = lanes.is_pair || given(k).is_pair;
  const auto in_lane = [&](Rounded RoundedLanes::*lane) {
    std::array<Rounded, 3> operands;
    for (int k = 0; k < arity(node.op); ++k) operands[static_cast<std::size_t>(k)] = given(k).*lane;
    return rounded(node, operands);
  };
  lanes.first = in_lane(&RoundedLanes::first);
  lanes.second = lanes.is_pair ? in_lane(&RoundedLanes::second) : lanes.first;
  return lanes;
}

void RoundedValues::append(const Node& node) { all_.push_back(lanes_of(node)); }

std::vector<Rounded> rounded_values(const Program& program, std::span<const double> inputs) {
  std::vector<Rounded> exact;
  for (const double input : inputs) exact.push_back({input, 0});
  RoundedValues lanes(std::move(exact));
  std::vector<Rounded> all;
  for (const Node& node : program.nodes) {
    lanes.append(node);
    all.push_back(lanes[static_cast<ValueId>(all.size())].first);
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
