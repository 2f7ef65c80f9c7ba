#pragma once
// Ropes as they are written, and their paths.

#include "compiler/reader/raw.hpp"
#include "compiler/reader/reader.hpp"

namespace mbgen::reading {

/// A station as written.
struct RopeStationFields : RopeStation {
  enum class Sense { positive, negative };
  enum class WrittenContact { slides, grips };
  std::optional<Attachment> point, pulley, drum, cylinder, sphere;
  std::optional<Vector3> written_axis;
  std::optional<Quantity> written_radius, written_friction;
  std::optional<Sense> written_sense;
  std::optional<WrittenContact> written_contact;
  std::optional<CoordinateReference> joint;
  std::optional<double> turns;
};

/// A rope with its stations as written.
struct RopeFields : Rope {
  const Value* written_path = nullptr;
};

template <>
std::span<const Field<RopeStationFields>> fields<RopeStationFields>();
template <>
std::span<const Field<RopeFields>> fields<RopeFields>();

/// Reads the stations of a rope, with the geometry at the reference, and counts its spans. Result: whether the path is
/// sound.
bool read_path(Reader& reader, RopeFields& rope);

}  // namespace mbgen::reading
