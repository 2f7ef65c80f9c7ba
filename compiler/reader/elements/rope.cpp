// Ropes and belts: tables of their fields, their law.
#include "compiler/reader/elements/rope.hpp"

#include <fmt/format.h>

#include <array>

#include "compiler/reader/elements/sections.hpp"
#include "compiler/reader/presentation.hpp"

namespace mbgen::reading {
namespace {

constexpr std::array<std::string_view, 2> kSenses = {"positive", "negative"};
constexpr std::array<std::string_view, 2> kContacts = {"slides", "grips"};

FieldInfo station_place(std::string_view name, std::string_view doc) {
  return {.name = name, .shape = Shape::attachment, .doc = doc};
}

/// Fields of the place.
auto station_place_fields() {
  using S = RopeStationFields;
  return std::array{
      field<S, &S::point>(station_place("point", "an end, or between the ends an eyelet without friction")),
      field<S, &S::pulley>(station_place("pulley", "centre of a pulley that the rope goes round")),
      field<S, &S::drum>(station_place("drum", "centre of a drum that this end of the rope is wound on")),
      field<S, &S::cylinder>(station_place(
          "cylinder", "point on the axis of a cylinder without friction that the rope may touch, between points")),
      field<S, &S::sphere>(
          station_place("sphere", "centre of a sphere without friction that the rope may touch, between points")),
  };
}

/// Fields of the circle.
auto station_circle_fields() {
  using S = RopeStationFields;
  return std::array{
      field<S, &S::written_axis>({.name = "axis",
                                  .shape = Shape::axis,
                                  .doc = "axis of a pulley, drum or cylinder, in the frame of its body",
                                  .by_points = true}),
      field<S, &S::written_radius>(
          {.name = "radius", .doc = "to the middle of the rope", .unit = "m", .bound = Bound::positive}),
      field<S, &S::written_sense>({.name = "sense",
                                   .shape = Shape::word,
                                   .doc = "in which the rope, followed along its path, runs round the axis",
                                   .words = kSenses}),
      field<S, &S::turns>({.name = "turns",
                           .shape = Shape::number,
                           .doc = "whole turns on a pulley beside its angle of wrap",
                           .unit = "1",
                           .bound = Bound::not_negative,
                           .depends = Depends::nothing}),
      field<S, &S::written_contact>({.name = "contact",
                                     .shape = Shape::word,
                                     .doc = "how the rope passes a pulley: slides without friction (default), or grips "
                                            "without slip",
                                     .words = kContacts}),
      field<S, &S::written_friction>({.name = "friction",
                                      .doc = "coefficient of friction in the groove of a pulley, in place of contact",
                                      .unit = "1",
                                      .bound = Bound::not_negative}),
      field<S, &S::joint>({.name = "joint",
                           .shape = Shape::coordinate,
                           .doc = "rotation of the pulley or drum about its axis; default: of the joint about this "
                                  "axis that its body is in"}),
  };
}

/// Reports a missing or double stiffness and length.
void check_rope_law(Reader& reader, const Value& value, const RopeFields& rope) {
  if (!find(value, "EA") && !find(value, "stiffness"))
    report(reader, value, "rope has no stiffness",
           "give it \"EA\" in N, its stiffness times its length, or \"stiffness\" in N/m");
  for (const auto& [key, other] : {std::pair{"stiffness", "EA"}, std::pair{"pretension", "free_length"}})
    if (const Member* member = find_member(value, key); member && find(value, other))
      report(reader, member->place, fmt::format("rope has both \"{}\" and \"{}\"", other, key),
             "leave out one of them");
  if (const Member* lag = find_member(value, "lag"); lag && rubbing_grooves(rope) == 0 && !rope.path.empty())
    report(reader, lag->place, "\"lag\" is of a rope with friction in a groove", "leave it out");
}

/// Reports a free length that changes with several tensions, or by inputs without rates.
void check_free_length(Reader& reader, const Value& value, const Rope& rope) {
  using Kind = ExpressionNode::Kind;
  if (!rope.free_length || !mentions(reader.model, rope.free_length->expression, {Kind::time, Kind::input})) return;
  const Value& written = *find(value, "free_length");
  if (rope.spans > 1)
    report(reader, written, "the free length of a rope with several tensions is constant",
           "let a drum take its end, or its pulleys slide");
  const auto& nodes = reader.model.expressions[static_cast<std::size_t>(rope.free_length->expression)].nodes;
  for (const ExpressionNode& node : nodes) {
    if (node.kind != Kind::input || reader.model.inputs[static_cast<std::size_t>(node.index)].derivative >= 0) continue;
    report(reader, written,
           fmt::format("the rate of the free length is unknown: input {} names no \"derivative\"",
                       in_quotes(reader.model.inputs[static_cast<std::size_t>(node.index)].name)),
           "give the input \"derivative\": another input, the rate");
    return;
  }
}

void read_ropes(Reader& reader, const Entries& entries) {
  NameMap<int>& names = names_of<Rope>(reader);
  std::vector<Rope>& ropes = reader.model.ropes;
  for (const Entry& entry : entries) {
    std::vector<RopeFields> one;
    read_list(reader, {entry}, one, [](Reader&, const Value&, const RopeFields&) {});
    RopeFields& rope = one.front();
    const InScope in_scope(reader, entry.scope);
    if (entry.value->kind == Value::Kind::object) {
      if (!read_path(reader, rope)) rope.path.clear();
      check_rope_law(reader, *entry.value, rope);
      check_free_length(reader, *entry.value, rope);
    }
    names.emplace(rope.spans > 1 ? entry.name + "_1" : entry.name, static_cast<int>(ropes.size()));
    Rope span = rope;
    if (rope.spans > 1) span.name = entry.name + "_1";
    ropes.push_back(span);
    for (span.path.clear(); ++span.span < rope.spans;) {
      span.name = fmt::format("{}_{}", entry.name, span.span + 1);
      names.emplace(span.name, static_cast<int>(ropes.size()));
      ropes.push_back(span);
    }
  }
}

/// The potential energy of every rope is known.
std::string trouble_of_rope(const Model&, std::size_t) { return ""; }

}  // namespace

template <>
std::span<const Field<RopeStationFields>> fields<RopeStationFields>() {
  static const std::array table = joined(station_place_fields(), station_circle_fields());
  return table;
}

template <>
std::span<const Field<RopeFields>> fields<RopeFields>() {
  using S = RopeFields;
  static const std::array table = {
      field<S, &S::written_path>({.name = "path",
                                  .shape = Shape::rotations,
                                  .doc = "list of the stations of the rope, in its order",
                                  .need = Need::required,
                                  .of = "rope_station"}),
      field<S, &S::closed>({.name = "closed",
                            .shape = Shape::boolean,
                            .doc = "a belt or chain, whose last station is followed by the first; default false"}),
      field<S, &S::ea>(
          {.name = "EA", .doc = "stiffness times free length, of each span", .unit = "N", .bound = Bound::positive}),
      field<S, &S::stiffness>(
          {.name = "stiffness", .doc = "of each span, in place of EA", .unit = "N/m", .bound = Bound::positive}),
      field<S, &S::damping>({.name = "damping",
                             .doc = "damping over stiffness: a vibration of circular frequency w has the damping ratio "
                                    "w damping / 2; at most the elastic tension is added or taken",
                             .unit = "s",
                             .fallback = 0,
                             .bound = Bound::not_negative}),
      field<S, &S::free_length>(
          {.name = "free_length",
           .doc = "length without tension at the reference, without its parts on drums, with its parts on "
                  "pulleys; default: no tension there",
           .unit = "m",
           .bound = Bound::positive,
           .depends = Depends::motion}),
      field<S, &S::pretension>({.name = "pretension",
                                .doc = "tension at the reference, in place of free_length",
                                .unit = "N",
                                .bound = Bound::not_negative,
                                .depends = Depends::parameters}),
      field<S, &S::lag>({.name = "lag",
                         .shape = Shape::number,
                         .doc = "time in which a rope in a groove with friction comes to its limit; default: "
                                "the step of solver",
                         .unit = "s",
                         .bound = Bound::positive}),
  };
  return table;
}

ElementSection section_of(Leader<Rope>) {
  return {
      "ropes, belts and chains over pulleys",
      [] {
        return std::vector<ObjectKind>{
            kind_of<RopeFields>("rope",
                                "an elastic rope without mass through points and over pulleys, or a belt; it "
                                "never pushes; exactly one of EA and stiffness",
                                {"EA", "stiffness"}),
            kind_of<RopeStationFields>(
                "rope_station", "a place that a rope passes; exactly one of point, pulley, drum, cylinder and sphere",
                {"point", "pulley", "drum", "cylinder", "sphere"})};
      },
      read_ropes, trouble_of_rope};
}

}  // namespace mbgen::reading
