#include "workbench/motion/corners.hpp"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

#include "compiler/choose/cheapest_recursion.hpp"
#include "compiler/passes/passes.hpp"
#include "compiler/program/rewrite.hpp"

namespace mbgen {
namespace {

bool chooses(Op op) { return op == Op::select || op == Op::abs || op == Op::min || op == Op::max; }

/// Quantity that decides a corner: a value, or the difference of two.
using Choice = std::pair<ValueId, ValueId>;

Choice choice_of(const Node& node) {
  const bool of_two = node.op == Op::min || node.op == Op::max;
  return {node.operands[0], of_two ? node.operands[1] : kNoValue};
}

/// Whether each value changes along a motion.
std::vector<bool> moving_values(const Program& program) {
  std::vector<bool> moves;
  for (const Node& node : program.nodes) {
    bool any =
        node.op == Op::input && program.inputs[static_cast<std::size_t>(node.input)].group != SlotGroup(Array::par);
    for (int k = 0; k < arity(node.op); ++k) any = any || moves[node.operands[k]];
    moves.push_back(any);
  }
  return moves;
}

/// The rates without values that they do not need.
Program rates_alone(Program program) {
  std::erase_if(program.outputs, [](const OutputValue& output) {
    return output.slot.group != SlotGroup(Array::zdd) && output.slot.group != SlotGroup(Array::xd);
  });
  return remove_dead_values(std::move(program));
}

std::map<Choice, int> corners_of(const Program& program) {
  const std::vector<bool> moves = moving_values(program);
  std::map<Choice, int> corners;
  for (const Node& node : program.nodes) {
    const Choice choice = choice_of(node);
    if (!chooses(node.op)) continue;
    if (moves[choice.first] || (choice.second != kNoValue && moves[choice.second]))
      corners.emplace(choice, static_cast<int>(corners.size()));
  }
  return corners;
}

Program conditions_of(const Program& program, const std::map<Choice, int>& corners) {
  ProgramBuilder builder = ProgramBuilder::like(program);
  std::vector<ValueId> renamed;
  for (const Node& node : program.nodes) renamed.push_back(builder.copy(program, node, renamed));
  for (const auto& [choice, number] : corners) {
    const ValueId value = renamed[choice.first];
    builder.output(Array::residual, number,
                   choice.second == kNoValue ? value : builder.append(Op::subtract, value, renamed[choice.second]));
  }
  return remove_dead_values(builder.finish());
}

/// The program with its sides as inputs.
Program with_given_sides(const Program& program, const std::map<Choice, int>& corners) {
  return rewritten(program, [&](ProgramBuilder& builder, ValueId v, std::span<const ValueId> renamed) {
    const Node& node = program.nodes[v];
    if (!chooses(node.op)) return kNoValue;
    const auto corner = corners.find(choice_of(node));
    if (corner == corners.end()) return kNoValue;
    const ValueId side = builder.input(Array::seed, corner->second), first = renamed[node.operands[0]];
    if (node.op == Op::abs) return builder.append(Op::select, side, first, builder.append(Op::negate, first));
    const ValueId second = renamed[node.operands[1]];
    if (node.op == Op::min) return builder.append(Op::select, side, second, first);
    if (node.op == Op::max) return builder.append(Op::select, side, first, second);
    return builder.append(Op::select, side, second, renamed[node.operands[2]]);
  });
}

}  // namespace

Corners::Corners(const Compilation& compilation) {
  if (!too_large(compilation).empty()) return;
  const auto& [model, topology, analysis] = std::tie(compilation.model, compilation.topology, compilation.analysis);
  const Program rates = rates_alone(trace_accelerations(model, topology, analysis, form_of(topology, analysis)));
  const std::map<Choice, int> corners = corners_of(rates);
  conditions_ = conditions_of(rates, corners);
  held_ = with_given_sides(rates, corners);
  for (const Parameter& parameter : model.parameters)
    if (parameter.tunable) parameters_.push_back(parameter.value);
}

std::vector<double> Corners::results(const Program& program, const GenericState& state,
                                     const std::vector<double>& inputs, const std::vector<double>& sides) const {
  const std::vector<double> time = {state.t};
  const std::map<SlotGroup, const std::vector<double>*> known = {
      {Array::z, &state.z}, {Array::zd, &state.zd}, {Array::x, &state.x},      {Array::t, &time},
      {Array::in, &inputs}, {Array::seed, &sides},  {Array::par, &parameters_}};
  std::vector<double> values;
  for (const Slot& slot : program.inputs) {
    const auto array = known.find(slot.group);
    values.push_back(array == known.end() ? 0.0 : array->second->at(static_cast<std::size_t>(slot.index)));
  }
  return interpret(program, values);
}

std::vector<double> Corners::conditions(const GenericState& state, const std::vector<double>& inputs) const {
  std::vector<double> values(count());
  const std::vector<double> found = results(conditions_, state, inputs, {});
  for (std::size_t i = 0; i < found.size(); ++i)
    values[static_cast<std::size_t>(conditions_.outputs[i].slot.index)] = found[i];
  return values;
}

GenericDerivative Corners::held_rates(const GenericState& state, const std::vector<double>& inputs,
                                      const std::vector<double>& sides) const {
  const std::vector<double> values = results(held_, state, inputs, sides);
  GenericDerivative rates{std::vector<double>(state.zd.size(), 0.0), std::vector<double>(state.x.size(), 0.0)};
  for (std::size_t i = 0; i < values.size(); ++i) {
    const Slot& slot = held_.outputs[i].slot;
    (slot.group == SlotGroup(Array::zdd) ? rates.zdd : rates.xd)[static_cast<std::size_t>(slot.index)] = values[i];
  }
  return rates;
}

GenericDerivative Corners::difference(const GenericState& state, const std::vector<double>& inputs,
                                      const std::vector<double>& sides, const std::vector<double>& other) const {
  GenericDerivative change = held_rates(state, inputs, sides);
  const GenericDerivative without = held_rates(state, inputs, other);
  for (std::size_t i = 0; i < change.zdd.size(); ++i) change.zdd[i] -= without.zdd[i];
  for (std::size_t i = 0; i < change.xd.size(); ++i) change.xd[i] -= without.xd[i];
  return change;
}

GenericDerivative Corners::rates(const GenericState& state, const std::vector<double>& inputs) const {
  std::vector<double> sides = conditions(state, inputs);
  for (double& side : sides) side = side >= 0 ? 1 : -1;
  return held_rates(state, inputs, sides);
}

std::vector<bool> Corners::follow(const std::vector<int>& tunable) const {
  std::vector<bool> follows;
  for (const Node& node : conditions_.nodes) {
    bool any = false;
    if (node.op == Op::input) {
      const Slot& slot = conditions_.inputs[static_cast<std::size_t>(node.input)];
      const auto is_of = [&](Array array) { return slot.group == SlotGroup(array); };
      any = is_of(Array::z) || is_of(Array::zd) || is_of(Array::x) ||
            (is_of(Array::par) && std::ranges::find(tunable, slot.index) != tunable.end());
    }
    for (int k = 0; k < arity(node.op); ++k) any = any || follows[node.operands[k]];
    follows.push_back(any);
  }
  std::vector<bool> result(count());
  for (const OutputValue& output : conditions_.outputs)
    result[static_cast<std::size_t>(output.slot.index)] = follows[output.value];
  return result;
}

}  // namespace mbgen
