#pragma once
// The table of fields of manoeuvre files.

#include "compiler/reader/fields.hpp"
#include "compiler/reader/reader.hpp"
#include "workbench/manoeuvre/manoeuvre.hpp"

namespace mbgen::reading {

/// Fields of all types that are no members of the manoeuvre.
struct CommonFields {
  const Value *format = nullptr, *written_driver = nullptr, *written_speed_control = nullptr;
  std::string type;
};

template <class Kind>
struct Written : Kind, CommonFields {
  const Value* written_events = nullptr;
};

template <>
std::span<const Field<DriverSettings>> fields<DriverSettings>();
template <>
std::span<const Field<SpeedSettings>> fields<SpeedSettings>();
template <>
std::span<const Field<Event>> fields<Event>();
template <>
std::span<const Field<Written<EventManoeuvre>>> fields<Written<EventManoeuvre>>();
template <>
std::span<const Field<Written<CircleManoeuvre>>> fields<Written<CircleManoeuvre>>();
template <>
std::span<const Field<Written<StepManoeuvre>>> fields<Written<StepManoeuvre>>();
template <>
std::span<const Field<Written<SweepManoeuvre>>> fields<Written<SweepManoeuvre>>();
template <>
std::span<const Field<Written<LaneManoeuvre>>> fields<Written<LaneManoeuvre>>();
template <>
std::span<const Field<Written<WeaveManoeuvre>>> fields<Written<WeaveManoeuvre>>();
template <>
std::span<const Field<Written<DwellManoeuvre>>> fields<Written<DwellManoeuvre>>();
template <>
std::span<const Field<Written<BrakingManoeuvre>>> fields<Written<BrakingManoeuvre>>();
template <>
std::span<const Field<Written<RideManoeuvre>>> fields<Written<RideManoeuvre>>();
template <>
std::span<const Field<Written<TrackManoeuvre>>> fields<Written<TrackManoeuvre>>();
template <>
std::span<const Field<Written<StartManoeuvre>>> fields<Written<StartManoeuvre>>();

/// Names of the types in files, in the order of the alternatives of Manoeuvre; BrakingManoeuvre has two.
std::span<const std::string_view> manoeuvre_types();

/// Puts numbers into the tree of a manoeuvre file, in place of its own or as new members of its objects. A name without
/// a place is left out.
void put_values(Value& root, const std::vector<ManoeuvreValue>& values);

/// All kinds of objects of a manoeuvre file, the types first, in their order.
std::vector<ObjectKind> manoeuvre_kinds();

}  // namespace mbgen::reading
