// Tables of fields: manoeuvre files.
#include "workbench/manoeuvre/tables_manoeuvre.hpp"

#include <array>

namespace mbgen::reading {
namespace {

constexpr std::array<std::string_view, 12> kTypes = {
    "events",           "steady_circle",    "step_steer", "sine_sweep",      "lane_change", "weave",
    "straight_braking", "mu_split_braking", "ride",       "sine_with_dwell", "track",       "standing_start"};
/// In the order of Side.
constexpr std::array<std::string_view, 2> kSides = {"left", "right"};
/// In the order of CircleManoeuvre::Method.
constexpr std::array<std::string_view, 3> kMethods = {"constant_radius", "constant_speed", "constant_steer"};
/// In the order of LaneManoeuvre::Track.
constexpr std::array<std::string_view, 2> kTracks = {"iso_3888_1", "iso_3888_2"};
/// Of BrakingManoeuvre::has_driver.
constexpr std::array<std::string_view, 2> kSteerings = {"held", "driver"};

FieldInfo number(std::string_view name, std::string_view doc, std::string_view unit, double fallback,
                 Bound bound = Bound::positive) {
  return constant_info(name, doc, unit, fallback, bound, Depends::nothing);
}

FieldInfo open_number(std::string_view name, std::string_view doc, std::string_view unit,
                      Bound bound = Bound::positive) {
  return {.name = name, .shape = Shape::number, .doc = doc, .unit = unit, .bound = bound, .depends = Depends::nothing};
}

FieldInfo angle(std::string_view name, std::string_view doc) {
  FieldInfo info = open_number(name, doc, "rad", Bound::none);
  info.angle = true;
  return info;
}

FieldInfo switched(std::string_view name, std::string_view doc) {
  return {.name = name, .shape = Shape::boolean, .doc = doc, .fallback = 0};
}

FieldInfo side_info() {
  return {
      .name = "side", .shape = Shape::word, .doc = "to which it turns first", .fallback_word = "left", .words = kSides};
}

FieldInfo straight_steering_info() {
  return {.name = "steering",
          .shape = Shape::word,
          .doc = "held straight, or by the driver, who keeps to the straight course",
          .fallback_word = "held",
          .words = kSteerings};
}

FieldInfo required(FieldInfo info) {
  info.need = Need::required;
  return info;
}

/// The fields of a type, after the fields of all types.
template <class F>
std::vector<Field<F>> with_common(FieldInfo speed, std::vector<Field<F>> own) {
  std::vector<Field<F>> all = {
      field<F, &F::format>({.name = "mbgen_manoeuvre",
                            .shape = Shape::number,
                            .doc = "version of the format, 1",
                            .need = Need::required}),
      field<F, &F::type>({.name = "type", .shape = Shape::text, .doc = "kind of manoeuvre", .need = Need::required}),
      field<F, &F::description>({.name = "description", .shape = Shape::text, .doc = "for people", .longest = 4096}),
      field<F, &F::speed>(speed)};
  all.insert(all.end(), own.begin(), own.end());
  for (Field<F>& row : std::vector<Field<F>>{
           field<F, &F::duration>(open_number("duration", "default: as long as the manoeuvre takes", "s")),
           field<F, &F::step>(open_number("step", "default: the model's", "s")),
           field<F, &F::period>(number("period", "of driver and speed controller, in whole steps", "s", 0.01)),
           field<F, &F::written_driver>({.name = "driver",
                    .shape = Shape::object,
                    .doc = "driver model that steers along a course",
                    .of = "driver"}),
           field<F, &F::written_speed_control>({.name = "speed_control",
                    .shape = Shape::object,
                    .doc = "controller of the speed",
                    .of = "speed_control"})})
    all.push_back(row);
  return all;
}

FieldInfo speed_info() {
  return required(open_number("speed", "at the start, and held by the speed controller", "m/s"));
}

FieldInfo amplitude_info(std::string_view what) { return angle("steer", what); }

FieldInfo lateral_info() {
  return open_number("lateral_acceleration",
                     "instead of `steer`: the angle for it, from wheelbase and the driver's `understeer`", "m/s^2");
}

}  // namespace

template <>
std::span<const Field<DriverSettings>> fields<DriverSettings>() {
  using F = DriverSettings;
  static const std::array table = {
      field<F, &F::preview>(number("preview", "preview time for the comparison of course and path", "s", 1.0)),
      field<F, &F::anticipation>(
          number("anticipation", "time by which the driver turns in earlier than the course", "s", 0.3)),
      field<F, &F::gain>(number("gain", "of the correction", "1", 0.5)),
      field<F, &F::understeer>(
          number("understeer",
                 "the driver's knowledge of the vehicle: additional angle of the road wheels over lateral acceleration",
                 "rad s^2/m", 0, Bound::none)),
      field<F, &F::learns>(
          switched("learns",
                   "true: `understeer` and the vehicle's `steer_ratio` are those of the vehicle at the start's speed")),
      field<F, &F::largest_rate>(number("largest_rate", "of the road wheels", "rad/s", 0.6)),
      field<F, &F::lag>(number("lag", "of the hands, from the wanted angle", "s", 0.1)),
  };
  return table;
}

template <>
std::span<const Field<SpeedSettings>> fields<SpeedSettings>() {
  using F = SpeedSettings;
  static const std::array table = {
      field<F, &F::gain>(number("gain", "acceleration for an error of 1 m/s", "1/s", 1)),
      field<F, &F::integral_time>(number("integral_time", "integral time of the PI controller", "s", 4)),
  };
  return table;
}

template <>
std::span<const Field<Event>> fields<Event>() {
  using F = Event;
  static const std::array table = {
      field<F, &F::at>(required(open_number("at", "instant", "s", Bound::not_negative))),
      field<F, &F::over>(number("over", "duration of the change, as 10 u^3 - 15 u^4 + 6 u^5", "s", 0.1)),
      field<F, &F::steer>(
          angle("steer", "new angle at the steering input; with `frequency` an amplitude about the present angle")),
      field<F, &F::frequency>(open_number("frequency", "of a sine", "Hz")),
      field<F, &F::cycles>(number("cycles", "of the sine", "1", 1)),
      field<F, &F::steer_table>({.name = "steer_table",
                                 .shape = Shape::table_points,
                                 .doc = "angle at the steering input over the time since `at`, added to the present "
                                        "angle: s, rad; PCHIP between points"}),
      field<F, &F::drive>(open_number("drive", "new driving torque, without the speed controller", "N m", Bound::none)),
      field<F, &F::brake>(open_number("brake", "new braking torque, without drive", "N m", Bound::not_negative)),
      field<F, &F::speed>(
          open_number("speed", "new speed for the controller, which is active again", "m/s", Bound::not_negative)),
      field<F, &F::is_free>(switched("free", "true: no drive and no brake, gear free")),
      field<F, &F::input>(
          {.name = "input", .shape = Shape::reference, .doc = "any other input, to `value`", .of = "inputs"}),
      field<F, &F::value>(number("value", "of that input", "", 0, Bound::none)),
  };
  return table;
}

template <>
std::span<const Field<Written<EventManoeuvre>>> fields<Written<EventManoeuvre>>() {
  using F = Written<EventManoeuvre>;
  static const std::vector table = with_common<F>(
      open_number("speed", "at the start, held until an event says otherwise; default: the model's, gear free", "m/s"),
      {field<F, &F::written_events>({.name = "events",
                                     .shape = Shape::rotations,
                                     .doc = "changes at instants, in order of time",
                                     .need = Need::required,
                                     .of = "event"})});
  return table;
}

template <>
std::span<const Field<Written<CircleManoeuvre>>> fields<Written<CircleManoeuvre>>() {
  using F = Written<CircleManoeuvre>;
  static const std::vector table = with_common<F>(
      speed_info(),
      {field<F, &F::method>({.name = "method",
                             .shape = Shape::word,
                             .doc = "ISO 4138: the constant quantity",
                             .fallback_word = "constant_radius",
                             .words = kMethods}),
       field<F, &F::radius>(open_number("radius", "of the circle that the driver follows, at constant_radius", "m")),
       field<F, &F::steer>(angle("steer", "at the input: held at constant_steer, the last one at constant_speed")),
       field<F, &F::last_speed>(
           open_number("last_speed",
                       "final speed; default: until the limit below, at constant_steer twice the first speed", "m/s")),
       field<F, &F::acceleration>(number("acceleration", "of the speed", "m/s^2", 0.1)),
       field<F, &F::largest_lateral_acceleration>(
           number("largest_lateral_acceleration", "at which the manoeuvre ends", "m/s^2", 5)),
       field<F, &F::side>(side_info())});
  return table;
}

template <>
std::span<const Field<Written<StepManoeuvre>>> fields<Written<StepManoeuvre>>() {
  using F = Written<StepManoeuvre>;
  static const std::vector table = with_common<F>(
      speed_info(),
      {field<F, &F::steer>(amplitude_info("final angle at the input")),
       field<F, &F::lateral_acceleration>(lateral_info()),
       field<F, &F::at>(number("at", "when it begins", "s", 1, Bound::not_negative)),
       field<F, &F::rate>(open_number("rate", "largest rate at the input; default: for a change in 0.15 s", "rad/s")),
       field<F, &F::side>(side_info())});
  return table;
}

template <>
std::span<const Field<Written<SweepManoeuvre>>> fields<Written<SweepManoeuvre>>() {
  using F = Written<SweepManoeuvre>;
  static const std::vector table =
      with_common<F>(speed_info(), {field<F, &F::steer>(amplitude_info("amplitude at the input")),
                                    field<F, &F::lateral_acceleration>(lateral_info()),
                                    field<F, &F::first_frequency>(number("first_frequency", "at the start", "Hz", 0.2)),
                                    field<F, &F::last_frequency>(number("last_frequency", "at the end", "Hz", 2))});
  return table;
}

template <>
std::span<const Field<Written<LaneManoeuvre>>> fields<Written<LaneManoeuvre>>() {
  using F = Written<LaneManoeuvre>;
  static const std::vector table = with_common<F>(
      speed_info(),
      {field<F, &F::track>({.name = "track",
                            .shape = Shape::word,
                            .doc = "standard of the track",
                            .fallback_word = "iso_3888_1",
                            .words = kTracks}),
       field<F, &F::approach>(number("approach", "straight distance before the first section", "m", 50)),
       field<F, &F::width>(open_number("width", "of the vehicle; default: the `width` of the model", "m")),
       field<F, &F::side>(side_info())});
  return table;
}

template <>
std::span<const Field<Written<WeaveManoeuvre>>> fields<Written<WeaveManoeuvre>>() {
  using F = Written<WeaveManoeuvre>;
  static const std::vector table =
      with_common<F>(speed_info(), {field<F, &F::steer>(amplitude_info("amplitude at the input")),
                                    field<F, &F::lateral_acceleration>(lateral_info()),
                                    field<F, &F::frequency>(number("frequency", "of the steering", "Hz", 0.2)),
                                    field<F, &F::cycles>(number("cycles", "of the steering", "1", 4))});
  return table;
}

template <>
std::span<const Field<Written<BrakingManoeuvre>>> fields<Written<BrakingManoeuvre>>() {
  using F = Written<BrakingManoeuvre>;
  static const std::vector table = with_common<F>(
      speed_info(),
      {field<F, &F::brake>(open_number("brake", "torque of all wheels together", "N m")),
       field<F, &F::deceleration>(open_number(
           "deceleration", "instead of `brake`: the torque is the mass times this times the tyres' radius", "m/s^2")),
       field<F, &F::at>(number("at", "when it begins", "s", 1, Bound::not_negative)),
       field<F, &F::over>(number("over", "rise time of the torque", "s", 0.3)),
       field<F, &F::last_speed>(number("last_speed", "at which the manoeuvre ends", "m/s", 0.2)),
       field<F, &F::has_driver>(straight_steering_info())});
  return table;
}

template <>
std::span<const Field<Written<RideManoeuvre>>> fields<Written<RideManoeuvre>>() {
  using F = Written<RideManoeuvre>;
  static const std::vector table = with_common<F>(speed_info(), std::vector<Field<F>>{});
  return table;
}

template <>
std::span<const Field<Written<DwellManoeuvre>>> fields<Written<DwellManoeuvre>>() {
  using F = Written<DwellManoeuvre>;
  static const std::vector table = with_common<F>(
      speed_info(),
      {field<F, &F::steer>(amplitude_info("amplitude at the input")),
       field<F, &F::lateral_acceleration>(lateral_info()),
       field<F, &F::at>(number("at", "when it begins; the throttle is released", "s", 1, Bound::not_negative)),
       field<F, &F::frequency>(number("frequency", "of the sine", "Hz", 0.7)),
       field<F, &F::dwell>(number("dwell", "rest at the second peak", "s", 0.5, Bound::not_negative)),
       field<F, &F::side>(side_info())});
  return table;
}

template <>
std::span<const Field<Written<TrackManoeuvre>>> fields<Written<TrackManoeuvre>>() {
  using F = Written<TrackManoeuvre>;
  static const std::vector table = with_common<F>(
      speed_info(),
      {field<F, &F::path>(
           {.name = "path",
            .shape = Shape::text,
            .doc = "table (CSV) with the columns x [m], y [m] and perhaps speed [m/s], the highest there; its "
                   "place is relative to this file",
            .need = Need::required}),
       field<F, &F::is_closed>(switched("closed", "true: the course leads back to its first point")),
       field<F, &F::laps>(number("laps", "of a closed course, a whole number", "1", 1)),
       field<F, &F::largest_speed>(number("largest_speed", "anywhere", "m/s", 40)),
       field<F, &F::lateral_acceleration>(number("lateral_acceleration", "of the speed in bends", "m/s^2", 4)),
       field<F, &F::acceleration>(number("acceleration", "with which the speed grows at most", "m/s^2", 1)),
       field<F, &F::deceleration>(number("deceleration", "with which it falls at most", "m/s^2", 2))});
  return table;
}

template <>
std::span<const Field<Written<StartManoeuvre>>> fields<Written<StartManoeuvre>>() {
  using F = Written<StartManoeuvre>;
  static const std::vector table =
      with_common<F>(open_number("speed", "at the start; default: 0", "m/s", Bound::not_negative),
                     {field<F, &F::drive>(open_number(
                          "drive", "torque of all driven wheels; default: the vehicle's `drive_limit`", "N m")),
                      field<F, &F::brake>(number("brake", "torque of all wheels that holds the vehicle until `at`",
                                                 "N m", 0, Bound::not_negative)),
                      field<F, &F::at>(number("at", "when the drive takes over", "s", 0.5, Bound::not_negative)),
                      field<F, &F::over>(number("over", "time in which it does", "s", 0.5)),
                      field<F, &F::last_speed>(number("last_speed", "at which the manoeuvre ends", "m/s", 100 / 3.6)),
                      field<F, &F::has_driver>(straight_steering_info())});
  return table;
}

std::span<const std::string_view> manoeuvre_types() { return kTypes; }

std::vector<ObjectKind> manoeuvre_kinds() {
  const std::vector<std::string_view> amplitude = {"steer", "lateral_acceleration"}, torque = {"brake", "deceleration"};
  return {
      kind_of<Written<EventManoeuvre>>(kTypes[0], "events in time"),
      kind_of<Written<CircleManoeuvre>>(kTypes[1], "steady circle, ISO 4138"),
      kind_of<Written<StepManoeuvre>>(
          kTypes[2], "step of the steering angle, ISO 7401; one of steer and lateral_acceleration", amplitude),
      kind_of<Written<SweepManoeuvre>>(
          kTypes[3], "sines of growing frequency, ISO 7401; one of steer and lateral_acceleration", amplitude),
      kind_of<Written<LaneManoeuvre>>(kTypes[4], "double lane change, ISO 3888-1, or obstacle avoidance, ISO 3888-2"),
      kind_of<Written<WeaveManoeuvre>>(
          kTypes[5], "slow sines about straight ahead, ISO 13674-1; one of steer and lateral_acceleration", amplitude),
      kind_of<Written<BrakingManoeuvre>>(kTypes[6], "braking straight ahead; one of brake and deceleration", torque),
      kind_of<Written<BrakingManoeuvre>>(
          kTypes[7],
          "braking on split friction, different on the left and right of the road; one of brake and deceleration",
          torque),
      kind_of<Written<RideManoeuvre>>(kTypes[8], "straight over the model's road at a speed"),
      kind_of<Written<DwellManoeuvre>>(
          kTypes[9], "sine of steering that rests at its second peak, ISO 19365; one of steer and lateral_acceleration",
          amplitude),
      kind_of<Written<TrackManoeuvre>>(kTypes[10], "drive along the course of a file, as fast as its bends allow"),
      kind_of<Written<StartManoeuvre>>(kTypes[11], "start from standstill, perhaps on a hill with the brake on"),
      kind_of<Event>("event",
                     "change at an instant; exactly one of steer, steer_table, drive, brake, speed, free and input"),
      kind_of<DriverSettings>("driver", "a driver model with preview"),
      kind_of<SpeedSettings>("speed_control", "a PI controller of driving and braking torque"),
  };
}

}  // namespace mbgen::reading
