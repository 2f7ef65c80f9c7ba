#include "compiler/emit/local_names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "compiler/emit/text.hpp"

namespace mbgen {

std::string LocalNames::of_value(ValueId value) {
  const Node& node = program_.nodes[value];
  if (node.label >= 0) return identifier(program_.labels[node.label]);
  const int step = number_of(node.section.step);
  std::string candidate;
  do {
    candidate = fmt::format("s{}_{}", step, ++leftovers_[step]);
  } while (!reserve(candidate));
  return candidate;
}

std::int32_t ConstantNames::entry_of(const Program& program, std::int32_t label) {
  if (label < 0) return -1;
  NamedConstant constant = program.constants[static_cast<std::size_t>(label)];
  for (std::int32_t& operand : constant.labels) operand = entry_of(program, operand);
  const auto [op, a, b] = std::tuple(constant.op, constant.operands[0], constant.operands[1]);
  const auto next = static_cast<std::int32_t>(entries_.size());
  const std::int32_t number =
      constant.is_fold()
          ? fold_index_.try_emplace({op, a, b, constant.labels[0], constant.labels[1]}, next).first->second
          : index_.try_emplace({constant.name, constant.value}, next).first->second;
  if (number == next) entries_.push_back({"", constant});
  Entry& entry = entries_[static_cast<std::size_t>(number)];
  if (entry.identifier.empty() && !constant.is_anonymous) entry.identifier = names_.identifier(constant.name);
  return number;
}

ConstantNames::ConstantNames(const WrittenPrograms& programs) {
  for (const Program* program : all_programs(programs)) identifiers(*program);
}

std::vector<std::string> ConstantNames::identifiers(const Program& program) {
  std::vector<std::string> result;
  for (std::size_t label = 0; label < program.constants.size(); ++label) {
    const Entry& entry = entries_[static_cast<std::size_t>(entry_of(program, static_cast<std::int32_t>(label)))];
    if (!entry.identifier.empty()) result.push_back(entry.identifier);
  }
  return result;
}

std::string ConstantNames::text(const Program& program, const Node& node) {
  Entry& entry = entries_[static_cast<std::size_t>(entry_of(program, node.label))];
  if (entry.identifier.empty()) entry.identifier = names_.unique(fmt::format("number_{}", ++numbers_));
  entry.is_used = true;
  return node.constant == entry.constant.value ? entry.identifier : "-" + entry.identifier;
}

bool ConstantNames::is_arithmetic(const Entry& entry) const {
  const Op op = entry.constant.op;
  if (op != Op::add && op != Op::subtract && op != Op::multiply && op != Op::divide && op != Op::negate) return false;
  return std::ranges::all_of(entry.constant.labels, [&](std::int32_t operand) {
    return operand < 0 || !is_written_out(entries_[static_cast<std::size_t>(operand)]) ||
           is_arithmetic(entries_[static_cast<std::size_t>(operand)]);
  });
}

Phrase ConstantNames::operation_of(const Entry& entry, Scalar scalar) const {
  const auto operand = [&](int k) -> Phrase {
    const double value = entry.constant.operands[k];
    const std::int32_t number = entry.constant.labels[k];
    if (number < 0) return constant_phrase(number_text(value, scalar));
    const Entry& named = entries_[static_cast<std::size_t>(number)];
    const bool is_negative = value != named.constant.value;
    if (!is_written_out(named)) return constant_phrase((is_negative ? "-" : "") + named.identifier);
    const Phrase phrase = operation_of(named, scalar);
    return is_negative ? operation_phrase(scalar, Op::negate, phrase, {}, {}) : phrase;
  };
  return operation_phrase(scalar, entry.constant.op, operand(0), operand(1), {});
}

void ConstantNames::declare(Entry& entry, Scalar scalar, std::string& text) {
  if (std::exchange(entry.is_declared, true)) return;
  for (const std::int32_t operand : entry.constant.labels)
    if (operand >= 0) declare(entries_[static_cast<std::size_t>(operand)], scalar, text);
  if (is_written_out(entry)) return;
  const std::string head = std::string("constexpr ") + name_of(scalar) + " " + entry.identifier + " = ";
  const std::string number = number_text(entry.constant.value, scalar);
  if (!entry.constant.note.empty()) text += wrapped_words(entry.constant.note + ":", "// ") + "\n";
  if (!entry.constant.is_fold()) {
    text += head + number + ";\n";
    return;
  }
  const std::string operation = operation_of(entry, scalar).text;
  const bool is_computed = is_arithmetic(entry);
  text += wrapped_statement(head + (is_computed ? operation : number) + ";") +
          wrapped_words((is_computed ? number : operation), "  // ") + "\n";
}

std::string ConstantNames::declarations(Scalar scalar) {
  std::string text;
  for (Entry& entry : entries_)
    if (entry.is_used) declare(entry, scalar, text);
  return text;
}

}  // namespace mbgen
