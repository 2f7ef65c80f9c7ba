// Manoeuvre files: the type first, then the fields of that type.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "compiler/text/read_text.hpp"
#include "workbench/manoeuvre/tables_manoeuvre.hpp"

namespace mbgen {
namespace reading {
namespace {

constexpr const char* kSpeedHint = "speeds are in m/s; km/h may be written \"80/3.6\"";

/// Reports an error unless exactly one of the fields is given.
void require_one(Reader& reader, const Value& value, const std::vector<std::string_view>& names) {
  const auto is_there = [&](std::string_view name) { return find(value, name) != nullptr; };
  const auto count = std::count_if(names.begin(), names.end(), is_there);
  if (count == 1) return;
  std::string list;
  for (const std::string_view name : names) list += (list.empty() ? "" : ", ") + in_quotes(name);
  report(reader, value, fmt::format("must have exactly one of {}, got {}", list, count));
}

/// Notes an acceleration beyond the friction of tyres on a road.
void check_acceleration(Reader& reader, const Value& value, std::string_view name,
                        const std::optional<double>& acceleration) {
  constexpr double kUnlikely = 15, kGravity = 9.81;  // m/s^2
  const Value* written = find(value, name);
  if (!written || !(acceleration.value_or(0) > kUnlikely)) return;
  note(
      reader, written->place,
      fmt::format("{:g} m/s^2 are {:.3g} times gravity, more than tyres give", *acceleration, *acceleration / kGravity),
      "accelerations are in m/s^2; half of gravity may be written \"0.5*9.81\"");
}

void check_amplitude(Reader& reader, const Value& value, const SteerAmplitude& amplitude) {
  require_one(reader, value, {"steer", "lateral_acceleration"});
  check_acceleration(reader, value, "lateral_acceleration", amplitude.lateral_acceleration);
}

/// Refuses an impossible speed, and notes one that is probably in km/h.
void check_speed(Reader& reader, const Value& value, std::string_view name, const std::optional<double>& speed) {
  constexpr double kUnlikely = 70;  // m/s, 252 km/h
  if (!speed || !find(value, name)) return;
  const Place place = find(value, name)->place;
  if (*speed > kMostSpeed)
    report(reader, place, fmt::format("must be at most {:g} m/s, got {:g}", kMostSpeed, *speed), kSpeedHint);
  else if (*speed >= kUnlikely)
    note(reader, place, fmt::format("{:g} m/s are {:g} km/h", *speed, 3.6 * *speed), kSpeedHint);
}

/// Notes an understeer that is probably in degrees: for cars it is 0 to 0.01 rad s^2/m, 6 deg for 10 m/s^2.
void check_understeer(Reader& reader, const Value& driver, double understeer) {
  constexpr double kUnlikely = 0.05, kDegree = std::numbers::pi / 180;
  if (!(std::abs(understeer) >= kUnlikely)) return;
  note(reader, member_or_object(driver, "understeer").place,
       fmt::format("{:g} rad s^2/m are {:.3g} deg more for every m/s^2 across", understeer, understeer / kDegree),
       fmt::format("angles are in rad: {:g} deg s^2/m are {:.4g}", understeer, understeer * kDegree));
}

void check_driver(Reader& reader, const Value& value, const DriverSettings& driver) {
  check_understeer(reader, value, driver.understeer);
  if (driver.learns && find(value, "understeer"))
    report(reader, *find(value, "understeer"), "a driver who learns finds the understeer: leave out one of the two");
}

void check_version(Reader& reader, const Value& value) {
  if (value.kind != Value::Kind::number || value.number != 1)
    report(reader, value, "this mbgen reads version 1, got " + describe(value));
}

void read_event(Reader& reader, const Value& value, std::vector<Event>& events) {
  Event event = with_defaults<Event>();
  if (!read_fields(reader, value, event)) return;
  require_one(reader, value, {"steer", "steer_table", "drive", "brake", "speed", "free", "input"});
  check_speed(reader, value, "speed", event.speed);
  if (event.frequency && !event.steer) report(reader, *find(value, "frequency"), "goes with \"steer\"");
  if (const Value* is_free = find(value, "free"); is_free && !event.is_free && is_free->kind == Value::Kind::boolean)
    report(reader, *is_free, "must be true, which puts the gear in neutral: leave out an event without it");
  if (event.input) event.input_where = where_of(reader.documents, find(value, "input")->place);
  if (event.input && !find(value, "value")) report(reader, value, "key \"value\" is missing");
  if (!events.empty() && event.at < events.back().at)
    report(reader, member_or_object(value, "at"),
           fmt::format("events are in order of time: {} s comes after {} s", event.at, events.back().at));
  events.push_back(std::move(event));
}

void check(Reader& reader, const Value&, Written<EventManoeuvre>& written) {
  const Value* list = written.written_events;
  if (!list) return;
  if (list->kind != Value::Kind::array) return read_event(reader, *list, written.events);
  for (const Value& item : list->items) read_event(reader, item, written.events);
}

void check(Reader& reader, const Value& value, Written<CircleManoeuvre>& written) {
  const bool is_of_radius = written.method == CircleManoeuvre::Method::radius;
  const std::string_view wanted = is_of_radius ? "radius" : "steer";
  const std::string_view unused = is_of_radius ? "steer" : "radius";
  if (!find(value, wanted)) report(reader, value, "key " + in_quotes(wanted) + " is missing");
  if (const Value* other = find(value, unused))
    report(reader, *other, fmt::format("has no effect at this \"method\", which takes {}", in_quotes(wanted)),
           "leave it out, or give \"method\": constant_radius, constant_speed or constant_steer");
  if (const Value* steer = find(value, "steer"); steer && !is_of_radius && written.steer == 0.0)
    report(reader, *steer, "must not be 0: the vehicle would drive straight on");
  check_speed(reader, value, "last_speed", written.last_speed);
  for (const std::string_view of_speed : {"last_speed", "acceleration"})
    if (const Value* other = find(value, of_speed); other && written.method == CircleManoeuvre::Method::speed)
      report(reader, *other, "has no effect at constant_speed, which ends at the angle \"steer\": leave it out");
  if (written.last_speed && written.speed && *written.last_speed < *written.speed)
    report(reader, *find(value, "last_speed"),
           fmt::format("must be at least the speed at the start, {:g} m/s, got {:g}", *written.speed,
                       *written.last_speed));
  if (const Value* radius = find(value, "radius")) written.radius_where = where_of(reader.documents, radius->place);
}

void check(Reader& reader, const Value& value, Written<StepManoeuvre>& written) {
  check_amplitude(reader, value, written);
}

void check(Reader& reader, const Value& value, Written<SweepManoeuvre>& written) {
  check_amplitude(reader, value, written);
  if (written.last_frequency <= written.first_frequency)
    report(reader, member_or_object(value, "last_frequency"),
           fmt::format("the last frequency must be above the first, {} Hz, got {} Hz", written.first_frequency,
                       written.last_frequency));
}

void check(Reader& reader, const Value& value, Written<WeaveManoeuvre>& written) {
  check_amplitude(reader, value, written);
}

void check(Reader& reader, const Value& value, Written<DwellManoeuvre>& written) {
  check_amplitude(reader, value, written);
}

void check(Reader& reader, const Value& value, Written<BrakingManoeuvre>& written) {
  require_one(reader, value, {"brake", "deceleration"});
  check_acceleration(reader, value, "deceleration", written.deceleration);
  written.is_split = written.type == "mu_split_braking";
  if (written.speed && written.last_speed >= *written.speed)
    report(reader, member_or_object(value, "last_speed"),
           fmt::format("must be below the speed at the start, {:g} m/s, got {:g}", *written.speed, written.last_speed));
}

void check(Reader&, const Value&, Written<LaneManoeuvre>&) {}
void check(Reader&, const Value&, Written<RideManoeuvre>&) {}

void check(Reader& reader, const Value& value, Written<TrackManoeuvre>& written) {
  constexpr double kMostLaps = 1000;
  if (const Value* path = find(value, "path")) written.path_where = where_of(reader.documents, path->place);
  if (written.laps > 0 && (written.laps != std::floor(written.laps) || written.laps > kMostLaps))
    report(reader, *find(value, "laps"),
           fmt::format("must be a whole number up to {:g}, got {:g}", kMostLaps, written.laps));
  if (find(value, "laps") && !written.is_closed)
    report(reader, *find(value, "laps"), "goes with a closed course: \"closed\": true");
  check_acceleration(reader, value, "lateral_acceleration", written.lateral_acceleration);
  check_speed(reader, value, "largest_speed", written.largest_speed);
}

void check(Reader& reader, const Value& value, Written<StartManoeuvre>& written) {
  check_speed(reader, value, "last_speed", written.last_speed);
  written.speed = written.speed.value_or(0);
  if (*written.speed >= written.last_speed)
    report(reader, member_or_object(value, "last_speed"),
           fmt::format("must be above the speed at the start, {:g} m/s, got {:g}", *written.speed, written.last_speed));
}

template <class Kind>
Manoeuvre read_as(Reader& reader, const Value& value) {
  Written<Kind> written = with_defaults<Written<Kind>>();
  written.driver = with_defaults<DriverSettings>();
  written.speed_control = with_defaults<SpeedSettings>();
  if (!read_fields(reader, value, written)) return Kind{};
  if (written.format) check_version(reader, *written.format);
  if (written.written_driver && read_fields(reader, *written.written_driver, written.driver))
    check_driver(reader, *written.written_driver, written.driver);
  if (written.written_speed_control) read_fields(reader, *written.written_speed_control, written.speed_control);
  check_speed(reader, value, "speed", written.speed);
  check(reader, value, written);
  return static_cast<const Kind&>(written);
}

/// Readers in the order of manoeuvre_types().
constexpr std::array<Manoeuvre (*)(Reader&, const Value&), 12> kReaders = {
    read_as<EventManoeuvre>, read_as<CircleManoeuvre>, read_as<StepManoeuvre>,    read_as<SweepManoeuvre>,
    read_as<LaneManoeuvre>,  read_as<WeaveManoeuvre>,  read_as<BrakingManoeuvre>, read_as<BrakingManoeuvre>,
    read_as<RideManoeuvre>,  read_as<DwellManoeuvre>,  read_as<TrackManoeuvre>,   read_as<StartManoeuvre>};

Manoeuvre read(Reader& reader, const Value& value) {
  const Value* type = find(value, "type");
  if (value.kind != Value::Kind::object) {
    report(reader, value, "must be an object, got " + describe(value));
  } else if (const Member* model = find_member(value, "mbgen")) {
    report(reader, model->place, "the file is a model, not a manoeuvre", "mbgen simulate MODEL --manoeuvre FILE");
  } else if (!find(value, "mbgen_manoeuvre")) {
    report(reader, value, "key \"mbgen_manoeuvre\" is missing", "a manoeuvre begins with \"mbgen_manoeuvre\": 1");
  } else if (!type) {
    report(reader, value, "key \"type\" is missing");
  } else {
    const FieldInfo info{.name = "type", .shape = Shape::word, .words = manoeuvre_types()};
    if (const int index = read_word(reader, *type, info); index >= 0)
      return kReaders[static_cast<std::size_t>(index)](reader, value);
  }
  return RideManoeuvre{};
}

}  // namespace
}  // namespace reading

Result<Manoeuvre> read_manoeuvre(std::string_view text, const std::string& file_name,
                                 const std::vector<ManoeuvreValue>& values) {
  using namespace reading;
  Reader reader;
  const std::size_t index = add_document(reader, file_name, std::string(text));
  Document& document = reader.documents[index];
  std::optional<Manoeuvre> manoeuvre;
  if (parse_document(document, static_cast<std::uint32_t>(index), reader.problems)) {
    put_values(document.root, values);
    manoeuvre = read(reader, document.root);
  }
  if (!reader.problems.empty()) return to_diagnostics(reader.documents, std::move(reader.problems));
  const Diagnostics notes = to_diagnostics(reader.documents, std::move(reader.notes));
  std::visit([&](auto& one) { one.notes = notes; }, *manoeuvre);
  return *manoeuvre;
}

Result<Manoeuvre> read_manoeuvre_file(const std::string& path) {
  const reading::FileText content = reading::read_text(path);
  if (!content.problem.empty()) return Diagnostic{{path, 0, 0, {}, {}}, content.problem, hint_of_missing(path), {}};
  return read_manoeuvre(content.text, path);
}

std::string type_of(const Manoeuvre& manoeuvre) {
  const std::size_t index = manoeuvre.index();
  const BrakingManoeuvre* braking = std::get_if<BrakingManoeuvre>(&manoeuvre);
  constexpr std::size_t kBraking = 6;
  const bool is_later = (braking && braking->is_split) || index > kBraking;
  return std::string(reading::manoeuvre_types()[is_later ? index + 1 : index]);
}

ManoeuvreBase& base_of(Manoeuvre& manoeuvre) {
  return std::visit([](auto& one) -> ManoeuvreBase& { return one; }, manoeuvre);
}

const ManoeuvreBase& base_of(const Manoeuvre& manoeuvre) {
  return std::visit([](const auto& one) -> const ManoeuvreBase& { return one; }, manoeuvre);
}

}  // namespace mbgen
