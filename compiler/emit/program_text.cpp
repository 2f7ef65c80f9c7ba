#include "compiler/emit/program_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <stdexcept>
#include <unordered_map>

#include "compiler/emit/arrangement.hpp"
#include "compiler/emit/expression_text.hpp"
#include "compiler/emit/function_text.hpp"
#include "compiler/emit/text.hpp"

namespace mbgen {
namespace {

/// Room for `const double s12_345 = ` before an expression that may have to be named later.
constexpr std::size_t kNamingRoom = 28;

/// What is known of a value before its text is written.
struct Fate {
  int users = 0;                     ///< operands that are this value
  ValueId user = kNoValue;           ///< the last of them
  std::size_t part = 0;              ///< of its definition
  bool crosses = false;              ///< used in a later part
  bool paired = false;               ///< sine or cosine that stands beside its partner
  std::vector<std::string> outputs;  ///< places of the result that it goes to
};

class ProgramWriter {
 public:
  ProgramWriter(const Program& program, const ProgramShape& shape)
      : program_(program),
        shape_(shape),
        arrangement_(arrange(program, shape.clock.empty() ? Division::cheapest : Division::by_section)),
        fates_(program.nodes.size()),
        phrases_(program.nodes.size()),
        pending_(program.nodes.size(), false),
        section_counts_(count_operations_by_section(program)),
        section_end_(program.sections.size(), 0) {
    reserve_names();
    decide_fates();
  }

  std::string text() {
    std::vector<PartText> parts;
    for (std::size_t p = 0; p < arrangement_.parts.size(); ++p) parts.push_back(write_part(p));
    return function_text(shape_, parts, crossing_);
  }

 private:
  // --- what is decided before the first line is written ---

  void reserve_names() {
    for (const auto& [name, declaration] : shape_.arguments) taken_.insert(name);
    for (const auto& [group, place] : shape_.inputs) taken_.insert(place.locals.begin(), place.locals.end());
    taken_.insert({"work", "result"});
  }

  void decide_fates() {
    for (std::size_t p = 0; p < arrangement_.parts.size(); ++p) {
      for (std::size_t i = arrangement_.parts[p].first; i < arrangement_.parts[p].last; ++i) {
        const ValueId v = arrangement_.order[i];
        const Node& node = program_.nodes[v];
        fates_[v].part = p;
        section_end_[node.section] = i;
        for (int k = 0; k < arity(node.op); ++k) {
          Fate& operand = fates_[node.operands[k]];
          ++operand.users;
          operand.user = v;
          if (operand.part != p) operand.crosses = true;
        }
        if (i > 0 && is_angle_pair(arrangement_.order[i - 1], v))
          fates_[v].paired = fates_[arrangement_.order[i - 1]].paired = true;
      }
    }
    for (const OutputValue& output : program_.outputs) {
      fates_[output.value].outputs.push_back(output_text(output.slot));
    }
  }

  bool is_angle_pair(ValueId a, ValueId b) const {
    const Node& first = program_.nodes[a];
    const Node& second = program_.nodes[b];
    return ((first.op == Op::sin && second.op == Op::cos) || (first.op == Op::cos && second.op == Op::sin)) &&
           first.operands[0] == second.operands[0];
  }

  /// A value that only its one user needs to know: it becomes part of that user's expression.
  bool can_be_inlined(ValueId v) const {
    const Fate& fate = fates_[v];
    const Node& node = program_.nodes[v];
    if (fate.users != 1 || fate.crosses || fate.paired || !fate.outputs.empty() || node.label >= 0) return false;
    const Node& user = program_.nodes[fate.user];
    return user.section == node.section && user.block == node.block;
  }

  std::string output_text(const Slot& slot) const {
    const auto place = shape_.outputs.find(slot.group);
    if (place == shape_.outputs.end() || slot.index < 0 || slot.index >= static_cast<int>(place->second.texts.size())) {
      throw std::logic_error(program_.name + ": no place for output " + slot.group + "[" + std::to_string(slot.index) +
                             "]");
    }
    return place->second.texts[slot.index];
  }

  // --- names and expressions ---

  std::string unique(const std::string& base) {
    std::string candidate = base;
    for (int& number = next_number_.try_emplace(base, 2).first->second; !taken_.insert(candidate).second; ++number) {
      candidate = numbered(base, number);
    }
    return candidate;
  }

  /// The number that a section's title begins with, as in "3 Rz", else its index.
  std::string section_tag(int section) const {
    const std::string& title = program_.sections[section];
    const std::size_t digits = std::min(title.find_first_not_of("0123456789"), title.size());
    return digits > 0 ? title.substr(0, digits) : std::to_string(section);
  }

  /// The first number in a section's title, as in "step 3: Rz", "" for none.
  std::string step_number(int section) const {
    constexpr const char* kDigits = "0123456789";
    const std::string& title = program_.sections[section];
    const std::size_t first = title.find_first_of(kDigits);
    return first == std::string::npos ? "" : title.substr(first, title.find_first_not_of(kDigits, first) - first);
  }

  /// The label of the value, or its section and a number: s3_12.
  std::string new_name(const Node& node) {
    if (node.label >= 0) return unique(identifier_base(program_.labels[node.label]));
    std::string candidate;
    do {
      candidate = fmt::format("s{}_{}", section_tag(node.section), ++leftovers_[node.section]);
    } while (!taken_.insert(candidate).second);
    return candidate;
  }

  const GroupPlace& input_place(const Slot& slot) const {
    const auto place = shape_.inputs.find(slot.group);
    bool given =
        place != shape_.inputs.end() && slot.index >= 0 && slot.index < static_cast<int>(place->second.texts.size());
    if (given) {
      given = false;
      for (const auto& [name, declaration] : shape_.arguments) given = given || name == place->second.argument;
    }
    if (!given) {
      throw std::logic_error(program_.name + ": no place for input " + slot.group + "[" + std::to_string(slot.index) +
                             "]");
    }
    return place->second;
  }

  Phrase input_phrase(ValueId v, PartText& part) {
    const Slot& slot = program_.inputs[program_.nodes[v].input];
    const GroupPlace& place = input_place(slot);
    part.arguments.insert(place.argument);
    if (place.locals.empty() || input_uses_[v] < 2) return {place.texts[slot.index], Binding::primary};
    const std::string& local = place.locals[slot.index];
    if (copied_inputs_.insert(v).second) {
      add_line(part, "const double " + local + " = " + place.texts[slot.index] + ";");
    }
    return {local, Binding::primary};
  }

  Phrase phrase_of(ValueId v, PartText& part) {
    const Node& node = program_.nodes[v];
    if (node.op == Op::constant) return constant_phrase(node.constant);
    if (node.op == Op::input) return input_phrase(v, part);
    if (fates_[v].crosses) part.arguments.insert("work");
    return phrases_[v];
  }

  Phrase compose(ValueId v, PartText& part) {
    const Node& node = program_.nodes[v];
    Phrase operands[3];
    for (int k = 0; k < arity(node.op); ++k) operands[k] = phrase_of(node.operands[k], part);
    return operation_phrase(node.op, operands[0], operands[1], operands[2]);
  }

  /// The operand with the longest text that has no statement of its own yet, kNoValue when all have.
  ValueId longest_pending_operand(ValueId v) const {
    const Node& node = program_.nodes[v];
    ValueId longest = kNoValue;
    for (int k = 0; k < arity(node.op); ++k) {
      const ValueId operand = node.operands[k];
      if (!pending_[operand]) continue;
      if (longest == kNoValue || phrases_[operand].text.size() > phrases_[longest].text.size()) longest = operand;
    }
    return longest;
  }

  // --- lines ---

  static void add_line(PartText& part, const std::string& line) { part.body += wrapped_statement("  " + line) + "\n"; }

  /// Turns the pending text of a value into a statement.
  void name_value(ValueId v, PartText& part) {
    const std::string name = new_name(program_.nodes[v]);
    add_line(part, "const double " + name + " = " + standing_alone(phrases_[v]) + ";");
    phrases_[v] = {name, Binding::primary};
    pending_[v] = false;
  }

  void store_outputs(ValueId v, PartText& part) {
    for (const std::string& output : fates_[v].outputs) add_line(part, output + " = " + phrases_[v].text + ";");
    if (!fates_[v].outputs.empty()) part.arguments.insert("result");
  }

  /// Writes one value, or keeps its text for its only user.
  void write_value(ValueId v, PartText& part) {
    const Fate& fate = fates_[v];
    phrases_[v] = compose(v, part);
    while (phrases_[v].text.size() + kNamingRoom > kLineWidth) {
      const ValueId operand = longest_pending_operand(v);
      if (operand == kNoValue) break;
      name_value(operand, part);
      phrases_[v] = compose(v, part);
    }
    const Node& node = program_.nodes[v];
    for (int k = 0; k < arity(node.op); ++k) pending_[node.operands[k]] = false;

    if (fate.crosses) {
      const std::string name = new_name(node);
      crossing_.push_back(name);
      part.arguments.insert("work");
      add_line(part, "work." + name + " = " + standing_alone(phrases_[v]) + ";");
      phrases_[v] = {"work." + name, Binding::primary};
    } else if (fate.users == 0 && fate.outputs.size() == 1) {
      part.arguments.insert("result");
      add_line(part, fate.outputs.front() + " = " + standing_alone(phrases_[v]) + ";");
      return;
    } else if (can_be_inlined(v)) {
      pending_[v] = true;
      return;
    } else {
      name_value(v, part);
    }
    store_outputs(v, part);
  }

  void write_headings(const Node& node, PartText& part, int& section, int& block) {
    if (section != node.section) {
      const std::string& title = program_.sections[node.section];
      const bool again = !entered_.insert(node.section).second;
      part.sections.push_back(title);
      if (section >= 0) part.body += "\n";
      if (!title.empty()) add_line(part, "// --- " + comment_text(title) + (again ? ", continued" : "") + " ---");
      section = node.section;
      block = -1;
    }
    if (block != node.block) {
      const std::string& title = program_.blocks[node.block];
      if (!title.empty()) add_line(part, "// " + comment_text(title));
      block = node.block;
    }
  }

  void count_input_uses(const PartRange& range) {
    input_uses_.clear();
    copied_inputs_.clear();
    for (std::size_t i = range.first; i < range.last; ++i) {
      const Node& node = program_.nodes[arrangement_.order[i]];
      for (int k = 0; k < arity(node.op); ++k) ++input_uses_[node.operands[k]];
    }
  }

  PartText write_part(std::size_t p) {
    PartText part;
    const PartRange range = arrangement_.parts[p];
    count_input_uses(range);
    int section = -1, block = -1;
    for (std::size_t i = range.first; i < range.last; ++i) {
      const Node& node = program_.nodes[arrangement_.order[i]];
      write_headings(node, part, section, block);
      write_value(arrangement_.order[i], part);
      if (section_end_[node.section] == i && !program_.sections[node.section].empty()) {
        add_line(part, "// operations: " + operations_text(section_counts_[node.section]));
      }
    }
    if (section >= 0 && section_end_[section] + 1 == range.last) part.ended_step = step_number(section);
    if (p + 1 == arrangement_.parts.size()) write_plain_outputs(part);
    return part;
  }

  /// Outputs that are constants or inputs, and those that the program does not give.
  void write_plain_outputs(PartText& part) {
    std::set<std::string> given;
    for (const OutputValue& output : program_.outputs) {
      const std::string place = output_text(output.slot);
      given.insert(place);
      const Op op = program_.nodes[output.value].op;
      if (op == Op::constant || op == Op::input) {
        add_line(part, place + " = " + standing_alone(phrase_of(output.value, part)) + ";");
        part.arguments.insert("result");
      }
    }
    for (const auto& [group, place] : shape_.outputs) {
      for (const std::string& text : place.texts) {
        if (given.count(text)) continue;
        add_line(part, text + " = " + place.missing + ";");
        part.arguments.insert("result");
      }
    }
  }

  const Program& program_;
  const ProgramShape& shape_;
  Arrangement arrangement_;
  std::vector<Fate> fates_;
  std::vector<Phrase> phrases_;
  std::vector<bool> pending_;
  std::vector<OperationCount> section_counts_;
  std::vector<std::size_t> section_end_;  ///< place of the last value of each section
  std::set<int> entered_;                 ///< sections with a heading so far
  std::set<std::string> taken_;
  std::unordered_map<std::string, int> next_number_;
  std::map<int, int> leftovers_;
  std::vector<std::string> crossing_;
  std::unordered_map<ValueId, int> input_uses_;  ///< in the current part
  std::set<ValueId> copied_inputs_;              ///< in the current part
};

}  // namespace

std::string program_text(const Program& program, const ProgramShape& shape) {
  return ProgramWriter(program, shape).text();
}

std::string operations_text(const OperationCount& count) {
  const std::pair<long, const char*> kinds[] = {
      {count.add, "add"},   {count.multiply, "multiply"},     {count.divide, "divide"},
      {count.sqrt, "sqrt"}, {count.trigonometric, "sin cos"}, {count.other, "other"}};
  std::string text;
  for (const auto& [number, kind] : kinds) {
    if (number > 0) text += (text.empty() ? "" : ", ") + std::to_string(number) + " " + kind;
  }
  return text.empty() ? "none" : text;
}

}  // namespace mbgen
