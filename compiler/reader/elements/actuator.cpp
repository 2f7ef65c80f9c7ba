// Actuators: their inputs, and where they act.
#include "compiler/reader/elements/actuator.hpp"

#include <fmt/format.h>

#include <array>

#include "compiler/expressions/named_functions.hpp"
#include "compiler/reader/elements/sections.hpp"
#include "compiler/reader/output_sources.hpp"
#include "compiler/reader/raw.hpp"

namespace mbgen::reading {

/// An actuator on a coordinate, on the length of a rod, along a spring, between two points or in place of a motion.
struct ActuatorFields : Actuator {
  std::optional<std::string> rod, spring, motion;
  std::optional<Quantity> rotor_inertia;  ///< a body of its own, see compose_rotors
  std::optional<Attachment> first, last;
};

template <>
std::span<const Field<ActuatorFields>> fields<ActuatorFields>() {
  using S = ActuatorFields;
  static const std::array table = {
      field<S, &S::joint>(element_coordinate("joint", "coordinate it acts on", Need::optional)),
      field<S, &S::relative_to>(element_coordinate(
          "relative_to", "coordinate that the opposite force acts on: a motor between two shafts", Need::optional)),
      field<S, &S::rod>({.name = "rod",
                         .shape = Shape::reference,
                         .doc = "rod without mass whose length it moves, the coordinate NAME_length; a positive force "
                                "pushes its ends apart",
                         .of = "rods"}),
      field<S, &S::spring>({.name = "spring",
                            .shape = Shape::reference,
                            .doc = "spring beside which it acts, between the same points",
                            .of = "springs"}),
      field<S, &S::first>({.name = "from",
                           .shape = Shape::attachment,
                           .doc = "one end of a cylinder; a positive force pushes its ends apart"}),
      field<S, &S::last>({.name = "to", .shape = Shape::attachment, .doc = "other end, on another body"}),
      field<S, &S::motion>({.name = "motion",
                            .shape = Shape::reference,
                            .doc =
                                "motion that it gives: it acts on the coordinate of the motion, and inverse dynamics "
                                "finds its force in place of the driving force",
                            .of = "motions"}),
      field<S, &S::gear>({.name = "gear",
                          .doc = "speed of the motor over the rate of the coordinate, or of the length; the motor's "
                                 "force times it acts there",
                          .unit = "1, rad/m or m/rad",
                          .fallback = 1,
                          .depends = Depends::parameters}),
      field<S, &S::weight>({.name = "weight",
                            .shape = Shape::number,
                            .doc = "of its squared force in the sum that inverse dynamics makes least where more "
                                   "actuators than directions move",
                            .unit = "1",
                            .fallback = 1,
                            .bound = Bound::positive,
                            .depends = Depends::nothing}),
      field<S, &S::limit>({.name = "limit",
                           .shape = Shape::number,
                           .doc = "of the motor's force, in both directions: forces of inverse dynamics beyond it are "
                                  "told, not clipped",
                           .unit = "N or N m",
                           .bound = Bound::positive,
                           .depends = Depends::nothing}),
      field<S, &S::rotor_inertia>({.name = "rotor_inertia",
                                   .doc = "inertia of the motor's rotor about its axis: a body NAME_rotor that turns "
                                          "`gear` times as fast as the coordinate and acts on it alone",
                                   .unit = "kg m^2, kg for a gear without unit on a length",
                                   .bound = Bound::positive,
                                   .depends = Depends::parameters}),
  };
  return table;
}

namespace {

constexpr std::array<std::string_view, 5> kActuatorPlaces = {"joint", "rod", "spring", "from", "motion"};

/// Reports an actuator without exactly one place, and fields of another one. Result: its place, "" for none.
std::string_view actuator_place(Reader& reader, const Value& value) {
  std::string_view place;
  for (const std::string_view key : kActuatorPlaces) {
    const Value* member = find(value, key);
    if (!member) continue;
    if (!place.empty()) {
      report(reader, *member, fmt::format("actuator has both \"{}\" and \"{}\"", place, key), "leave out one of them");
      return "";
    }
    place = key;
  }
  if (place.empty())
    report(reader, value, "key \"joint\" is missing",
           "or \"rod\", \"spring\", \"motion\", or \"from\" and \"to\": where the actuator acts");
  const auto belongs = [&](std::string_view key, std::string_view to) {
    const Value* member = find(value, key);
    if (member && !place.empty() && place != to)
      report(reader, *member, fmt::format("{} is of an actuator with \"{}\"", in_quotes(std::string(key)), to),
             "leave it out");
  };
  belongs("relative_to", "joint");
  belongs("to", "from");
  if (place == "from" && !find(value, "to")) report(reader, value, "key \"to\" is missing");
  return place;
}

/// The slide of an actuated rod; without a joint where the rod could not be read.
void act_on_rod(Reader& reader, const Value& value, Actuator& actuator) {
  const int rod = find_element(reader, value, "rod", reader.names.rods);
  actuator.joint = CoordinateReference{};
  if (rod >= 0) actuator.joint->joint = reader.model.rods[static_cast<std::size_t>(rod)].drive;
  const auto is_same = [&](const Actuator& other) { return other.joint && *other.joint == *actuator.joint; };
  if (actuator.joint->joint >= 0 && std::any_of(reader.model.actuators.begin(), reader.model.actuators.end(), is_same))
    report(reader, *find(value, "rod"), fmt::format("rod {} has another actuator", in_quotes(find(value, "rod")->text)),
           fmt::format("let this one act on \"joint\": its length, {}_length", find(value, "rod")->text));
}

void act_along_spring(Reader& reader, const Value& value, Actuator& actuator) {
  const int spring = find_element(reader, value, "spring", names_of<PointSpring>(reader));
  if (spring < 0) return;
  actuator.from = reader.model.springs[static_cast<std::size_t>(spring)].from;
  actuator.to = reader.model.springs[static_cast<std::size_t>(spring)].to;
}

void set_unit_of_input(Model& model, const Actuator& actuator) {
  const bool turns = actuator.joint && actuator.joint->joint >= 0 && is_rotation(model, *actuator.joint);
  model.inputs[static_cast<std::size_t>(actuator.input)].unit = turns ? "N m" : "N";
}

/// Marks the motion that actuators give, by their names.
void read_actuated_by(Reader& reader, const Value& list, Motion& motion) {
  if (list.kind != Value::Kind::array || list.items.empty())
    return report(reader, list, "must be an array of names of actuators, got " + describe(list));
  for (const Value& item : list.items) {
    if (item.kind != Value::Kind::text) report(reader, item, "must be the name of an actuator, got " + describe(item));
    motion.is_actuated = find_named(reader, item, "actuator", names_of<Actuator>(reader)) >= 0 || motion.is_actuated;
  }
}

/// Notes an actuator on a coordinate whose motion bears its force.
void note_driven(Reader& reader, const Actuator& actuator) {
  for (const Motion& motion : reader.model.motions)
    if (actuator.joint && actuator.joint->joint >= 0 && motion.joint == *actuator.joint && !motion.is_actuated)
      note_at(reader, actuator.where,
              fmt::format("actuator {} acts on a coordinate that motion {} drives: the motion bears its force",
                          in_quotes(actuator.name), in_quotes(motion.name)),
              fmt::format("\"motion\": {} in place of \"joint\": inverse dynamics finds its force",
                          in_quotes(motion.name)));
}

void read_actuators(Reader& reader, const Entries& entries) {
  for (const Entry& entry : entries)
    names_of<Actuator>(reader).emplace(entry.name, static_cast<int>(names_of<Actuator>(reader).size()));
  for (const Entry& entry : entries) {
    std::vector<ActuatorFields> one;
    read_list(reader, {entry}, one, [](Reader& r, const Value& value, ActuatorFields& actuator) {
      const std::string_view place = actuator_place(r, value);
      if (place == "joint") {
        refuse_reversed(r, member_or_object(value, "joint").place, *actuator.joint);
        if (actuator.relative_to) check_coordinate_pair(r, value, "actuator", *actuator.joint, *actuator.relative_to);
      }
      if (place == "motion") actuator.joint = CoordinateReference{};  // see act_on_motions
      if (place == "rod") act_on_rod(r, value, actuator);
      if (place == "spring") act_along_spring(r, value, actuator);
      if (place == "from" && actuator.first && actuator.last) {
        actuator.from = *actuator.first;
        actuator.to = *actuator.last;
        check_ends(r, value, actuator.from, actuator.to);
      }
      if (actuator.gear.expression < 0 && actuator.gear.value == 0)
        report(r, *find(value, "gear"), "a gear of 0 moves nothing");
    });
    Actuator& actuator = one.front();
    actuator.input = reader.names.inputs.at(entry.name);
    set_unit_of_input(reader.model, actuator);
    reader.model.actuators.push_back(std::move(actuator));
  }
}

}  // namespace

void add_actuator_inputs(Reader& reader, const Entries& actuators) {
  for (const Entry& entry : actuators) {
    Input input;
    input.name = entry.name;
    input.where = where_of(reader.documents, entry.place);
    input.shown.description = "force of actuator " + entry.name;
    const int index = static_cast<int>(reader.model.inputs.size());
    const bool is_new = reader.names.inputs.emplace(input.name, index).second;
    if (!is_new || reader.names.parameters.contains(input.name))
      report(reader, entry.place,
             fmt::format("the force of actuator {} is an input of its name, and {} has this name",
                         in_quotes(entry.name), is_new ? "a parameter" : "an input"),
             "rename one of them");
    if (is_reserved_name(entry.name))
      report(reader, entry.place, "name " + in_quotes(entry.written) + " is reserved, expressions use it");
    if (is_new) reader.model.inputs.push_back(std::move(input));
  }
}

void act_on_motions(Reader& reader, const Entries& actuators, const Entries& motions) {
  Model& model = reader.model;
  for (const Entry& entry : motions) {
    const InScope in_scope(reader, entry.scope);
    const auto motion = reader.names.motions.find(entry.name);
    const Value* list = entry.value->kind == Value::Kind::object ? find(*entry.value, "actuated_by") : nullptr;
    if (list && motion != reader.names.motions.end())
      read_actuated_by(reader, *list, model.motions[static_cast<std::size_t>(motion->second)]);
  }
  for (std::size_t i = 0; i < actuators.size(); ++i) {
    const Entry& entry = actuators[i];
    const InScope in_scope(reader, entry.scope);
    if (entry.value->kind != Value::Kind::object || !find(*entry.value, "motion")) continue;
    const int motion = find_element(reader, *entry.value, "motion", reader.names.motions);
    if (motion < 0 || i >= model.actuators.size() || !model.actuators[i].joint) continue;
    model.actuators[i].joint = model.motions[static_cast<std::size_t>(motion)].joint;
    model.motions[static_cast<std::size_t>(motion)].is_actuated = true;
    set_unit_of_input(model, model.actuators[i]);
  }
  for (const Actuator& actuator : model.actuators) note_driven(reader, actuator);
}

std::set<int> actuated_rods(const Reader& reader, const Entries& actuators) {
  std::set<int> rods;
  for (const Entry& entry : actuators) {
    const Value* rod = entry.value->kind == Value::Kind::object ? find(*entry.value, "rod") : nullptr;
    if (!rod || rod->kind != Value::Kind::text) continue;
    const auto found = find_visible(reader.names.rods, rod->text, reader.scopes[entry.scope].visible);
    if (found != reader.names.rods.end()) rods.insert(found->second);
  }
  return rods;
}

ElementSection section_of(Leader<Actuator>) {
  return {
      "motors on coordinates, and cylinders: forces by inputs, which inverse dynamics finds",
      [] {
        return std::vector<ObjectKind>{kind_of<ActuatorFields>(
            "actuator",
            "a motor or cylinder; its force is an input of its name; exactly one of joint, rod, spring, from and "
            "motion",
            {"joint", "rod", "spring", "from", "motion"}, {{"from", "to"}, {"to", "from"}, {"relative_to", "joint"}})};
      },
      read_actuators};
}

}  // namespace mbgen::reading
