// The vehicle of a model: one object, whose entries in later files win.
#include "compiler/model/raw.hpp"
#include "compiler/model/reader.hpp"

namespace mbgen::reading {
namespace {

/// Index of the named element, -1 without a name or where there is none such.
int find_named(Reader& reader, const Value& value, std::string_view key, std::string_view what,
               const std::optional<std::string>& name, const NameMap<int>& names) {
  if (!name) return -1;
  const auto found = find_visible(names, *name, current_scope(reader).visible);
  if (found != names.end()) return found->second;
  const Value& member = *find(value, key);
  if (member.kind == Value::Kind::text)
    report(reader, member, "unknown " + std::string(what) + " " + in_quotes(*name), suggestion(reader, *name, names));
  return -1;
}

}  // namespace

void read_vehicle(Reader& reader, const std::vector<Part>& parts) {
  if (parts.empty()) return;
  const Value& value = *parts.back().value;
  VehicleFields fields = with_defaults<VehicleFields>();
  if (!read_fields(reader, value, fields)) return;
  const Names& names = reader.names;
  fields.steer = find_named(reader, value, "steer", "input", fields.written_steer, names.inputs);
  fields.drive = find_named(reader, value, "drive", "input", fields.written_drive, names.inputs);
  fields.brake = find_named(reader, value, "brake", "input", fields.written_brake, names.inputs);
  fields.speed = find_named(reader, value, "speed", "parameter", fields.written_speed, names.parameters);
  if (fields.steer_ratio == 0) report(reader, *find(value, "steer_ratio"), "must not be zero");
  if (fields.reference.body >= 0 && fields.reference.body == reader.model.ground)
    report(reader, *find(value, "reference"), "the vehicle is no point of ground, which does not move");
  reader.model.vehicle = fields;
}

}  // namespace mbgen::reading
