// Roads of a host: their inputs, and the plane given by them.
#include <fmt/format.h>

#include <algorithm>

#include "compiler/reader/raw.hpp"
#include "compiler/reader/reader.hpp"

namespace mbgen::reading {
namespace {

/// Indices of kHostInputs.
enum HostInput { kX, kY, kHeight, kSlopeX, kSlopeY, kFriction };

std::string input_name(const std::string& road, int which) {
  return fmt::format("{}_{}", road, kHostInputs[static_cast<std::size_t>(which)]);
}

/// Reads a field from this text, as if it were written in the road.
void read_field(Reader& reader, std::string_view name, Place place, std::string text, RoadFields& road) {
  Value written;
  written.kind = Value::Kind::text;
  written.text = std::move(text);
  written.place = place;
  for (const Field<RoadFields>& field : fields<RoadFields>())
    if (field.info.name == name) field.read(reader, written, field.info, road);
}

}  // namespace

void add_host_inputs(Reader& reader, const Entries& roads) {
  constexpr const char* kUnits[] = {"m", "m", "m", "1", "1", "1"};
  constexpr const char* kMeanings[] = {"x of the place at which the ground is told",
                                       "y of the place at which the ground is told",
                                       "height of the ground there",
                                       "slope of the ground along x",
                                       "slope of the ground along y",
                                       "factor of the friction of the tyre"};
  for (const Entry& entry : roads) {
    const Value* host = entry.value->kind == Value::Kind::object ? find(*entry.value, "host") : nullptr;
    if (!host || host->kind != Value::Kind::boolean || !host->boolean) continue;
    const Place place = find_member(*entry.value, "host")->place;
    for (int i = 0; i < static_cast<int>(kHostInputs.size()); ++i) {
      Input input{.name = input_name(entry.name, i), .where = where_of(reader.documents, place), .unit = kUnits[i]};
      input.default_value = i == kFriction ? 1 : 0;
      input.shown.description = kMeanings[i];
      const int index = static_cast<int>(reader.model.inputs.size());
      const bool is_new = reader.names.inputs.emplace(input.name, index).second;
      if (!is_new || reader.names.parameters.contains(input.name))
        report(reader, place,
               fmt::format("the host's input {} has the name of {}", in_quotes(input.name),
                           is_new ? "a parameter" : "an input"),
               "rename one of them, or the road");
      if (is_new) reader.model.inputs.push_back(std::move(input));
    }
  }
}

void lay_host_plane(Reader& reader, const Value& value, RoadFields& road) {
  for (const Member& member : value.members)
    if (member.key != "host")
      report(reader, member.place, fmt::format("a road of a host takes no {}", in_quotes(member.key)),
             "the host tells height, slopes and friction in global axes");
  const auto first = reader.names.inputs.find(input_name(road.name, kX));
  if (first == reader.names.inputs.end()) return;
  road.host_input = first->second;
  const Place place = find_member(value, "host")->place;
  const auto name = [&](int which) { return input_name(road.name, which); };
  read_field(
      reader, "height", place,
      fmt::format("{} + {}*(x - {}) + {}*(y - {})", name(kHeight), name(kSlopeX), name(kX), name(kSlopeY), name(kY)),
      road);
  read_field(reader, "friction", place, name(kFriction), road);
}

void check_host_road(Reader& reader, const Value& value, const Tyre& tyre, const std::vector<Tyre>& before) {
  if (tyre.road < 0 || reader.model.roads[static_cast<std::size_t>(tyre.road)].host_input < 0) return;
  const auto other = std::find_if(before.begin(), before.end(), [&](const Tyre& one) { return one.road == tyre.road; });
  if (other == before.end()) return;
  report(reader, member_or_object(value, "road"),
         fmt::format("a host tells the ground of road {} under one wheel, and tyre {} stands there",
                     in_quotes(reader.model.roads[static_cast<std::size_t>(tyre.road)].name), in_quotes(other->name)),
         "give each wheel a road of its own");
}

}  // namespace mbgen::reading
