#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>
#include <utility>

#include "compiler/program/arithmetic.hpp"
#include "compiler/program/program.hpp"

namespace mbgen {
namespace {

/// Whether a value has its operands, all of them earlier, and no other ones.
bool has_its_operands(const Node& node, std::size_t value) {
  const int count = arity(node.op);
  for (int i = 0; i < 3; ++i)
    if (i < count ? node.operands[i] >= value : node.operands[i] != kNoValue) return false;
  return true;
}

/// Requires: a value that has not its operands.
std::string fault_of_operands(const Node& node, std::size_t value) {
  for (int i = 0; i < 3; ++i) {
    const ValueId operand = node.operands[i];
    if (i >= arity(node.op)) {
      if (operand != kNoValue) return fmt::format("%{}: {} has a surplus operand {}", value, op_name(node.op), i);
    } else if (operand == kNoValue) {
      return fmt::format("%{}: {} lacks operand {}", value, op_name(node.op), i);
    } else if (operand >= value) {
      return fmt::format("%{}: operand %{} is not earlier", value, operand);
    }
  }
  return {};
}

/// sections: those of the program. value_seen: per input, whether an earlier node is its value; updated.
std::string verify_node(const Program& program, std::size_t value, const std::set<Section>& sections,
                        std::vector<bool>& value_seen) {
  const Node& node = program.nodes[value];
  if (node.op > Op::second_lane) return fmt::format("%{}: unknown operation {}", value, static_cast<int>(node.op));
  if (node.op == Op::sample && (!program.samples || program.samples->empty()))
    return fmt::format("%{}: no samples", value);
  if (!has_its_operands(node, value)) return fault_of_operands(node, value);
  if (node.op == Op::constant && !std::isfinite(node.constant)) {
    return fmt::format("%{}: constant {} is not finite", value, node.constant);
  }
  if (node.op == Op::input) {
    if (node.input < 0 || static_cast<std::size_t>(node.input) >= program.inputs.size()) {
      return fmt::format("%{}: no input {}", value, node.input);
    }
    const auto input = static_cast<std::size_t>(node.input);
    if (value_seen[input]) {
      return fmt::format("%{}: second value of input {}", value, text_of(program.inputs[input]));
    }
    value_seen[input] = true;
  }
  const bool is_next = value > 0 && program.nodes[value - 1].section == node.section;
  if (!is_next && !sections.contains(node.section))
    return fmt::format("%{}: no section \"{}\"", value, text_of(node.section));
  const std::size_t labels = node.op == Op::constant ? program.constants.size() : program.labels.size();
  const auto is_known = [&](std::int32_t label, std::size_t count) {
    return label >= -1 && (label < 0 || static_cast<std::size_t>(label) < count);
  };
  if (!is_known(node.label, labels) || !is_known(node.mirrored_label, program.labels.size())) {
    return fmt::format("%{}: no label {}", value, node.label);
  }
  if (node.op == Op::constant && node.label >= 0 &&
      std::abs(node.constant) != std::abs(program.constants[static_cast<std::size_t>(node.label)].value)) {
    return fmt::format("%{}: {} is not {}", value, node.constant,
                       program.constants[static_cast<std::size_t>(node.label)].name);
  }
  return {};
}

std::string verify_slots(const char* kind, std::vector<Slot> slots) {
  std::ranges::sort(slots);
  for (const Slot& slot : slots)
    if (slot.index < 0) return fmt::format("{} {} has a negative index", kind, text_of(slot));
  if (const auto twice = std::ranges::adjacent_find(slots); twice != slots.end())
    return fmt::format("{} {} appears twice", kind, text_of(*twice));
  return "";
}

std::string verify_ends(const Program& program) {
  if (std::string problem = verify_slots("input", program.inputs); !problem.empty()) return problem;
  std::vector<Slot> outputs;
  outputs.reserve(program.outputs.size());
  for (const auto& [slot, value] : program.outputs) {
    if (value >= program.nodes.size()) return fmt::format("output {} has no value", text_of(slot));
    outputs.push_back(slot);
  }
  return verify_slots("output", std::move(outputs));
}

/// Pairs are packed and taken apart where they meet numbers.
std::string verify_widths(const Program& program) {
  if (std::ranges::none_of(program.nodes, [](const Node& node) { return node.op >= Op::pack; })) return {};
  const std::vector<int> widths = widths_of(program);
  for (std::size_t value = 0; value < program.nodes.size(); ++value) {
    const Node& node = program.nodes[value];
    const bool takes_apart = node.op == Op::first_lane || node.op == Op::second_lane;
    for (int k = 0; k < arity(node.op); ++k) {
      const int wanted = takes_apart ? 2 : node.op == Op::pack ? 1 : widths[value];
      const int given = widths[node.operands[k]];
      if (given != wanted && (given != 0 || takes_apart))
        return fmt::format("%{}: operand {} of {} has width {}", value, k, op_name(node.op), given);
    }
  }
  for (const auto& [slot, value] : program.outputs)
    if (widths[value] == 2) return fmt::format("output {} is a pair", text_of(slot));
  return "";
}

}  // namespace

std::string verify(const Program& program) {
  std::set<Section> sections;
  for (const Section& section : program.sections)
    if (!sections.insert(section).second) return fmt::format("section \"{}\" appears twice", text_of(section));
  std::vector<bool> value_seen(program.inputs.size(), false);
  for (std::size_t value = 0; value < program.nodes.size(); ++value) {
    if (std::string problem = verify_node(program, value, sections, value_seen); !problem.empty()) return problem;
  }
  if (std::string problem = verify_ends(program); !problem.empty()) return problem;
  return verify_widths(program);
}

Program verified(Program program) {
  if (const std::string problem = verify(program); !problem.empty()) {
    throw std::logic_error(fmt::format("program {}: {}", program.name, problem));
  }
  return program;
}

}  // namespace mbgen
