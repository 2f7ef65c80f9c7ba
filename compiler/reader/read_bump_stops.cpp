// Bump stops: where they are, and on which side.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compiler/reader/positions.hpp"
#include "compiler/reader/raw.hpp"
#include "compiler/reader/reader.hpp"

namespace mbgen::reading {
namespace {

/// Takes the ends of the spring or air spring of that name.
void take_ends_of_spring(Reader& reader, const Value& value, BumpStopFields& stop) {
  const Visibility& visible = current_scope(reader).visible;
  const auto spring = find_visible(reader.names.springs, *stop.spring, visible);
  const auto air_spring = find_visible(reader.names.air_springs, *stop.spring, visible);
  const bool is_spring = spring != reader.names.springs.end();
  if (!is_spring && air_spring == reader.names.air_springs.end()) {
    NameMap<int> known = reader.names.springs;
    known.insert(reader.names.air_springs.begin(), reader.names.air_springs.end());
    report(reader, *find(value, "spring"), "unknown spring " + in_quotes(*stop.spring),
           suggestion(reader, *stop.spring, known));
    return;
  }
  const auto take = [&](const auto& of) { stop.from = of.from, stop.to = of.to; };
  if (is_spring)
    take(reader.model.springs[static_cast<std::size_t>(spring->second)]);
  else
    take(reader.model.air_springs[static_cast<std::size_t>(air_spring->second)]);
}

/// Complains where a stop is at no place or at several.
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
    if (const Member* axis = find_member(value, "axis"))
      report(reader, axis->place, "a stop on a coordinate has no axis", "the coordinate has one");
    return;
  }
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

}  // namespace

void read_bump_stops(Reader& reader, const Entries& entries) {
  for (const Entry& entry : entries)
    reader.names.bump_stops.emplace(entry.name, static_cast<int>(reader.names.bump_stops.size()));
  for (const Entry& entry : entries) {
    std::vector<BumpStopFields> one;
    read_list(reader, {entry}, one, [](Reader&, const Value&, const BumpStopFields&) {});
    BumpStopFields& stop = one.front();
    const InScope in_scope(reader, entry.scope);
    const Value& value = *entry.value;
    if (value.kind == Value::Kind::object) {
      place_stop(reader, value, stop);
      if (!find(value, "stiffness") && !find(value, "force"))
        report(reader, value, "bump stop has neither stiffness nor force");
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

}  // namespace mbgen::reading
