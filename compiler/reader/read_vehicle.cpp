// The vehicle of a model: one object; entries in later files override.
#include "compiler/reader/raw.hpp"
#include "compiler/reader/reader.hpp"

namespace mbgen::reading {

void read_vehicle(Reader& reader, const std::vector<Part>& parts) {
  if (parts.empty()) return;
  const Value& value = *parts.back().value;
  VehicleFields fields = with_defaults<VehicleFields>();
  if (!read_fields(reader, value, fields)) return;
  const Names& names = reader.names;
  const auto named = [&](const std::optional<std::string>& written, std::string_view key, std::string_view kind,
                         const NameMap<int>& of_kind) {
    return written ? find_named(reader, *find(value, key), kind, of_kind) : -1;
  };
  fields.steer = named(fields.written_steer, "steer", "input", names.inputs);
  fields.drive = named(fields.written_drive, "drive", "input", names.inputs);
  fields.brake = named(fields.written_brake, "brake", "input", names.inputs);
  fields.speed = named(fields.written_speed, "speed", "parameter", names.parameters);
  if (fields.steer_ratio == 0) report(reader, *find(value, "steer_ratio"), "must not be zero");
  if (fields.reference.body >= 0 && fields.reference.body == reader.model.ground)
    report(reader, *find(value, "reference"), "the vehicle is no point of ground, which does not move");
  if (fields.towed.body >= 0 &&
      (fields.towed.body == reader.model.ground || fields.towed.body == fields.reference.body))
    report(reader, *find(value, "towed"),
           fields.towed.body == reader.model.ground ? "the towed unit is no point of ground, which does not move"
                                                    : "the towed unit is another body than the one of \"reference\"");
  reader.model.vehicle = fields;
}

}  // namespace mbgen::reading
