#include "compiler/emit/rolled_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <stdexcept>

#include "compiler/emit/expression_text.hpp"
#include "compiler/emit/function_text.hpp"
#include "compiler/emit/local_names.hpp"
#include "compiler/emit/program_text.hpp"
#include "compiler/emit/rolled_places.hpp"
#include "compiler/emit/text.hpp"

namespace mbgen {
namespace {

/// From this many equal constants in an array of the result on, it is filled first.
constexpr std::size_t kWorthFilling = 8;

/// What labels of one value in two slices have in common: "R_up_xx" of "R_up1_xx" and "R_up2_xx".
std::string common_label(const std::string& a, const std::string& b) {
  const std::size_t shorter = std::min(a.size(), b.size());
  std::size_t front = 0, back = 0;
  while (front < shorter && a[front] == b[front]) ++front;
  while (back + front < shorter && a[a.size() - 1 - back] == b[b.size() - 1 - back]) ++back;
  return a.substr(0, front) + a.substr(a.size() - back);
}

std::set<SlotGroup> indexed_groups(const ProgramShape& shape) {
  std::set<SlotGroup> groups;
  for (const Places* places : {&shape.inputs, &shape.outputs})
    for (const auto& [group, place] : *places)
      if (!place.array.empty()) groups.insert(group);
  return groups;
}

class RolledWriter {
 public:
  RolledWriter(const Program& program, const ProgramShape& shape, const Rolling& rolling)
      : program_(program),
        shape_(shape),
        rolling_(rolling),
        places_(place_values(program, rolling)),
        outputs_(program.nodes.size()),
        section_counts_(count_operations_by_section(program)),
        section_end_(program.sections.size(), 0),
        names_taken_(program) {
    if (shape_.constants != nullptr) {
      for (const std::string& name : shape_.constants->identifiers(program_)) names_taken_.reserve(name);
    }
    for (const auto& [name, declaration] : shape_.arguments) names_taken_.reserve(name);
    for (const char* name : {"work", "result", "k"}) names_taken_.reserve(name);
    for (const OutputValue& output : program_.outputs) outputs_[output.value].push_back(output.slot);
    for (std::size_t i = 0; i < rolling_.order.size(); ++i) section_end_[program_.nodes[rolling_.order[i]].section] = i;
    for (const RolledUnit& unit : places_.units) names_.emplace_back(unit.period);
  }

  std::string text() {
    std::vector<PartText> parts(1);
    part_ = &parts[0];
    write_plain_outputs();
    std::size_t number = 0;
    for (std::size_t u = 0; u < places_.units.size(); ++u) {
      if (u == 0 || places_.units[u].part != number) {
        number = places_.units[u].part;
        parts.emplace_back();
        part_ = &parts.back();
        section_ = block_ = -1;
        tables_.clear();
      }
      write_unit(u);
    }
    if (parts[0].body.empty() && parts.size() > 2) parts.erase(parts.begin());
    return function_text(shape_, parts, {{"work", {fmt::format("value[{}]", std::max(places_.stored, 1))}}});
  }

 private:
  // --- texts of indices, inputs, constants ---

  void add_line(const std::string& line) { part_->body += wrapped_statement(indent_ + line) + "\n"; }

  /// A linear function of the slice `k`, or a table.
  std::string index_text(const std::vector<int>& indices) {
    const int first = indices[0], step = indices.size() > 1 ? indices[1] - first : 0;
    for (std::size_t slice = 0; slice < indices.size(); ++slice) {
      if (indices[slice] == first + step * static_cast<int>(slice)) continue;
      std::vector<std::string> items;
      for (const int index : indices) items.push_back(std::to_string(index));
      return table_text("int", "kPlaces", items);
    }
    if (step == 0) return std::to_string(first);
    const std::string slope = (std::abs(step) == 1 ? "" : std::to_string(std::abs(step)) + "*") + "k";
    if (first == 0 && step > 0) return slope;
    return std::to_string(first) + (step > 0 ? " + " : " - ") + slope;
  }

  /// `name[k]` of a table with these items, which is written before the loop once in each part.
  std::string table_text(const std::string& type, const std::string& base, const std::vector<std::string>& items) {
    std::string& name = tables_[{type, items}];
    if (name.empty()) {
      name = names_taken_.unique(base);
      before_loop_ += array_text("  static constexpr " + type + " " + name, items, "0") + "\n";
    }
    return name + "[k]";
  }

  std::string slots_text(const GroupPlace& place, const std::vector<int>& indices) {
    const bool same = std::all_of(indices.begin(), indices.end(), [&](int i) { return i == indices[0]; });
    if (indices[0] < 0 || indices[0] >= static_cast<int>(place.texts.size()))
      throw std::logic_error(program_.name + ": no place for a slot of " + place.argument);
    if (same) return place.texts[static_cast<std::size_t>(indices[0])];
    std::vector<int> places;
    for (const int index : indices) places.push_back(place.first + index);
    return place.array + "[" + index_text(places) + "]";
  }

  const GroupPlace& place_of(const Places& places, SlotGroup group) const {
    const auto place = places.find(group);
    if (place == places.end()) throw std::logic_error(program_.name + ": no place for group " + text_of(group));
    return place->second;
  }

  Phrase input_phrase(const std::vector<ValueId>& operands) {
    std::vector<int> indices;
    for (const ValueId v : operands) indices.push_back(slot_of(v).index);
    const GroupPlace& place = place_of(shape_.inputs, slot_of(operands[0]).group);
    part_->arguments.insert(place.argument);
    return {slots_text(place, indices), Binding::primary};
  }

  const Slot& slot_of(ValueId v) const { return program_.inputs[static_cast<std::size_t>(program_.nodes[v].input)]; }

  Phrase constants_phrase(const std::vector<ValueId>& operands) {
    const Node& first = program_.nodes[operands[0]];
    std::vector<std::string> items;
    bool same = true;
    for (const ValueId v : operands) {
      same = same && program_.nodes[v].constant == first.constant && program_.nodes[v].label == first.label;
      items.push_back(number_text(program_.nodes[v].constant, shape_.scalar));
    }
    return same ? constant_phrase(constant_text(program_, first, shape_))
                : Phrase{table_text(shape_.scalar, "kConstants", items), Binding::primary};
  }

  Phrase operand_phrase(std::size_t unit, const std::vector<ValueId>& operands) {
    const Op op = program_.nodes[operands[0]].op;
    if (op == Op::constant) return constants_phrase(operands);
    if (op == Op::input) return input_phrase(operands);
    const RolledPlace& place = places_.of[operands[0]];
    if (is_local(places_, unit, operands))
      return {names_[static_cast<std::size_t>(place.unit)][place.offset], Binding::primary};
    std::vector<int> indices;
    for (const ValueId v : operands) indices.push_back(places_.index_of(v));
    part_->arguments.insert("work");
    return {"work.value[" + index_text(indices) + "]", Binding::primary};
  }

  // --- names ---

  std::string name_of(const RolledUnit& unit, std::size_t offset) {
    const Node& first = program_.nodes[rolling_.order[unit.first + offset]];
    const Node& last = program_.nodes[rolling_.order[unit.first + (unit.count - 1) * unit.period + offset]];
    if (first.label < 0 || last.label < 0 || !unit.is_loop)
      return names_taken_.of_value(rolling_.order[unit.first + offset]);
    const std::string& a = program_.labels[static_cast<std::size_t>(first.label)];
    const std::string& b = program_.labels[static_cast<std::size_t>(last.label)];
    return names_taken_.unique(identifier_base(common_label(a, b)));
  }

  // --- units ---

  void write_headings(const Node& node) {
    if (section_ != node.section) {
      const std::string& title = program_.sections[node.section];
      const bool again = !entered_.insert(node.section).second;
      part_->sections.push_back(title);
      if (section_ >= 0) part_->body += "\n";
      if (!title.empty()) add_line("// --- " + comment_text(title) + (again ? ", continued" : "") + " ---");
      section_ = node.section;
      block_ = -1;
    }
    if (block_ != node.block && !program_.blocks[node.block].empty())
      add_line("// " + comment_text(program_.blocks[node.block]));
    block_ = node.block;
  }

  const Node& node_at(const RolledUnit& unit, std::size_t offset) const {
    return program_.nodes[rolling_.order[unit.first + offset]];
  }

  /// Sine and cosine of the same angles stand side by side: one call.
  bool is_angle_pair(std::size_t u, std::size_t offset) const {
    const RolledUnit& unit = places_.units[u];
    if (offset + 1 >= unit.period) return false;
    const Op first = node_at(unit, offset).op, second = node_at(unit, offset + 1).op;
    const bool pair = (first == Op::sin && second == Op::cos) || (first == Op::cos && second == Op::sin);
    return pair && operands_of(places_, rolling_, u, offset, 0) == operands_of(places_, rolling_, u, offset + 1, 0);
  }

  /// Writes the value at `offset`, or it and the next; the result is how many.
  std::size_t write_value(std::size_t u, std::size_t offset) {
    const RolledUnit& unit = places_.units[u];
    const Node& node = node_at(unit, offset);
    Phrase operands[3];
    for (int k = 0; k < arity(node.op); ++k)
      operands[k] = operand_phrase(u, operands_of(places_, rolling_, u, offset, k));
    const std::string& name = names_[u][offset] = name_of(unit, offset);
    if (is_angle_pair(u, offset)) {
      const std::string& other = names_[u][offset + 1] = name_of(unit, offset + 1);
      add_line(shape_.scalar + " " + name + ", " + other + ";");
      const bool sine_first = node.op == Op::sin;
      add_line(fmt::format("mbgen::sincos({}, {}, {});", standing_alone(operands[0]), sine_first ? name : other,
                           sine_first ? other : name));
      deliver(unit, offset);
      deliver(unit, offset + 1);
      return 2;
    }
    add_line("const " + shape_.scalar + " " + name + " = " +
             standing_alone(operation_phrase(shape_.scalar, node.op, operands[0], operands[1], operands[2])) + ";");
    deliver(unit, offset);
    return 1;
  }

  /// Stores a value where others look for it.
  void deliver(const RolledUnit& unit, std::size_t offset) {
    const std::string& name = names_[static_cast<std::size_t>(&unit - places_.units.data())][offset];
    if (unit.stored[offset] >= 0) {
      part_->arguments.insert("work");
      std::vector<int> indices;
      for (std::size_t slice = 0; slice < unit.count; ++slice)
        indices.push_back(unit.first_stored + static_cast<int>(slice) * unit.stride + unit.stored[offset]);
      add_line("work.value[" + index_text(indices) + "] = " + name + ";");
    }
    write_outputs(unit, offset, name);
  }

  void write_outputs(const RolledUnit& unit, std::size_t offset, const std::string& name) {
    const std::vector<Slot>& slots = outputs_[rolling_.order[unit.first + offset]];
    for (std::size_t n = 0; n < slots.size(); ++n) {
      std::vector<int> indices;
      for (std::size_t slice = 0; slice < unit.count; ++slice)
        indices.push_back(outputs_[rolling_.order[unit.first + slice * unit.period + offset]][n].index);
      part_->arguments.insert("result");
      add_line(slots_text(place_of(shape_.outputs, slots[n].group), indices) + " = " + name + ";");
    }
  }

  void write_unit(std::size_t u) {
    const RolledUnit& unit = places_.units[u];
    const Node& first = program_.nodes[rolling_.order[unit.first]];
    const std::size_t end = unit.first + unit.period * unit.count;
    if (unit.is_loop) {
      write_headings(first);
      const Node& last = program_.nodes[rolling_.order[end - unit.period]];
      if (last.block != first.block) add_line("// to " + comment_text(program_.blocks[last.block]));
    }
    std::string outside;
    std::swap(outside, part_->body);
    if (unit.is_loop) indent_ = "    ";
    for (std::size_t offset = 0; offset < unit.period;) {
      const std::size_t place = unit.first + offset;
      write_headings(program_.nodes[rolling_.order[place]]);
      const std::size_t written = write_value(u, offset);
      offset += written;
      if (!unit.is_loop) write_count(place, place + written);
    }
    indent_ = "  ";
    std::swap(outside, part_->body);
    part_->body += before_loop_;
    before_loop_.clear();
    if (unit.is_loop)
      part_->body += fmt::format("  for (int k = 0; k < {}; ++k) {{\n{}  }}\n", unit.count, outside);
    else
      part_->body += outside;
    if (unit.is_loop) {
      write_count(unit.first, end);
      block_ = -1;
    }
  }

  /// The operation counts of the sections that end in a range of places.
  void write_count(std::size_t first, std::size_t last) {
    for (std::size_t s = 0; s < section_end_.size(); ++s)
      if (section_end_[s] >= first && section_end_[s] < last && !program_.sections[s].empty() &&
          entered_.count(static_cast<int>(s)))
        add_line("// operations: " + operations_text(section_counts_[s]));
  }

  // --- outputs that are no operations ---

  std::string plain_text(const OutputValue& output) {
    const Node& node = program_.nodes[output.value];
    if (node.op != Op::constant) return input_phrase({output.value}).text;
    return standing_alone(constant_phrase(constant_text(program_, node, shape_)));
  }

  /// Constants, inputs, and outputs that the program does not give: what is frequent fills its array first.
  void write_plain_outputs() {
    std::map<SlotGroup, std::map<int, std::string>> plain;  // by group, then index
    std::map<SlotGroup, std::set<int>> given;
    for (const OutputValue& output : program_.outputs) {
      const Op op = program_.nodes[output.value].op;
      given[output.slot.group].insert(output.slot.index);
      if (op == Op::constant || op == Op::input) plain[output.slot.group][output.slot.index] = plain_text(output);
    }
    for (const auto& [group, place] : shape_.outputs) {
      for (int i = 0; i < static_cast<int>(place.texts.size()); ++i)
        if (!given[group].count(i) && !place.missing.empty()) plain[group][i] = place.missing;
      if (!plain[group].empty()) write_plain_group(place, plain[group]);
    }
  }

  void write_plain_group(const GroupPlace& place, const std::map<int, std::string>& texts) {
    part_->arguments.insert("result");
    std::map<std::string, std::size_t> times;
    for (const auto& [index, text] : texts) ++times[text];
    const auto most =
        std::max_element(times.begin(), times.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
    const bool fills = most->second >= kWorthFilling && !place.array.empty();
    if (fills)
      add_line(fmt::format("for (int k = {}; k < {}; ++k) {}[k] = {};", place.first,
                           place.first + static_cast<int>(place.texts.size()), place.array, most->first));
    for (const auto& [index, text] : texts)
      if (!fills || text != most->first) add_line(place.texts[static_cast<std::size_t>(index)] + " = " + text + ";");
  }

  const Program& program_;
  const ProgramShape& shape_;
  const Rolling& rolling_;
  RolledPlaces places_;
  std::vector<std::vector<Slot>> outputs_;  ///< per value
  std::vector<OperationCount> section_counts_;
  std::vector<std::size_t> section_end_;         ///< place of the last value of each section
  std::vector<std::vector<std::string>> names_;  ///< per unit, per value of a slice
  std::set<int> entered_;                        ///< sections with a heading so far
  LocalNames names_taken_;
  std::map<std::pair<std::string, std::vector<std::string>>, std::string> tables_;  ///< names, in the current part
  PartText* part_ = nullptr;
  std::string indent_ = "  ", before_loop_;
  int section_ = -1, block_ = -1;
};

}  // namespace

std::optional<Rolling> rolled(const Program& program, const ProgramShape& shape) {
  const auto statements = [&](std::size_t operations) { return operations + program.outputs.size(); };
  if (!shape.clock.empty() || statements(program.nodes.size()) <= shape.roll_above) return std::nullopt;
  Rolling rolling = roll(program, indexed_groups(shape));
  if (statements(rolling.order.size()) <= shape.roll_above) return std::nullopt;
  if (2 * rolling.written() > rolling.order.size()) return std::nullopt;
  return rolling;
}

std::string rolled_text(const Program& program, const ProgramShape& shape, const Rolling& rolling) {
  return RolledWriter(program, shape, rolling).text();
}

}  // namespace mbgen
