#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "compiler/emit/headings.hpp"
#include "compiler/emit/text.hpp"
#include "compiler/emit/texts.hpp"
#include "compiler/emit/value_texts.hpp"

namespace mbgen {
namespace {

/// Space for `const double s12_345 = ` before an expression that may get a name later.
constexpr std::size_t kNamingRoom = 28;

/// Least number of equal constants in an array of the result for which it is filled first.
constexpr std::size_t kWorthFilling = 8;

/// Writes the units of a schedule in order: a loop, or straight code as a loop of one slice. A value represents the
/// values at its place in all slices; the first of them is its key in the tables below.
class ProgramWriter {
 public:
  ProgramWriter(const Program& program, const Schedule& schedule, const ProgramShape& shape)
      : program_(program),
        schedule_(schedule),
        shape_(shape),
        texts_(program, schedule, shape),
        pending_(program.nodes.size(), false),
        headings_(program, schedule, shape.titles) {}

  std::string text() {
    std::vector<PartText> parts;
    for (std::size_t p = 0; p < schedule_.parts.size(); ++p) parts.push_back(write_part(p));
    return function_text(shape_, parts, texts_.crossing(), schedule_.law_part);
  }

 private:
  using Slices = ValueTexts::Slices;

  // --- values ---

  /// The operand with the longest text that is not yet a statement, kNoValue if there is none.
  ValueId longest_pending_operand(ValueId v) {
    ValueId longest = kNoValue;
    for (int k = 0; k < arity(program_.nodes[v].op); ++k) {
      const ValueId operand = texts_.facts(v).operands[k];
      if (!pending_[operand]) continue;
      if (longest == kNoValue || texts_.phrase(operand).text.size() > texts_.phrase(longest).text.size())
        longest = operand;
    }
    return longest;
  }

  /// Turns the pending text of a value into a statement.
  void name_value(ValueId v, PartText& part) {
    const std::string name = texts_.name_of(v);
    add_line(part, "const " + texts_.type_of(v) + " " + name + " = " + texts_.phrase(v).text + ";");
    texts_.phrase(v) = {name, Binding::primary};
    pending_[v] = false;
  }

  /// A result with a name of its own is found by it in a text for people.
  bool is_read_by_name(ValueId v) const { return shape_.order == ValueOrder::reading && program_.nodes[v].label >= 0; }

  /// Stores a value where other slices, loops and the result need it.
  void deliver(ValueId v, const std::string& text, PartText& part) {
    if (schedule_.has_loops() && texts_.facts(v).crosses)
      add_line(part, texts_.stored_place(texts_.slices_of(v), part) + " = " + text + ";");
    for (const std::string& output : texts_.output_texts(v, part)) add_line(part, output + " = " + text + ";");
  }

  void write_arguments(const ScheduledUnit& unit, const std::string& array, const Slices& values, PartText& part) {
    std::vector<std::string> list;
    for (const ValueId v : values) {
      const bool is_pair = texts_.scalar_of(v) == Scalar::pairs;
      if (is_pair && pending_[v]) name_value(v, part);
      const std::string text = texts_.phrase_of(unit, {v}, part).text;
      if (is_pair) list.insert(list.end(), {text + "[0]", text + "[1]"});
      if (!is_pair) list.push_back(program_.nodes[v].op == Op::constant ? texts_.number(text) : text);
      pending_[v] = false;
    }
    part.body += braced_list("  const " + type_text(shape_) + " " + array + "[] = ", list, ";\n");
  }

  /// One call for many arguments.
  void write_array_call(const ScheduledUnit& unit, int call, PartText& part) {
    const CallNames& names = texts_.call_names(call);
    const ArrayCall& array_call = schedule_.calls.calls[call];
    write_arguments(unit, names.arguments, array_call.arguments, part);
    if (!names.exponents.empty()) write_arguments(unit, names.exponents, array_call.exponents, part);
    part.arguments.insert(names.work.begin(), names.work.end());
    if (!names.declaration.empty()) add_line(part, names.declaration + ";");
    std::string rest = names.exponents.empty() ? "" : ", " + names.exponents;
    for (const std::string& array : names.results) rest += ", " + array;
    add_line(part, names.function + "(" + names.arguments + rest + ");");
  }

  /// One call for the sine and cosine of an angle.
  void write_angle_pair(const ScheduledUnit& unit, ValueId v, PartText& part) {
    const ValueId partner = texts_.facts(v).partner;
    const Slices angles = schedule_.operands_of(unit, texts_.facts(v).offset, 0);
    const std::string argument = texts_.phrase_of(unit, angles, part).text;
    pending_[angles[0]] = false;
    std::string declared;
    for (const ValueId value : {v, partner}) {
      const std::string name = texts_.name_of(value);
      const bool is_member = texts_.facts(value).crosses && !schedule_.has_loops();
      texts_.phrase(value) = {is_member ? texts_.crossing_place(value, name, part) : name, Binding::primary};
      if (!is_member) declared += (declared.empty() ? texts_.type_of(v) + " " : ", ") + name;
    }
    if (!declared.empty()) add_line(part, declared + ";");
    const bool is_sine = program_.nodes[v].op == Op::sin;
    add_line(part, fmt::format("mbgen::sincos({}, {}, {});", argument, texts_.phrase(is_sine ? v : partner).text,
                               texts_.phrase(is_sine ? partner : v).text));
    deliver(v, texts_.phrase(v).text, part);
    deliver(partner, texts_.phrase(partner).text, part);
  }

  /// Composes a value; operands become statements if the line is too long.
  void compose_in_line(const ScheduledUnit& unit, ValueId v, PartText& part) {
    texts_.phrase(v) = texts_.compose(unit, v, part);
    while (texts_.phrase(v).text.size() + kNamingRoom > shape_.longest_statement) {
      const ValueId operand = longest_pending_operand(v);
      if (operand == kNoValue) break;
      name_value(operand, part);
      texts_.phrase(v) = texts_.compose(unit, v, part);
    }
    for (int k = 0; k < arity(program_.nodes[v].op); ++k) pending_[texts_.facts(v).operands[k]] = false;
  }

  /// Writes one value, or keeps its text for its only user. last: previous value of the part, kNoValue for none.
  void write_value(const ScheduledUnit& unit, ValueId v, ValueId last, PartText& part) {
    const ScheduledValue& value = texts_.facts(v);
    if (const int call = texts_.place_in_call(v).call; call >= 0) {
      if (last == kNoValue || texts_.place_in_call(last).call != call) write_array_call(unit, call, part);
      for (const std::string& output : texts_.output_texts(v, part))
        add_line(part, output + " = " + texts_.result_phrase(v, part).text + ";");
      return;
    }
    if (value.partner != kNoValue) {
      if (value.partner != last) write_angle_pair(unit, v, part);
      return;
    }
    compose_in_line(unit, v, part);
    if (value.crosses && !schedule_.has_loops()) {
      const std::string place = texts_.crossing_place(v, texts_.name_of(v), part);
      add_line(part, place + " = " + texts_.phrase(v).text + ";");
      texts_.phrase(v) = {place, Binding::primary};
    } else if (!value.crosses && value.users == 0 && texts_.output_count(v) == 1 && !is_read_by_name(v)) {
      add_line(part, texts_.output_texts(v, part).front() + " = " + texts_.phrase(v).text + ";");
      return;
    } else if (value.is_inlined) {
      pending_[v] = true;
      return;
    } else {
      name_value(v, part);
    }
    deliver(v, texts_.phrase(v).text, part);
  }

  // --- parts ---

  void write_straight(const ScheduledUnit& unit, PartText& part) {
    const std::size_t start = schedule_.parts[unit.part].first;
    for (std::size_t i = unit.first; i < unit.last(); ++i) {
      const ValueId v = schedule_.order[i];
      headings_.write_before(i, texts_.place_in_call(v).call < 0 && !texts_.facts(v).is_inlined, part);
      write_value(unit, v, i > start ? schedule_.order[i - 1] : kNoValue, part);
      if (shape_.read_back_after > 0 && (i + 1 - start) % shape_.read_back_after == 0) {
        add_line(part, "mbgen::read_back();");
      }
      headings_.write_after(i, i + 1, part);
    }
  }

  void write_loop(const ScheduledUnit& unit, PartText& part) {
    headings_.write_before_loop(unit, part);
    const std::string before = std::exchange(part.body, "");
    part.indent = "    ";
    for (std::size_t i = unit.first; i < unit.first + unit.period; ++i) {
      headings_.write_before(i, true, part);
      write_value(unit, schedule_.order[i], i > unit.first ? schedule_.order[i - 1] : kNoValue, part);
    }
    part.indent = "  ";
    part.body = before + texts_.table_declarations() +
                fmt::format("  for (int k = 0; k < {}; ++k) {{\n{}  }}\n", unit.count, part.body);
    headings_.write_after(unit.first, unit.last(), part);
    headings_.leave_loop();
  }

  PartText write_part(std::size_t p) {
    PartText part;
    texts_.start_part(schedule_.parts[p]);
    headings_.start_part();
    if (p == 0 || p == schedule_.law_part) write_plain_outputs(p > 0, part);
    for (const ScheduledUnit& unit : schedule_.units) {
      if (unit.part != p) continue;
      if (unit.is_loop())
        write_loop(unit, part);
      else
        write_straight(unit, part);
    }
    part.ended_step = headings_.ended_step(schedule_.parts[p].last);
    return part;
  }

  // --- outputs that are no operations ---

  const Slot& input_of(ValueId v) const { return program_.inputs[program_.nodes[v].input]; }

  /// Outputs that are constants or inputs, or that the program does not give; a frequent value fills its array.
  /// of_laws: only results of shared laws, otherwise all others.
  void write_plain_outputs(bool of_laws, PartText& part) {
    std::map<SlotGroup, std::map<int, std::string>> plain;
    std::map<SlotGroup, std::set<int>> given;
    for (const OutputValue& output : program_.outputs) {
      const Op op = program_.nodes[output.value].op;
      given[output.slot.group].insert(output.slot.index);
      texts_.place_of(shape_.outputs, output.slot);
      const bool is_of_law = op == Op::input && input_of(output.value).group.array == Array::law_result;
      if (is_of_law != of_laws) continue;
      if (op == Op::constant)
        plain[output.slot.group][output.slot.index] = texts_.number(texts_.constants_phrase({output.value}).text);
      if (op == Op::input)
        plain[output.slot.group][output.slot.index] = texts_.slots_text(shape_.inputs, {input_of(output.value)}, part);
    }
    for (const auto& [group, place] : shape_.outputs) {
      for (int i = 0; i < static_cast<int>(place.texts.size()); ++i)
        if (!of_laws && !given[group].contains(i) && !place.missing.empty())
          plain[group][i] = texts_.number(place.missing);
      if (plain[group].empty()) continue;
      if (part.body.empty()) add_comment(part, "Results that need no operation.");
      write_plain_group(place, plain[group], part);
    }
    if (!part.body.empty() && !schedule_.order.empty()) part.body += "\n";
  }

  void write_plain_group(const GroupPlace& place, const std::map<int, std::string>& texts, PartText& part) {
    part.arguments.insert(place.argument);
    std::map<std::string, std::size_t> times;
    for (const auto& [index, text] : texts) ++times[text];
    const auto most = std::ranges::max_element(times, {}, [](const auto& entry) { return entry.second; });
    const bool fills = most->second >= kWorthFilling && !place.array.empty();
    if (fills)
      add_line(part, fmt::format("for (int k = {}; k < {}; ++k) {}[k]{} = {};", place.first,
                                 place.first + place.texts.size(), place.array, place.member, most->first));
    for (const auto& [index, text] : texts)
      if (!fills || text != most->first) add_line(part, place.texts[index] + " = " + text + ";");
  }

  const Program& program_;
  const Schedule& schedule_;
  const ProgramShape& shape_;
  ValueTexts texts_;
  std::vector<bool> pending_;  ///< values whose text waits for their only user
  Headings headings_;
};

}  // namespace

std::string program_text(const Program& program, const Schedule& schedule, const ProgramShape& shape) {
  return ProgramWriter(program, schedule, shape).text();
}

}  // namespace mbgen
