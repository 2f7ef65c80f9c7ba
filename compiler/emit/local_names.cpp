#include "compiler/emit/local_names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "compiler/emit/quantity_names.hpp"
#include "compiler/emit/text.hpp"

namespace mbgen {
namespace {

/// "p", "arm", "_x" of "p_arm_x": kind, part of the model, axis.
struct NameParts {
  std::string kind, of, axis;
};

NameParts parts_of(const std::string& name) {
  const std::size_t first = name.find('_');
  if (first == std::string::npos) return {name, "", ""};
  NameParts parts{name.substr(0, first), name.substr(first + 1), ""};
  const std::size_t last = parts.of.rfind('_');
  if (last != std::string::npos && last + 2 == parts.of.size() &&
      std::string_view("xyz").find(parts.of[last + 1]) != std::string_view::npos) {
    parts.axis = parts.of.substr(last);
    parts.of.resize(last);
  }
  return parts;
}

/// "mp_arm_x" of m_arm and p_arm_x, where that is a kind of quantity; else "product_of_m_arm_and_p_leg_x".
std::string name_of_product(const std::string& a, const std::string& b) {
  constexpr std::string_view kHalf = "half_";
  if (a.starts_with(kHalf)) return std::string(kHalf) + name_of_product(a.substr(kHalf.size()), b);
  const NameParts first = parts_of(a), second = parts_of(b);
  const std::string name = first.kind + second.kind + "_" + second.of + first.axis + second.axis;
  const bool is_of_one_part = second.of == first.of || second.of.starts_with(first.of + "_");
  if (is_of_one_part && quantity_of(name).prefix == first.kind + second.kind) return name;
  return a == b ? "square_of_" + a : fmt::format("product_of_{}_and_{}", a, b);
}

/// A number times a name, "" for one without a word.
std::string multiple(double number, const std::string& name) {
  return number == 0.5 ? "half_" + name : number == 2 ? "twice_" + name : number == -1 ? "minus_" + name : "";
}

/// The kind of a number that is made of too much for a name.
std::string word_of(Op op) {
  switch (op) {
    case Op::multiply:
      return "product";
    case Op::divide:
      return "ratio";
    case Op::add:
      return "sum";
    case Op::subtract:
      return "difference";
    case Op::sqrt:
      return "root";
    default:
      return "number";
  }
}

}  // namespace

void LocalNames::name_parts(const std::vector<std::string>& results) {
  const std::size_t count = program_.nodes.size();
  std::vector<ValueId> user(count, kNoValue);
  std::vector<bool> has_others(count);
  whole_.assign(count, "");
  // Users stand behind their operands, so the name of a whole is known when its parts are met.
  for (ValueId v = static_cast<ValueId>(count); v-- > 0;) {
    const Node& node = program_.nodes[v];
    if (node.label < 0 && results[v].empty() && user[v] != kNoValue && !has_others[v]) {
      const ValueId by = user[v];
      const std::int32_t label = program_.nodes[by].label;
      whole_[v] = label >= 0 ? program_.labels[label] : !results[by].empty() ? results[by] : whole_[by];
    }
    for (int k = 0; k < arity(node.op); ++k) {
      const ValueId operand = node.operands[k];
      has_others[operand] = has_others[operand] || (user[operand] != kNoValue && user[operand] != v);
      user[operand] = v;
    }
  }
}

std::string LocalNames::of_value(ValueId value) {
  const Node& node = program_.nodes[value];
  if (node.label >= 0) return identifier(program_.labels[node.label]);
  if (!whole_.empty() && !whole_[value].empty()) {
    const std::string& whole = whole_[value];
    return identifier(fmt::format("{}_part_{}", whole, ++parts_[whole]));
  }
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
  if (entry.identifier.empty()) {
    const std::string name = name_of_fold(entry);
    entry.identifier = names_.identifier(name.empty() ? word_of(entry.constant.op) : name);
  }
  entry.is_used = true;
  return node.constant == entry.constant.value ? entry.identifier : "-" + entry.identifier;
}

void ConstantNames::add_uses(const ConstantNames& copy) {
  if (copy.entries_.size() != entries_.size()) throw std::logic_error("a text names a constant of no program");
  for (std::size_t i = 0; i < entries_.size(); ++i)
    entries_[i].is_used = entries_[i].is_used || copy.entries_[i].is_used;
}

bool ConstantNames::is_arithmetic(const Entry& entry) const {
  const Op op = entry.constant.op;
  if (op != Op::add && op != Op::subtract && op != Op::multiply && op != Op::divide && op != Op::negate) return false;
  return std::ranges::all_of(entry.constant.labels, [&](std::int32_t operand) {
    return operand < 0 || !is_written_out(entries_[static_cast<std::size_t>(operand)]) ||
           is_arithmetic(entries_[static_cast<std::size_t>(operand)]);
  });
}

std::string ConstantNames::name_of_operand(const Entry& entry, int k) const {
  const std::int32_t number = entry.constant.labels[k];
  if (number < 0) return "";
  const Entry& named = entries_[static_cast<std::size_t>(number)];
  const std::string name = named.identifier.empty() ? name_of_fold(named) : named.identifier;
  return name.empty() || entry.constant.operands[k] == named.constant.value ? name : "minus_" + name;
}

std::string ConstantNames::name_of_fold(const Entry& entry) const {
  constexpr std::size_t kLongest = 60;
  const NamedConstant& fold = entry.constant;
  const std::string a = name_of_operand(entry, 0), b = name_of_operand(entry, 1);
  const bool has_both = !a.empty() && !b.empty();
  const std::string& only = a.empty() ? b : a;
  const double number = fold.operands[a.empty() ? 0 : 1];
  std::string name;
  if (only.empty()) return "";
  if (fold.op == Op::multiply) name = has_both ? name_of_product(a, b) : multiple(number, only);
  if (fold.op == Op::divide) name = has_both ? fmt::format("ratio_of_{}_and_{}", a, b) : "";
  if (fold.op == Op::divide && a.empty() && number == 1) name = "per_" + b;
  if (fold.op == Op::add && has_both) name = a == b ? "twice_" + a : fmt::format("sum_of_{}_and_{}", a, b);
  if (fold.op == Op::subtract && has_both) name = fmt::format("difference_of_{}_and_{}", a, b);
  if (fold.op == Op::negate) name = "minus_" + a;
  if (fold.op == Op::sqrt) name = "root_of_" + a;
  if ((fold.op == Op::max || fold.op == Op::min) && !has_both) name = "limited_" + only;
  return name.size() > kLongest ? "" : name;
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
  return phrase_for_people(scalar, entry.constant.op, operand(0), operand(1), {});
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
