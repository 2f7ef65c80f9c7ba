// Bump stops and their attachments.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "compiler/expressions/curve.hpp"
#include "compiler/reader/elements/sections.hpp"
#include "compiler/reader/positions.hpp"
#include "compiler/reader/presentation.hpp"
#include "compiler/reader/raw.hpp"
#include "compiler/reader/reader.hpp"

namespace mbgen::reading {

/// A bump stop as written, before its attachment is resolved.
struct BumpStopFields : BumpStop {
  std::optional<Attachment> written_from, written_to;
  std::optional<std::string> spring;
  std::optional<CoordinateReference> written_joint;
  std::optional<Vector3> written_axis;
  std::optional<Side> written_side;
};

template <>
std::span<const Field<BumpStopFields>> fields<BumpStopFields>();
namespace {

constexpr std::array<std::string_view, 2> kStopLocals = {"penetration", "rate"};
/// In the order of BumpStop::Side.
constexpr std::array<std::string_view, 4> kSides = {"compression", "extension", "above", "below"};

/// Fields of the attachment.
auto stop_place_fields() {
  using S = BumpStopFields;
  return std::array{
      field<S, &S::written_from>({.name = "from", .shape = Shape::attachment, .doc = "one end"}),
      field<S, &S::written_to>({.name = "to", .shape = Shape::attachment, .doc = "other end, on another body"}),
      field<S, &S::spring>({.name = "spring",
                            .shape = Shape::reference,
                            .doc = "spring or air spring with the same ends",
                            .of = "springs"}),
      field<S, &S::written_joint>({.name = "joint",
                                   .shape = Shape::coordinate,
                                   .doc = "coordinate that the stop is on; zero at the reference"}),
      field<S, &S::relative_to>({.name = "relative_to",
                                 .shape = Shape::coordinate,
                                 .doc = "coordinate that is subtracted, and that the opposite force acts on: backlash "
                                        "between two shafts"}),
      field<S, &S::written_axis>({.name = "axis",
                                  .shape = Shape::axis,
                                  .doc = "direction of the displacement of `to`, in the frame of `from`; default: "
                                         "along the line between the points",
                                  .by_points = true}),
      field<S, &S::written_side>({.name = "side",
                                  .shape = Shape::word,
                                  .doc = "between points compression (default) or extension, with `axis` the "
                                         "displacement against it or along it; of a coordinate above or below",
                                  .words = kSides}),
  };
}

/// Fields of the law.
auto stop_law_fields() {
  using S = BumpStopFields;
  return std::array{
      field<S, &S::clearance>(
          {.name = "clearance",
           .doc = "displacement from the reference configuration to the contact; negative: in contact there",
           .unit = "m or rad",
           .need = Need::required,
           .angle = true}),
      field<S, &S::stiffness>({.name = "stiffness",
                               .shape = Shape::law,
                               .doc =
                                   "factor of the penetration to the power of `exponent`, or a table of N or N m over "
                                   "the penetration (m or rad)",
                               .unit = "N/m^exponent or N m/rad^exponent",
                               .bound = Bound::not_negative}),
      field<S, &S::exponent>({.name = "exponent",
                              .shape = Shape::number,
                              .doc = "power of the penetration, at least 1",
                              .fallback = 1,
                              .depends = Depends::nothing}),
      field<S, &S::damping>({.name = "damping",
                             .doc = "relative increase of the force over the rate of penetration, in contact only",
                             .unit = "s/m or s/rad",
                             .fallback = 0,
                             .bound = Bound::not_negative}),
      field<S, &S::force>({.name = "force",
                           .shape = Shape::force,
                           .doc = "force added in contact, over `penetration` (m or rad) and `rate`",
                           .unit = "N or N m",
                           .locals = kStopLocals}),
  };
}

}  // namespace

template <>
std::span<const Field<BumpStopFields>> fields<BumpStopFields>() {
  static const std::array table = joined(stop_place_fields(), stop_law_fields());
  return table;
}
namespace {

/// Takes over the ends of the element with a length of that name.
void take_ends_of_spring(Reader& reader, const Value& value, BumpStopFields& stop) {
  const Visibility& visible = current_scope(reader).visible;
  NameMap<int> known;
  bool is_found = false;
  each_kind([&]<class Kind>(KindOf<Kind> kind) {
    if constexpr (kind.has_length) {
      const NameMap<int>& names = names_of<Kind>(reader);
      known.insert(names.begin(), names.end());
      const auto place = find_visible(names, *stop.spring, visible);
      if (is_found || place == names.end()) return;
      is_found = true;
      const Kind& spring = kind.list(reader.model)[static_cast<std::size_t>(place->second)];
      stop.from = spring.from, stop.to = spring.to;
    }
  });
  if (!is_found)
    report(reader, *find(value, "spring"), "unknown spring " + in_quotes(*stop.spring),
           suggestion(reader, *stop.spring, known));
}

/// Reports a stop with no attachment or with several.
bool has_one_place(Reader& reader, const Value& value) {
  const bool points = find(value, "from") || find(value, "to");
  const Member *spring = find_member(value, "spring"), *joint = find_member(value, "joint");
  constexpr const char* kHint = "give it from and to, or spring, or joint";
  if (!points && !spring && !joint) {
    report(reader, value, "bump stop has no place", kHint);
    return false;
  }
  if (points + (spring != nullptr) + (joint != nullptr) > 1) {
    report(reader, (joint ? joint : spring)->place, "bump stop has several places", kHint);
    return false;
  }
  if (!points) return true;
  for (const char* key : {"from", "to"})
    if (!find(value, key)) report(reader, value, fmt::format("bump stop needs \"{}\" too", key));
  return find(value, "from") && find(value, "to");
}

void place_stop(Reader& reader, const Value& value, BumpStopFields& stop) {
  if (!has_one_place(reader, value)) return;
  const bool on_joint = find(value, "joint") != nullptr;
  using Side = BumpStop::Side;
  if (on_joint) {
    stop.joint = stop.written_joint.value_or(CoordinateReference{});
    refuse_reversed(reader, find(value, "joint")->place, stop.joint);
    stop.side = stop.written_side.value_or(Side::above);
    if (!find(value, "side") || (stop.written_side && !stop.is_on_joint()))
      report(reader, member_or_object(value, "side"), "a stop on a coordinate needs the side \"above\" or \"below\"",
             "above: where the coordinate is larger than at the reference");
    stop.side = stop.is_on_joint() ? stop.side : Side::above;
    if (stop.relative_to) check_coordinate_pair(reader, value, "bump stop", stop.joint, *stop.relative_to);
    if (const Member* axis = find_member(value, "axis"))
      report(reader, axis->place, "a stop on a coordinate has no axis", "the coordinate has one");
    return;
  }
  if (const Member* other = find_member(value, "relative_to"))
    report(reader, other->place, "\"relative_to\" is of a stop on a coordinate", "leave it out, or give \"joint\"");
  stop.side = stop.written_side.value_or(Side::compression);
  if (stop.is_on_joint()) {
    report(reader, *find(value, "side"), "a stop between points has the side \"compression\" or \"extension\"");
    stop.side = Side::compression;
  }
  if (find(value, "spring")) {
    if (stop.spring) take_ends_of_spring(reader, value, stop);
  } else {
    stop.from = stop.written_from.value_or(Attachment{});
    stop.to = stop.written_to.value_or(Attachment{});
    if (check_ends(reader, value, stop.from, stop.to) == 0 && !stop.written_axis)
      report(reader, *find(value, "to"), "a bump stop between points at one place needs an axis",
             "the line between them has no direction at the reference");
  }
  if (stop.from.body < 0 || !stop.written_axis || std::isnan((*stop.written_axis)[0])) return;
  turn_axis_by_points(reader, find(value, "axis"), stop.from.body, *stop.written_axis);
  stop.axis = placed_direction(reader, stop.from.body, *stop.written_axis);
}

void read_bump_stops(Reader& reader, const Entries& entries) {
  for (const Entry& entry : entries)
    names_of<BumpStop>(reader).emplace(entry.name, static_cast<int>(names_of<BumpStop>(reader).size()));
  for (const Entry& entry : entries) {
    std::vector<BumpStopFields> one;
    read_list(reader, {entry}, one, [](Reader&, const Value&, const BumpStopFields&) {});
    BumpStopFields& stop = one.front();
    const InScope in_scope(reader, entry.scope);
    const Value& value = *entry.value;
    if (value.kind == Value::Kind::object) {
      place_stop(reader, value, stop);
      if (!find(value, "stiffness") && !find(value, "force"))
        report(reader, value, "bump stop has neither \"stiffness\" nor \"force\"");
      const Value* clearance = find(value, "clearance");
      const bool is_length = !stop.is_on_joint() || (stop.joint.joint >= 0 && !is_rotation(reader.model, stop.joint));
      if (clearance && clearance->kind == Value::Kind::object && is_length)
        report(reader, *clearance, "clearance is a length, degrees have no meaning");
      if (stop.exponent < 1)
        report(reader, *find(value, "exponent"), fmt::format("must be at least 1, got {}", stop.exponent),
               "a smaller power has a stiffness without bound at the contact");
      if (const Member* exponent = find_member(value, "exponent");
          exponent && stop.stiffness && std::holds_alternative<Table>(*stop.stiffness))
        report(reader, exponent->place, "a table of stiffness takes no exponent");
    }
    reader.model.bump_stops.push_back(stop);
  }
}

/// Whether the curve is negative anywhere from zero on: sampled at sixteen places between two points.
bool falls_below_zero(const Table& table) {
  constexpr int kPlaces = 16;
  bool falls = value_along(table, 0.0) < 0;
  const auto look_at = [&](double x) { falls = falls || (x > 0 && value_along(table, x) < 0); };
  for (std::size_t i = 0; i + 1 < table.x.size(); ++i)
    for (int k = 0; k <= kPlaces; ++k) look_at(table.x[i] + k * (table.x[i + 1] - table.x[i]) / kPlaces);
  // One sample at twice the range: the linear extrapolation may fall.
  look_at(2 * std::max(table.x.back(), width_of(table)));
  return falls;
}

std::string trouble_of_bump_stop(const Model& model, std::size_t index) {
  const BumpStop& stop = model.bump_stops[index];
  if (stop.force || !stop.stiffness) return kByExpression;
  const Table* table = std::get_if<Table>(&*stop.stiffness);
  if (table && falls_below_zero(*table))
    return "a table that falls below zero, where it does not pull, which is not integrated";
  return look_at_motion(model, stop.stiffness, stop.clearance) ? kByMotion : "";
}

}  // namespace

ElementSection section_of(Leader<BumpStop>) {
  return {"stops beyond a clearance",
          [] {
            return std::vector<ObjectKind>{kind_of<BumpStopFields>(
                "bump_stop",
                "a stop that acts beyond its clearance, and never pulls; on the distance of two points or the "
                "displacement along an axis (from and to, or spring), or on a coordinate (joint)")};
          },
          read_bump_stops, trouble_of_bump_stop};
}

}  // namespace mbgen::reading
