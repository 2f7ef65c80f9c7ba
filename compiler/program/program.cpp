#include "compiler/program/operations.hpp"

#include <fmt/format.h>

#include <cmath>
#include <set>
#include <stdexcept>

namespace mbgen {
namespace {

std::string verify_node(const Program& program, std::size_t i) {
  const Node& node = program.nodes[i];
  const int count = arity(node.op);
  for (int k = 0; k < 3; ++k) {
    const ValueId operand = node.operands[k];
    if (k >= count && operand != kNoValue) return fmt::format("value {} has an operand beyond its arity", i);
    if (k < count && operand >= i) return fmt::format("value {} uses value {}, which is not earlier", i, operand);
  }
  if (node.op == Op::constant && !std::isfinite(node.constant)) return fmt::format("value {} is a constant that is not finite", i);
  if (node.op == Op::input && (node.input < 0 || node.input >= static_cast<int>(program.inputs.size())))
    return fmt::format("value {} names an input that does not exist", i);
  if (node.section >= program.sections.size()) return fmt::format("value {} names a section that does not exist", i);
  if (node.block >= program.blocks.size()) return fmt::format("value {} names a block that does not exist", i);
  if (node.label >= static_cast<int>(program.labels.size())) return fmt::format("value {} names a label that does not exist", i);
  return "";
}

void count_into(OperationCount& count, Op op) {
  switch (op) {
    case Op::constant: case Op::input: case Op::negate: return;
    case Op::add: case Op::subtract: ++count.add; return;
    case Op::multiply: ++count.multiply; return;
    case Op::divide: ++count.divide; return;
    case Op::sqrt: ++count.sqrt; return;
    case Op::sin: case Op::cos: case Op::tan: case Op::asin: case Op::acos: case Op::atan: case Op::atan2: ++count.trigonometric; return;
    default: ++count.other; return;
  }
}

std::vector<bool> live_values(const Program& program) {
  std::vector<bool> live(program.nodes.size(), false);
  for (const OutputValue& output : program.outputs) live[output.value] = true;
  for (std::size_t i = program.nodes.size(); i-- > 0;)
    if (live[i])
      for (int k = 0; k < arity(program.nodes[i].op); ++k) live[program.nodes[i].operands[k]] = true;
  return live;
}

}  // namespace

std::string verify(const Program& program) {
  std::set<int> inputs;
  for (std::size_t i = 0; i < program.nodes.size(); ++i) {
    if (std::string fault = verify_node(program, i); !fault.empty()) return fault;
    if (program.nodes[i].op == Op::input && !inputs.insert(program.nodes[i].input).second)
      return fmt::format("value {} repeats an input", i);
  }
  std::set<std::pair<std::string, int>> slots;
  for (const Slot& slot : program.inputs)
    if (!slots.insert({slot.group, slot.index}).second) return fmt::format("input {}[{}] is declared twice", slot.group, slot.index);
  slots.clear();
  for (const OutputValue& output : program.outputs) {
    if (output.value >= program.nodes.size()) return fmt::format("output {}[{}] has no value", output.slot.group, output.slot.index);
    if (!slots.insert({output.slot.group, output.slot.index}).second)
      return fmt::format("output {}[{}] is given twice", output.slot.group, output.slot.index);
  }
  return "";
}

std::vector<double> interpret(const Program& program, std::span<const double> inputs) {
  std::vector<double> values(program.nodes.size());
  for (std::size_t i = 0; i < program.nodes.size(); ++i) {
    const Node& node = program.nodes[i];
    const auto operand = [&](int k) { return node.operands[k] == kNoValue ? 0.0 : values[node.operands[k]]; };
    if (node.op == Op::constant) values[i] = node.constant;
    else if (node.op == Op::input) values[i] = inputs[node.input];
    else values[i] = apply(node.op, operand(0), operand(1), operand(2));
  }
  std::vector<double> results;
  for (const OutputValue& output : program.outputs) results.push_back(values[output.value]);
  return results;
}

std::string dump(const Program& program) {
  std::string text = fmt::format("program {}\n", program.name);
  int section = 0, block = 0;
  for (std::size_t i = 0; i < program.nodes.size(); ++i) {
    const Node& node = program.nodes[i];
    if (node.section != section) text += fmt::format("# section {}\n", program.sections[section = node.section]);
    if (node.block != block) text += fmt::format("# block {}\n", program.blocks[block = node.block]);
    text += fmt::format("%{} = {}", i, op_name(node.op));
    if (node.op == Op::constant) text += fmt::format(" {}", node.constant);
    if (node.op == Op::input) text += fmt::format(" {}[{}]", program.inputs[node.input].group, program.inputs[node.input].index);
    for (int k = 0; k < arity(node.op); ++k) text += fmt::format(" %{}", node.operands[k]);
    if (node.label >= 0) text += "  ; " + program.labels[node.label];
    text += '\n';
  }
  for (const OutputValue& output : program.outputs)
    text += fmt::format("out {}[{}] = %{}\n", output.slot.group, output.slot.index, output.value);
  return text;
}

std::vector<OperationCount> count_operations_by_section(const Program& program) {
  std::vector<OperationCount> counts(program.sections.size());
  const std::vector<bool> live = live_values(program);
  for (std::size_t i = 0; i < program.nodes.size(); ++i)
    if (live[i]) count_into(counts[program.nodes[i].section], program.nodes[i].op);
  return counts;
}

OperationCount count_operations(const Program& program) {
  OperationCount total;
  for (const OperationCount& c : count_operations_by_section(program)) {
    total.add += c.add;
    total.multiply += c.multiply;
    total.divide += c.divide;
    total.sqrt += c.sqrt;
    total.trigonometric += c.trigonometric;
    total.other += c.other;
  }
  return total;
}

}  // namespace mbgen
