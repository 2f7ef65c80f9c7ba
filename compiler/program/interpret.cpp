#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "compiler/program/arithmetic.hpp"
#include "compiler/program/program.hpp"

namespace mbgen {
namespace {

/// Counts one operation in each of `lanes`; negations, constants, inputs and what packs and takes apart are free.
void count(OperationCount& total, Op op, int lanes) {
  switch (op) {
    case Op::constant:
    case Op::input:
    case Op::negate:
    case Op::pack:
    case Op::first_lane:
    case Op::second_lane:
      return;
    case Op::add:
    case Op::subtract:
      total.add += lanes;
      return;
    case Op::multiply:
      total.multiply += lanes;
      return;
    case Op::multiply_add:
    case Op::multiply_subtract:
    case Op::subtract_product:
      total.multiply += lanes;
      total.add += lanes;
      return;
    case Op::divide:
      total.divide += lanes;
      return;
    case Op::sqrt:
      total.sqrt += lanes;
      return;
    case Op::sin:
    case Op::cos:
    case Op::tan:
    case Op::asin:
    case Op::acos:
    case Op::atan:
    case Op::atan2:
      total.trigonometric += lanes;
      return;
    default:
      total.other += lanes;
      return;
  }
}

}  // namespace

std::vector<double> interpret(const Program& program, std::span<const double> inputs) {
  if (inputs.size() != program.inputs.size()) {
    throw std::invalid_argument(
        fmt::format("program {} has {} inputs, {} given", program.name, program.inputs.size(), inputs.size()));
  }
  if (has_pairs(program)) return interpret(unfolded(program), inputs);
  std::vector<double> values(program.nodes.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    const Node& node = program.nodes[i];
    if (node.op == Op::constant) {
      values[i] = node.constant;
    } else if (node.op == Op::input) {
      values[i] = inputs[static_cast<std::size_t>(node.input)];
    } else if (node.op == Op::sample) {
      values[i] = sample_of(*program.samples, values[node.operands[0]]);
    } else {
      double operands[3] = {0, 0, 0};
      for (int k = 0; k < arity(node.op); ++k) operands[k] = values[node.operands[k]];
      values[i] = apply(node.op, operands[0], operands[1], operands[2]);
    }
  }
  std::vector<double> result;
  result.reserve(program.outputs.size());
  for (const OutputValue& output : program.outputs) result.push_back(values[output.value]);
  return result;
}

std::vector<bool> needed_values(const Program& program) {
  std::vector<bool> needed(program.nodes.size(), false);
  for (const OutputValue& output : program.outputs) needed[output.value] = true;
  for (std::size_t i = needed.size(); i-- > 0;) {
    if (!needed[i]) continue;
    const Node& node = program.nodes[i];
    for (int k = 0; k < arity(node.op); ++k) needed[node.operands[k]] = true;
  }
  return needed;
}

OperationCount count_operations(const Program& program) {
  const std::vector<bool> needed = needed_values(program);
  const std::vector<int> widths = widths_of(program);
  OperationCount total;
  for (std::size_t i = 0; i < needed.size(); ++i) {
    if (needed[i]) count(total, program.nodes[i].op, std::max(widths[i], 1));
  }
  return total;
}

std::map<Section, std::size_t> places_of_sections(const Program& program) {
  std::map<Section, std::size_t> places;
  for (const Section& section : program.sections) places.emplace(section, places.size());
  return places;
}

std::vector<OperationCount> count_operations_by_section(const Program& program) {
  const std::vector<bool> needed = needed_values(program);
  const std::map<Section, std::size_t> places = places_of_sections(program);
  const std::vector<int> widths = widths_of(program);
  std::vector<OperationCount> totals(program.sections.size());
  for (std::size_t i = 0; i < needed.size(); ++i) {
    if (needed[i]) count(totals[places.at(program.nodes[i].section)], program.nodes[i].op, std::max(widths[i], 1));
  }
  return totals;
}

}  // namespace mbgen
