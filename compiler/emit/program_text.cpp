#include "compiler/emit/program_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <stdexcept>
#include <unordered_map>

#include "compiler/emit/arrangement.hpp"
#include "compiler/emit/call_names.hpp"
#include "compiler/emit/expression_text.hpp"
#include "compiler/emit/fates.hpp"
#include "compiler/emit/function_text.hpp"
#include "compiler/emit/headings.hpp"
#include "compiler/emit/local_names.hpp"
#include "compiler/emit/rolled_text.hpp"
#include "compiler/emit/text.hpp"

namespace mbgen {
namespace {

/// Room for `const double s12_345 = ` before an expression that may have to be named later.
constexpr std::size_t kNamingRoom = 28;

class ProgramWriter {
 public:
  ProgramWriter(const Program& program, const ProgramShape& shape)
      : program_(program),
        shape_(shape),
        arrangement_(arrange(program, shape.clock.empty() ? Division::cheapest : Division::by_section)),
        fates_(decide_fates(program, arrangement_)),
        phrases_(program.nodes.size()),
        pending_(program.nodes.size(), false),
        names_(program),
        headings_(program, arrangement_) {
    reserve_names();
    name_outputs();
    name_calls();
  }

  std::string text() {
    std::vector<PartText> parts;
    for (std::size_t p = 0; p < arrangement_.parts.size(); ++p) parts.push_back(write_part(p));
    return function_text(shape_, parts, crossing_);
  }

 private:
  // --- what is decided before the first line is written ---

  void reserve_names() {
    if (shape_.constants != nullptr) {
      for (const std::string& name : shape_.constants->identifiers(program_)) names_.reserve(name);
    }
    for (const auto& [name, declaration] : shape_.arguments) names_.reserve(name);
    for (const auto& [group, place] : shape_.inputs) {
      for (const std::string& local : place.locals) names_.reserve(local);
    }
    for (const char* name : {"work", "result"}) names_.reserve(name);
  }

  void name_outputs() {
    for (const OutputValue& output : program_.outputs) {
      fates_[output.value].outputs.push_back(output_text(output.slot));
    }
  }

  /// Where the calls for many arguments leave their results: in `work` when another part needs one of them.
  void name_calls() {
    const std::vector<ArrayCall>& calls = arrangement_.array_calls.calls;
    std::vector<bool> crosses(calls.size(), false);
    for (const ValueId v : arrangement_.order) {
      if (fates_[v].crosses && place_in_call(v).call >= 0) crosses[place_in_call(v).call] = true;
    }
    for (std::size_t c = 0; c < calls.size(); ++c) {
      CallNames names = names_of_call(calls[c].op);
      names.arguments = names_.unique(names.arguments);
      if (!names.exponents.empty()) names.exponents = names_.unique(names.exponents);
      for (std::string& array : names.results) {
        array = names_.unique(array);
        const std::size_t size = calls[c].arguments.size();
        const std::string declared = fmt::format("{}[{}]", array, size);
        if (crosses[c]) {
          const std::string argument = add_crossing(declared, size);
          names.work.insert(argument);
          array = argument + "." + array;
        } else {
          names.declaration += (names.declaration.empty() ? shape_.scalar + " " : ", ") + declared;
        }
      }
      call_names_.push_back(names);
    }
  }

  /// Declares a member of `work`. Result: the argument that holds it.
  std::string add_crossing(const std::string& member, std::size_t values) {
    const auto name_of = [&](std::size_t number) { return number == 1 ? std::string("work") : names_.unique("work"); };
    CrossingStruct& home = struct_with_room(crossing_, values, shape_.most_crossing, name_of);
    home.members.push_back(member);
    home.values += values;
    return home.argument;
  }

  /// The place of a value in `work`, and the argument noted.
  std::string crossing_place(ValueId v, const std::string& name, PartText& part) {
    const std::string argument = work_of_[v] = add_crossing(name, 1);
    part.arguments.insert(argument);
    return argument + "." + name;
  }

  const ArrayPlace& place_in_call(ValueId v) const { return arrangement_.array_calls.place[v]; }

  std::string output_text(const Slot& slot) const {
    const auto place = shape_.outputs.find(slot.group);
    if (place == shape_.outputs.end() || slot.index < 0 || slot.index >= static_cast<int>(place->second.texts.size())) {
      throw std::logic_error(program_.name + ": no place for output " + text_of(slot));
    }
    return place->second.texts[slot.index];
  }

  // --- names and expressions ---

  const GroupPlace& input_place(const Slot& slot) const {
    const auto place = shape_.inputs.find(slot.group);
    bool given =
        place != shape_.inputs.end() && slot.index >= 0 && slot.index < static_cast<int>(place->second.texts.size());
    if (given) {
      given = false;
      for (const auto& [name, declaration] : shape_.arguments) given = given || name == place->second.argument;
    }
    if (!given) {
      throw std::logic_error(program_.name + ": no place for input " + text_of(slot));
    }
    return place->second;
  }

  Phrase input_phrase(ValueId v, PartText& part) {
    const Slot& slot = program_.inputs[program_.nodes[v].input];
    const GroupPlace& place = input_place(slot);
    part.arguments.insert(place.argument);
    if (place.locals.empty() || uses_in_part_[v] < 2) return {place.texts[slot.index], Binding::primary};
    return copied(v, place.locals[slot.index], place.texts[slot.index], part);
  }

  /// A value in memory that this part reads often, by a name of its own.
  Phrase copied(ValueId v, const std::string& local, const std::string& place, PartText& part) {
    if (copied_in_part_.insert(v).second) add_line(part, "const " + shape_.scalar + " " + local + " = " + place + ";");
    return {local, Binding::primary};
  }

  /// A result of a call for many arguments.
  Phrase result_phrase(ValueId v, PartText& part) {
    const CallNames& names = call_names_[place_in_call(v).call];
    part.arguments.insert(names.work.begin(), names.work.end());
    const std::string& array = program_.nodes[v].op == Op::cos ? names.results.back() : names.results.front();
    const std::string place = fmt::format("{}[{}]", array, place_in_call(v).argument);
    if (uses_in_part_[v] < 2) return {place, Binding::primary};
    std::string& local = local_of_[v];
    if (local.empty()) local = names_.of_value(v);
    return copied(v, local, place, part);
  }

  Phrase phrase_of(ValueId v, PartText& part) {
    const Node& node = program_.nodes[v];
    if (node.op == Op::constant) return constant_phrase(constant_text(program_, node, shape_));
    if (node.op == Op::input) return input_phrase(v, part);
    if (place_in_call(v).call >= 0) return result_phrase(v, part);
    if (fates_[v].crosses) part.arguments.insert(work_of_.at(v));
    return phrases_[v];
  }

  Phrase compose(ValueId v, PartText& part) {
    const Node& node = program_.nodes[v];
    Phrase operands[3];
    for (int k = 0; k < arity(node.op); ++k) operands[k] = phrase_of(node.operands[k], part);
    return operation_phrase(shape_.scalar, node.op, operands[0], operands[1], operands[2]);
  }

  bool is_in_lanes() const { return !is_number(shape_.scalar); }

  /// A plain number where a value is asked for.
  std::string number(const std::string& text) const { return (is_in_lanes() ? shape_.scalar + "{} + " : "") + text; }

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
    const std::string name = names_.of_value(v);
    add_line(part, "const " + shape_.scalar + " " + name + " = " + standing_alone(phrases_[v]) + ";");
    phrases_[v] = {name, Binding::primary};
    pending_[v] = false;
  }

  void store_outputs(ValueId v, PartText& part) {
    for (const std::string& output : fates_[v].outputs) add_line(part, output + " = " + phrases_[v].text + ";");
    if (!fates_[v].outputs.empty()) part.arguments.insert("result");
  }

  void write_arguments(const std::string& array, const std::vector<ValueId>& values, PartText& part) {
    std::vector<std::string> list;
    for (const ValueId v : values) {
      const bool is_number = program_.nodes[v].op == Op::constant;
      list.push_back(is_number ? number(phrase_of(v, part).text) : phrase_of(v, part).text);
      pending_[v] = false;
    }
    part.body += braced_list("  const " + shape_.scalar + " " + array + "[] = ", list, ";\n");
  }

  /// One call for many arguments.
  void write_array_call(int call, PartText& part) {
    const CallNames& names = call_names_[call];
    const ArrayCall& array_call = arrangement_.array_calls.calls[call];
    write_arguments(names.arguments, array_call.arguments, part);
    if (!names.exponents.empty()) write_arguments(names.exponents, array_call.exponents, part);
    part.arguments.insert(names.work.begin(), names.work.end());
    if (!names.declaration.empty()) add_line(part, names.declaration + ";");
    std::string rest = names.exponents.empty() ? "" : ", " + names.exponents;
    for (const std::string& array : names.results) rest += ", " + array;
    add_line(part, names.function + "(" + names.arguments + rest + ");");
  }

  /// One call for the sine and cosine of an angle.
  void write_angle_pair(ValueId v, PartText& part) {
    const ValueId partner = fates_[v].partner;
    const ValueId angle = program_.nodes[v].operands[0];
    const std::string argument = phrase_of(angle, part).text;
    pending_[angle] = false;
    std::string declared;
    for (const ValueId value : {v, partner}) {
      const std::string name = names_.of_value(value);
      phrases_[value] = {fates_[value].crosses ? crossing_place(value, name, part) : name, Binding::primary};
      if (!fates_[value].crosses) {
        declared += (declared.empty() ? shape_.scalar + " " : ", ") + name;
      }
    }
    if (!declared.empty()) add_line(part, declared + ";");
    const bool is_sine = program_.nodes[v].op == Op::sin;
    add_line(part, fmt::format("mbgen::sincos({}, {}, {});", argument, phrases_[is_sine ? v : partner].text,
                               phrases_[is_sine ? partner : v].text));
    store_outputs(v, part);
    store_outputs(partner, part);
  }

  /// Writes one value, or keeps its text for its only user. last: value before it, kNoValue for none.
  void write_value(ValueId v, ValueId last, PartText& part) {
    const Fate& fate = fates_[v];
    if (const int call = place_in_call(v).call; call >= 0) {
      if (last == kNoValue || place_in_call(last).call != call) write_array_call(call, part);
      for (const std::string& output : fate.outputs) {
        add_line(part, output + " = " + result_phrase(v, part).text + ";");
        part.arguments.insert("result");
      }
      return;
    }
    if (fate.partner != kNoValue) {
      if (fate.partner != last) write_angle_pair(v, part);
      return;
    }
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
      const std::string place = crossing_place(v, names_.of_value(v), part);
      add_line(part, place + " = " + standing_alone(phrases_[v]) + ";");
      phrases_[v] = {place, Binding::primary};
    } else if (fate.users == 0 && fate.outputs.size() == 1) {
      part.arguments.insert("result");
      add_line(part, fate.outputs.front() + " = " + standing_alone(phrases_[v]) + ";");
      return;
    } else if (can_be_inlined(program_, fates_, v)) {
      pending_[v] = true;
      return;
    } else {
      name_value(v, part);
    }
    store_outputs(v, part);
  }

  /// The angles of one call are written once.
  void count_uses(const PartRange& range) {
    uses_in_part_.clear();
    copied_in_part_.clear();
    for (std::size_t i = range.first; i < range.last; ++i) {
      if (place_in_call(arrangement_.order[i]).call >= 0) continue;
      const Node& node = program_.nodes[arrangement_.order[i]];
      for (int k = 0; k < arity(node.op); ++k) ++uses_in_part_[node.operands[k]];
    }
  }

  PartText write_part(std::size_t p) {
    PartText part;
    const PartRange range = arrangement_.parts[p];
    count_uses(range);
    headings_.start_part();
    for (std::size_t i = range.first; i < range.last; ++i) {
      const ValueId v = arrangement_.order[i];
      headings_.write_before(i, place_in_call(v).call >= 0, part);
      write_value(v, i > range.first ? arrangement_.order[i - 1] : kNoValue, part);
      if (shape_.read_back_after > 0 && (i + 1 - range.first) % shape_.read_back_after == 0) {
        add_line(part, "mbgen::read_back();");
      }
      headings_.write_after(i, part);
    }
    part.ended_step = headings_.ended_step(range.last);
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
        const std::string value = standing_alone(phrase_of(output.value, part));
        add_line(part, place + " = " + (op == Op::constant ? number(value) : value) + ";");
        part.arguments.insert("result");
      }
    }
    for (const auto& [group, place] : shape_.outputs) {
      for (const std::string& text : place.texts) {
        if (given.count(text) || place.missing.empty()) continue;
        add_line(part, text + " = " + number(place.missing) + ";");
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
  LocalNames names_;
  Headings headings_;
  CrossingStructs crossing_;
  std::unordered_map<ValueId, std::string> work_of_;  ///< arguments that hold the values that cross
  std::vector<CallNames> call_names_;
  std::unordered_map<ValueId, std::string> local_of_;  ///< of results of calls for many arguments
  std::unordered_map<ValueId, int> uses_in_part_;      ///< of the current part
  std::set<ValueId> copied_in_part_;                   ///< the current one
};

}  // namespace

std::string program_text(const Program& program, const ProgramShape& shape) {
  if (const std::optional<Rolling> rolling = rolled(program, shape)) return rolled_text(program, shape, *rolling);
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
