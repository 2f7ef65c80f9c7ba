#include "compiler/emit/value_texts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "compiler/emit/mapped.hpp"
#include "compiler/emit/names.hpp"
#include "compiler/emit/text.hpp"
#include "compiler/program/kinds.hpp"

namespace mbgen {
namespace {

/// Names before they are made unique, for the function of an ArrayCall; no declaration.
CallNames names_of_call(ArrayFunction function) {
  switch (function) {
    case ArrayFunction::sine_and_cosine:
      return {"mbgen::sincos", "angles", "", {"sines", "cosines"}, "", {}};
    case ArrayFunction::sine:
      return {"mbgen::sines", "angles", "", {"sines"}, "", {}};
    case ArrayFunction::cosine:
      return {"mbgen::cosines", "angles", "", {"cosines"}, "", {}};
    case ArrayFunction::bounded_sine:
      return {"mbgen::bounded_sines", "angles", "", {"sines"}, "", {}};
    case ArrayFunction::bounded_cosine:
      return {"mbgen::bounded_cosines", "angles", "", {"cosines"}, "", {}};
    case ArrayFunction::arc_tangent:
      return {"mbgen::arc_tangents", "tangents", "", {"arcs"}, "", {}};
    case ArrayFunction::exponential:
      return {"mbgen::exponentials", "exponents", "", {"exponentials"}, "", {}};
    case ArrayFunction::hyperbolic_tangent:
      return {"mbgen::hyperbolic_tangents", "arguments", "", {"hyperbolic_tangents"}, "", {}};
    case ArrayFunction::power:
      return {"mbgen::powers", "bases", "exponents", {"powers"}, "", {}};
  }
  throw std::logic_error("no such function");
}

}  // namespace

ValueTexts::ValueTexts(const Program& program, const Schedule& schedule, const ProgramShape& shape)
    : program_(program),
      schedule_(schedule),
      shape_(shape),
      widths_(widths_of(program)),
      phrases_(program.nodes.size()),
      outputs_(program.nodes.size()),
      names_(program),
      tables_(names_) {
  for (const OutputValue& output : program.outputs) outputs_[output.value].push_back(output.slot);
  reserve_names();
  if (shape.order == ValueOrder::reading) names_.name_parts(result_names());
  declare_crossing();
  name_calls();
}

// --- names given before the first line ---

void ValueTexts::reserve_names() {
  if (shape_.constants != nullptr) {
    for (const std::string& name : shape_.constants->identifiers(program_)) names_.reserve(name);
  }
  for (const Argument& argument : shape_.arguments) names_.reserve(argument.name);
  for (const LawShape& law : shape_.laws) names_.reserve(law.argument);
  for (const auto& [group, place] : shape_.inputs) {
    for (const std::string& local : place.locals) names_.reserve(local);
  }
  for (const char* name : {"result", "fma", "fms", "fnma", mbgen::name_of(Scalar::pairs)}) names_.reserve(name);
  if (schedule_.has_loops()) names_.reserve("k");
}

std::vector<std::string> ValueTexts::result_names() const {
  std::vector<std::string> names(program_.nodes.size());
  for (const OutputValue& output : program_.outputs) {
    const std::string& text = place_of(shape_.outputs, output.slot).texts[static_cast<std::size_t>(output.slot.index)];
    names[output.value] = word_of_member(text.substr(text.find('.') + 1));
  }
  return names;
}

CrossingStruct& ValueTexts::add_crossing() {
  const int number = static_cast<int>(crossing_.size()) + 1;
  return crossing_.emplace_back(CrossingStruct{names_.unique(fmt::format("w{}", number)), number});
}

void ValueTexts::declare_crossing() {
  if (schedule_.has_loops())
    add_crossing().places = {{type_text(shape_), {fmt::format("value[{}]", std::max(schedule_.stored, 1))}}};
  const auto places = static_cast<std::size_t>(schedule_.places);
  for (std::size_t first = 0; first < places; first += kPlacesTogether)
    add_crossing().places.resize(std::min(places - first, kPlacesTogether));
}

void ValueTexts::name_calls() {
  const std::vector<ArrayCall>& calls = schedule_.calls.calls;
  std::set<int> crossing_calls;
  for (const ValueId v : schedule_.order)
    if (facts(v).crosses) crossing_calls.insert(place_in_call(v).call);
  crossing_calls.erase(-1);
  if (!crossing_calls.empty()) add_crossing();
  for (std::size_t c = 0; c < calls.size(); ++c) {
    CallNames names = names_of_call(calls[c].function);
    names.arguments = names_.unique(names.arguments);
    if (!names.exponents.empty()) names.exponents = names_.unique(names.exponents);
    for (std::string& array : names.results) {
      array = names_.unique(array);
      const std::string declared = fmt::format("{}[{}]", array, calls[c].entries);
      if (crossing_calls.contains(static_cast<int>(c))) {
        CrossingStruct& home = crossing_.back();
        home.places.push_back({type_text(shape_), {declared}});
        names.work.insert(home.argument);
        array = home.argument + "." + array;
      } else {
        names.declaration += (names.declaration.empty() ? type_text(shape_) + " " : ", ") + declared;
      }
    }
    call_names_.push_back(names);
  }
}

// --- places in memory ---

std::string ValueTexts::crossing_place(ValueId v, const std::string& name, PartText& part) {
  const auto place = static_cast<std::size_t>(facts(v).place);
  CrossingStruct& home = crossing_[place / kPlacesTogether];
  home.places[place % kPlacesTogether].type = type_of(v);
  home.places[place % kPlacesTogether].names.push_back(name);
  part.arguments.insert(work_of_[v] = home.argument);
  return home.argument + "." + name;
}

std::string ValueTexts::stored_place(const Slices& values, PartText& part) {
  part.arguments.insert(crossing_[0].argument);
  const auto index = [&](ValueId v) { return schedule_.index_of(v); };
  return crossing_[0].argument + ".value[" + tables_.index(mapped(values, index)) + "]";
}

const GroupPlace& ValueTexts::place_of(const Places& places, const Slot& slot) const {
  const auto place = places.find(slot.group);
  if (place == places.end() || slot.index < 0 || slot.index >= static_cast<int>(place->second.texts.size()))
    throw std::logic_error(program_.name + ": no place for " + text_of(slot));
  const std::string& name = place->second.argument;
  const bool is_given = name == "result" || std::ranges::count(shape_.laws, name, &LawShape::argument) > 0 ||
                        std::ranges::count(shape_.arguments, name, &Argument::name) > 0;
  if (!is_given) throw std::logic_error(program_.name + ": no argument for " + text_of(slot));
  return place->second;
}

std::string ValueTexts::slots_text(const Places& places, const std::vector<Slot>& slots, PartText& part) {
  const GroupPlace& place = place_of(places, slots[0]);
  part.arguments.insert(place.argument);
  if (!place.element.empty()) part.arguments.insert(place.element);
  if (std::ranges::all_of(slots, [&](const Slot& slot) { return slot == slots[0]; }))
    return place.texts[slots[0].index];
  const auto index = [&](const Slot& slot) { return place.first + slot.index; };
  return place.array + "[" + tables_.index(mapped(slots, index)) + "]" + place.member;
}

// --- expressions ---

Phrase ValueTexts::input_phrase(const Slices& values, PartText& part) {
  const auto slot_of = [&](ValueId v) { return program_.inputs[program_.nodes[v].input]; };
  const std::vector<Slot> slots = mapped(values, slot_of);
  const GroupPlace& place = place_of(shape_.inputs, slots[0]);
  const std::string text = slots_text(shape_.inputs, slots, part);
  const std::string local = place.locals.empty() ? "" : place.locals[slots[0].index];
  const bool is_copied = place.local_tells_more || uses_in_part_[values[0]] > 1;
  if (values.size() > 1 || local.empty() || !is_copied) return {text, Binding::primary};
  return copied(values[0], local, text, part);
}

Phrase ValueTexts::copied(ValueId v, const std::string& local, const std::string& place, PartText& part) {
  if (copied_in_part_.insert(v).second) add_line(part, "const " + type_of(v) + " " + local + " = " + place + ";");
  return {local, Binding::primary};
}

Phrase ValueTexts::result_phrase(ValueId v, PartText& part) {
  const CallNames& names = call_names_[place_in_call(v).call];
  part.arguments.insert(names.work.begin(), names.work.end());
  const std::string& array = program_.nodes[v].op == Op::cos ? names.results.back() : names.results.front();
  const int first = place_in_call(v).argument;
  const std::string place =
      widths_[v] == 2 ? fmt::format("mbgen::pair_at({} + {})", array, first) : fmt::format("{}[{}]", array, first);
  if (uses_in_part_[v] < 2) return {place, Binding::primary};
  std::string& local = local_of_[v];
  if (local.empty()) local = names_.of_value(v);
  return copied(v, local, place, part);
}

Phrase ValueTexts::constants_phrase(const Slices& values) {
  const Node& first = program_.nodes[values[0]];
  const auto text_of = [&](ValueId v) { return number_text(program_.nodes[v].constant, shape_.scalar); };
  const auto is_first = [&](ValueId v) {
    return program_.nodes[v].constant == first.constant && program_.nodes[v].label == first.label;
  };
  if (std::ranges::all_of(values, is_first)) return constant_phrase(constant_text(program_, first, shape_));
  return {tables_.item(type_text(shape_), "kConstants", mapped(values, text_of)), Binding::primary};
}

Phrase ValueTexts::phrase_of(const ScheduledUnit& unit, const Slices& values, PartText& part) {
  const ValueId v = values[0];
  const Node& node = program_.nodes[v];
  if (node.op == Op::constant) return constants_phrase(values);
  if (node.op == Op::input) return input_phrase(values, part);
  if (is_constant_pair(program_, node))
    return operation_phrase(scalar_of(v), node.op, constants_phrase({node.operands[0]}),
                            constants_phrase({node.operands[1]}), {});
  if (place_in_call(v).call >= 0) return result_phrase(v, part);
  if (schedule_.has_loops() && !schedule_.is_local(unit, values)) return {stored_place(values, part), Binding::primary};
  if (const auto work = work_of_.find(v); work != work_of_.end()) part.arguments.insert(work->second);
  return phrases_[v];
}

Phrase ValueTexts::compose(const ScheduledUnit& unit, ValueId v, PartText& part) {
  const Node& node = program_.nodes[v];
  Phrase operands[3];
  for (int k = 0; k < arity(node.op); ++k)
    operands[k] = phrase_of(unit, schedule_.operands_of(unit, facts(v).offset, k), part);
  if (shape_.order == ValueOrder::reading)
    return phrase_for_people(scalar_of(v), node.op, operands[0], operands[1], operands[2]);
  return operation_phrase(scalar_of(v), node.op, operands[0], operands[1], operands[2]);
}

std::string ValueTexts::number(const std::string& text) const {
  return (!is_number(shape_.scalar) ? type_text(shape_) + "{} + " : "") + text;
}

std::string ValueTexts::name_of(ValueId v) {
  const ScheduledUnit& unit = schedule_.units[facts(v).unit];
  const Node& first = program_.nodes[v];
  const Node& last = program_.nodes[schedule_.order[unit.last() - unit.period + facts(v).offset]];
  if (first.mirrored_label >= 0)
    return names_.identifier(label_of_both(program_.labels[first.label], program_.labels[first.mirrored_label]));
  if (!unit.is_loop() || first.label < 0 || last.label < 0) return names_.of_value(v);
  return names_.identifier(common_label(program_.labels[first.label], program_.labels[last.label]));
}

std::vector<std::string> ValueTexts::output_texts(ValueId v, PartText& part) {
  std::vector<std::string> texts;
  const Slices values = slices_of(v);
  for (std::size_t n = 0; n < outputs_[v].size(); ++n) {
    const auto slot_of = [&](ValueId value) { return outputs_[value][n]; };
    texts.push_back(slots_text(shape_.outputs, mapped(values, slot_of), part));
  }
  return texts;
}

void ValueTexts::start_part(const PlaceRange& range) {
  tables_.start_part();
  uses_in_part_.clear();
  copied_in_part_.clear();
  for (std::size_t i = range.first; i < range.last; ++i) {
    const ValueId v = schedule_.order[i];
    if (place_in_call(v).call >= 0 || schedule_.units[facts(v).unit].is_loop()) continue;
    for (int k = 0; k < arity(program_.nodes[v].op); ++k) ++uses_in_part_[facts(v).operands[k]];
  }
}

ValueTexts::Slices ValueTexts::slices_of(ValueId v) const {
  const ScheduledUnit& unit = schedule_.units[facts(v).unit];
  Slices values;
  for (std::size_t slice = 0; slice < unit.count; ++slice)
    values.push_back(schedule_.order[unit.first + slice * unit.period + facts(v).offset]);
  return values;
}

}  // namespace mbgen
