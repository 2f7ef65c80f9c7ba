#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "compiler/program/arithmetic.hpp"
#include "compiler/program/canonical_order.hpp"
#include "compiler/program/mixed_words.hpp"
#include "compiler/program/program.hpp"
#include "compiler/program/rules.hpp"

namespace mbgen {

ProgramBuilder::ProgramBuilder(std::string name, Spelling spelling) : spelling_(spelling) {
  program_.name = std::move(name);
  program_.sections = {Section{}};
  known_sections_ = {Section{}};
}

ProgramBuilder ProgramBuilder::like(const Program& program) {
  ProgramBuilder builder(program.name);
  builder.program_.inputs = program.inputs;
  builder.program_.samples = program.samples;
  builder.program_.sections = program.sections;
  builder.known_sections_ = {program.sections.begin(), program.sections.end()};
  builder.program_.constants.reserve(program.constants.size());
  for (const NamedConstant& constant : program.constants)
    builder.program_.constants.push_back({constant.name, constant.value});
  builder.program_.nodes.reserve(program.nodes.size());
  builder.shared_.reserve(program.nodes.size());
  builder.moments_.reserve(program.nodes.size());
  builder.input_value_.assign(program.inputs.size(), kNoValue);
  for (std::size_t i = 0; i < program.inputs.size(); ++i) builder.input_index_.emplace(program.inputs[i], i);
  return builder;
}

ValueId ProgramBuilder::constant(double value, std::int32_t name) {
  Node node;
  node.constant = value == 0 ? 0.0 : value;
  node.label = name;
  return share_or_push(node);
}

void ProgramBuilder::find_names() {
  for (; indexed_ < program_.constants.size(); ++indexed_)
    named_[program_.constants[indexed_].name] = static_cast<std::int32_t>(indexed_);
}

std::int32_t ProgramBuilder::name_constant(double value, const std::string& name) {
  if (value == 0 || std::abs(value) == 1 || !std::isfinite(value)) return -1;
  find_names();
  const auto found = named_.find(name);
  if (found != named_.end() && program_.constants[static_cast<std::size_t>(found->second)].value == value)
    return found->second;
  program_.constants.push_back({name, value});
  find_names();
  return static_cast<std::int32_t>(program_.constants.size() - 1);
}

void ProgramBuilder::name_fold(std::int32_t label, const std::string& name) {
  NamedConstant& fold = program_.constants[static_cast<std::size_t>(label)];
  if (!fold.is_anonymous) return;
  fold.name = name;
  fold.is_anonymous = false;
}

void ProgramBuilder::equate_folds(std::int32_t label, std::int32_t other) {
  find_names();
  const NamedConstant& fold = program_.constants[static_cast<std::size_t>(label)];
  if (fold.is_anonymous && label != other) named_[fold.name] = other;
}

void ProgramBuilder::explain_constant(std::int32_t label, const std::string& note) {
  program_.constants[static_cast<std::size_t>(label)].note = note;
}

std::int32_t ProgramBuilder::label_fold(double value, NamedConstant operation) {
  if (!is_for_reading() || std::ranges::all_of(operation.labels, [](std::int32_t label) { return label < 0; }))
    return -1;
  const auto operand = [&](int k) {
    const std::int32_t label = operation.labels[k];
    if (label < 0) return fmt::format("{}", operation.operands[k]);
    const NamedConstant& named = program_.constants[static_cast<std::size_t>(label)];
    const char* sign = named.value == operation.operands[k] ? "" : "-";
    return named.is_anonymous ? fmt::format("{}({})", sign, named.name) : sign + named.name;
  };
  operation.name = arity(operation.op) == 1 ? fmt::format("{} {}", op_name(operation.op), operand(0))
                                            : fmt::format("{} {} {}", operand(0), op_name(operation.op), operand(1));
  if (value == 0 || std::abs(value) == 1 || !std::isfinite(value)) return -1;
  find_names();
  const auto found = named_.find(operation.name);
  if (found != named_.end() && program_.constants[static_cast<std::size_t>(found->second)].value == value)
    return found->second;
  operation.value = value;
  operation.is_anonymous = true;
  program_.constants.push_back(std::move(operation));
  find_names();
  return static_cast<std::int32_t>(program_.constants.size() - 1);
}

ValueId ProgramBuilder::constant_like(const Node& node, std::span<const NamedConstant> constants) {
  if (node.label < 0) return constant(node.constant);
  const auto label = static_cast<std::size_t>(node.label);
  const NamedConstant& named = constants[label];
  const bool is_at_its_place = label < program_.constants.size() && program_.constants[label].value == named.value &&
                               program_.constants[label].name == named.name;
  if (is_at_its_place) return constant(node.constant, node.label);
  return constant(node.constant, name_constant(named.value, named.name));
}

ValueId ProgramBuilder::input(SlotGroup group, int index) {
  const Slot slot{group, index};
  const auto [found, is_new] = input_index_.try_emplace(slot, program_.inputs.size());
  if (is_new) {
    program_.inputs.push_back(slot);
    input_value_.push_back(kNoValue);
  }
  return input(found->second);
}

ValueId ProgramBuilder::input(std::size_t index) {
  ValueId& value = input_value_[index];
  if (value == kNoValue) {
    Node node;
    node.op = Op::input;
    node.input = static_cast<std::int32_t>(index);
    value = push(node);
  }
  return value;
}

ValueId ProgramBuilder::append(Op op, ValueId first, ValueId second, ValueId third) {
  ValueId operands[3] = {first, second, third};
  const int count = arity(op);
  if (count == 0) throw std::logic_error("constants and inputs are not appended as operations");
  bool all_constant = op < Op::sample;
  double values[3] = {0, 0, 0};
  for (int i = 0; i < 3; ++i) {
    if ((i < count) != (operands[i] < program_.nodes.size())) {
      throw std::logic_error(fmt::format("{} appended with operand {} missing or unknown", op_name(op), i));
    }
    if (i >= count) break;
    all_constant = all_constant && is_constant(operands[i]);
    values[i] = node(operands[i]).constant;
  }
  if (all_constant) {
    const double value = fold(op, values[0], values[1], values[2]);
    if (std::isfinite(value) && is_for_reading() && count < 3)
      return constant(value, label_fold(value, {.name = "",
                                                .op = op,
                                                .operands = {values[0], values[1]},
                                                .labels = {node(first).label, count > 1 ? node(second).label : -1}}));
    if (std::isfinite(value)) return constant(value);
  }
  order_operands(program_.nodes, op, operands);
  if (!all_constant) {
    const ValueId simpler = simplify(*this, op, operands[0], operands[1], operands[2]);
    if (simpler != kNoValue) return simpler;
  }
  Node node;
  node.op = op;
  std::ranges::copy(operands, node.operands);
  node.section = section_;
  node.owner = owner_;
  node.mirrored = mirrored_;
  return share_or_push(node);
}

// Operations are the same when their constants have the same value, whatever their names. A constant itself is told
// apart by its name: in a long chain thousands have one value.
std::uint64_t ProgramBuilder::hash_of(const Node& node) const {
  std::uint64_t hash = static_cast<std::uint64_t>(node.op);
  if (node.op == Op::constant)
    return mixed_word(mixed_word(hash, std::bit_cast<std::uint64_t>(node.constant)),
                      static_cast<std::uint64_t>(node.label));
  for (int k = 0; k < arity(node.op); ++k) {
    const Node& operand = this->node(node.operands[k]);
    const bool is_number = operand.op == Op::constant;
    hash = mixed_word(hash, is_number ? std::bit_cast<std::uint64_t>(operand.constant) : node.operands[k]);
  }
  return hash;
}

/// The same computation; place and label do not count, but the name of a constant itself.
bool ProgramBuilder::computes_same(const Node& a, const Node& b) const {
  const auto same_operand = [&](ValueId x, ValueId y) {
    if (x == y || is_for_reading()) return x == y;
    return x != kNoValue && y != kNoValue && is_constant(x) && is_constant(y, node(x).constant);
  };
  return a.op == b.op && (a.op != Op::constant || a.label == b.label) &&
         std::ranges::equal(a.operands, b.operands, same_operand) &&
         std::bit_cast<std::uint64_t>(a.constant) == std::bit_cast<std::uint64_t>(b.constant);
}

ValueId ProgramBuilder::share_or_push(const Node& node) {
  const std::uint64_t hash = hash_of(node);
  const ValueId known =
      shared_.find(hash, [&](ValueId candidate) { return computes_same(program_.nodes[candidate], node); });
  if (known == NumberTable::kNone) {
    const ValueId value = push(node);
    shared_.insert(hash, value);
    return value;
  }
  const bool in_this_statement = moments_[known] == moment_;
  if (in_this_statement && !std::ranges::equal(program_.nodes[known].operands, node.operands))
    repeats_.push_back({known, node});
  return known;
}

/// Of constants that are the same number the named one that comes first in the alphabet becomes the operand.
static void take_first_names(const Node& again, Node& node, const Program& program) {
  const auto name = [&](ValueId constant) {
    const std::int32_t label = program.nodes[constant].label;
    return std::pair(label < 0, label < 0 ? "" : program.constants[static_cast<std::size_t>(label)].name);
  };
  for (int k = 0; k < arity(node.op); ++k)
    if (node.operands[k] != again.operands[k] && name(again.operands[k]) < name(node.operands[k]))
      node.operands[k] = again.operands[k];
}

ValueId ProgramBuilder::push(const Node& node) {
  program_.nodes.push_back(node);
  moments_.push_back(moment_);
  return static_cast<ValueId>(program_.nodes.size() - 1);
}

ValueId ProgramBuilder::copy(const Program& source, const Node& node, std::span<const ValueId> renamed) {
  if (node.op == Op::constant) return constant_like(node, source.constants);
  if (node.op == Op::input) {
    const Slot& slot = source.inputs[static_cast<std::size_t>(node.input)];
    return input(slot.group, slot.index);
  }
  set_origin(node);
  ValueId operands[3] = {kNoValue, kNoValue, kNoValue};
  for (int i = 0; i < arity(node.op); ++i) operands[i] = renamed[node.operands[i]];
  const ValueId value = append(node.op, operands[0], operands[1], operands[2]);
  label_like(value, source, node);
  return value;
}

void ProgramBuilder::output(SlotGroup group, int index, ValueId value) {
  ++moment_;
  program_.outputs.push_back({{group, index}, value});
}

void ProgramBuilder::set_section(const Section& section) {
  ++moment_;
  if (knows_section_ && section == section_) return;
  section_ = section;
  knows_section_ = true;
  if (known_sections_.insert(section).second) program_.sections.push_back(section);
}

void ProgramBuilder::set_owner(const Owner& owner, const Owner& mirrored) {
  ++moment_;
  owner_ = owner;
  mirrored_ = mirrored;
}

void ProgramBuilder::set_origin(const Node& node) {
  set_section(node.section);
  set_owner(node.owner, node.mirrored);
}

void ProgramBuilder::label(ValueId value, const std::string& name, const std::string& of_second_lane) {
  ++moment_;
  Node& named = program_.nodes[value];
  if (named.op == Op::constant || named.op == Op::input || named.label >= 0) return;
  named.owner = owner_;  // a value that is named after a body belongs to it, whoever computed it
  named.mirrored = mirrored_;
  named.label = static_cast<std::int32_t>(program_.labels.size());
  program_.labels.push_back(name);
  if (of_second_lane.empty()) return;
  named.mirrored_label = static_cast<std::int32_t>(program_.labels.size());
  program_.labels.push_back(of_second_lane);
}

void ProgramBuilder::label_like(ValueId value, const Program& source, const Node& node) {
  static const std::string kNone;
  const auto name = [&](std::int32_t label) -> const std::string& {
    return label < 0 ? kNone : source.labels[static_cast<std::size_t>(label)];
  };
  if (node.label >= 0) label(value, name(node.label), name(node.mirrored_label));
}

bool ProgramBuilder::is_constant(ValueId value, double constant) const {
  return is_constant(value) && node(value).constant == constant;
}

Program ProgramBuilder::taken() {
  Program finished = std::move(program_);
  *this = ProgramBuilder("");
  return finished;
}

Program ProgramBuilder::finish() { return verified(taken()); }

Program ProgramBuilder::finish_in_canonical_order() {
  const std::vector<std::uint32_t> moments = std::move(moments_);
  const std::vector<std::pair<ValueId, Node>> repeats = std::move(repeats_);
  Program program = taken();
  for (const auto& [value, again] : repeats) take_first_names(again, program.nodes[value], program);
  return verified(in_canonical_order(std::move(program), moments));
}

}  // namespace mbgen
