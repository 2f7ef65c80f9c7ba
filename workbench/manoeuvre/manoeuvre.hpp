#pragma once
// Manoeuvres as described in their files: SI units, radians.

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "compiler/text/diagnostic.hpp"

namespace mbgen {

/// Settings of the driver model with preview.
struct DriverSettings {
  double preview = 0;       ///< s
  double anticipation = 0;  ///< s, delay from steering to turning; the driver steers earlier by it
  double gain = 0;          ///< of the correction; 1: a point that follows it meets the path without overshoot
  double understeer = 0;    ///< rad s^2/m: additional angle of the road wheels over lateral acceleration
  double largest_rate = 0;  ///< rad/s, of the road wheels
  double lag = 0;           ///< s, from the wanted angle to the angle
  bool learns = false;      ///< `understeer` and the vehicle's steer_ratio come from the vehicle (learning.hpp)
};

/// Settings of the speed controller.
struct SpeedSettings {
  double gain = 0;           ///< 1/s: acceleration over error
  double integral_time = 0;  ///< s
};

/// Highest speed accepted, m/s: nearly three times the speed of sound.
constexpr double kMostSpeed = 1000;

/// Members of all manoeuvres.
struct ManoeuvreBase {
  std::string description;
  std::optional<double> speed;           ///< m/s, at the start
  std::optional<double> duration, step;  ///< s
  double period = 0;                     ///< s, of driver and speed controller
  DriverSettings driver;
  SpeedSettings speed_control;
  Diagnostics notes = {};  ///< on values that are allowed but unlikely
};

/// One change from an instant on.
struct Event {
  double at = 0, over = 0;                           ///< s
  std::optional<double> steer, drive, brake, speed;  ///< rad, N m, N m, m/s
  std::optional<double> frequency;                   ///< Hz, of a sine of amplitude `steer`
  double cycles = 1;
  std::vector<std::array<double, 2>> steer_table;  ///< s since `at`, rad
  std::optional<std::string> input;
  Where input_where = {};  ///< where its name is written
  double value = 0;        ///< of that input
  bool is_free = false;
};

struct EventManoeuvre : ManoeuvreBase {
  std::vector<Event> events;
};

enum class Side { left, right };

/// Amplitude of steering: an angle at the input, or the lateral acceleration to be reached.
struct SteerAmplitude {
  std::optional<double> steer, lateral_acceleration;  ///< rad, m/s^2
};

/// ISO 4138.
struct CircleManoeuvre : ManoeuvreBase {
  enum class Method { radius, speed, steer };  ///< the quantity that is constant
  Method method = Method::radius;
  std::optional<double> radius, steer, last_speed;  ///< m, rad at the input, m/s
  double acceleration = 0;                          ///< m/s^2, of the speed
  double largest_lateral_acceleration = 0;          ///< m/s^2: ends there
  Where radius_where = {};                          ///< where `radius` is written
  Side side = Side::left;
};

/// ISO 7401, step input.
struct StepManoeuvre : ManoeuvreBase, SteerAmplitude {
  double at = 0;               ///< s
  std::optional<double> rate;  ///< rad/s at the input
  Side side = Side::left;
};

/// ISO 7401, continuous sinusoidal input with growing frequency.
struct SweepManoeuvre : ManoeuvreBase, SteerAmplitude {
  double first_frequency = 0, last_frequency = 0;  ///< Hz
};

/// ISO 3888-1 and -2.
struct LaneManoeuvre : ManoeuvreBase {
  enum class Track { iso_3888_1, iso_3888_2 };
  Track track = Track::iso_3888_1;
  double approach = 0;          ///< m before the first section
  std::optional<double> width;  ///< m, of the vehicle
  Side side = Side::left;
};

/// ISO 13674-1.
struct WeaveManoeuvre : ManoeuvreBase, SteerAmplitude {
  double frequency = 0;  ///< Hz
  double cycles = 0;
};

/// ISO 19365: a sine of steering that rests at its second peak.
struct DwellManoeuvre : ManoeuvreBase, SteerAmplitude {
  double at = 0, frequency = 0, dwell = 0;  ///< s, Hz, s
  Side side = Side::left;

  double end() const { return at + 1 / frequency + dwell; }  ///< s, of the steering
};

/// Straight-line braking.
struct BrakingManoeuvre : ManoeuvreBase {
  std::optional<double> brake, deceleration;  ///< N m, sum of all wheels; m/s^2
  double at = 0, over = 0;                    ///< s
  double last_speed = 0;                      ///< m/s: ends there
  bool has_driver = false;                    ///< else the steering is held
  bool is_split = false;                      ///< split friction: left and right differ
};

/// Drive over a road at a speed.
struct RideManoeuvre : ManoeuvreBase {};

/// A drive along the course of a file, as fast as its bends allow.
struct TrackManoeuvre : ManoeuvreBase {
  std::string path;                                                     ///< of the table, from the manoeuvre's folder
  Where path_where = {};                                                ///< where it is written
  bool is_closed = false;                                               ///< the course leads back to its first point
  double laps = 1;                                                      ///< of a closed course
  double largest_speed = 0;                                             ///< m/s
  double lateral_acceleration = 0, acceleration = 0, deceleration = 0;  ///< m/s^2, of the speed profile
};

/// A start from standstill, with the brake on until then.
struct StartManoeuvre : ManoeuvreBase {
  std::optional<double> drive;  ///< N m, of all driven wheels; default: the vehicle's drive_limit
  double brake = 0;             ///< N m, of all wheels, until `at`
  double at = 0, over = 0;      ///< s
  double last_speed = 0;        ///< m/s: ends there
  bool has_driver = false;      ///< else the steering is held
};

using Manoeuvre =
    std::variant<EventManoeuvre, CircleManoeuvre, StepManoeuvre, SweepManoeuvre, LaneManoeuvre, WeaveManoeuvre,
                 BrakingManoeuvre, RideManoeuvre, DwellManoeuvre, TrackManoeuvre, StartManoeuvre>;

/// Name of the type in files.
std::string type_of(const Manoeuvre& manoeuvre);

const ManoeuvreBase& base_of(const Manoeuvre& manoeuvre);
ManoeuvreBase& base_of(Manoeuvre& manoeuvre);

/// A number in a manoeuvre other than written. name: path of its field, "speed", "driver.understeer", "events.0.steer"
/// (items count from 0, as in messages); the field, and the object around it, may be absent.
struct ManoeuvreValue {
  std::string name;
  double value = 0;  ///< SI, radians
};

/// Reads and checks a manoeuvre. text: JSON with comments; file_name: for messages; values: instead of those written.
/// Fails: with every problem found, in order of position.
Result<Manoeuvre> read_manoeuvre(std::string_view text, const std::string& file_name,
                                 const std::vector<ManoeuvreValue>& values = {});

/// The same from a file. Fails also when it cannot be read.
Result<Manoeuvre> read_manoeuvre_file(const std::string& path);

/// A number that a manoeuvre of a file may have.
struct ManoeuvreNumber {
  std::string unit;     ///< "" for none
  std::string problem;  ///< why there is none of this name, with the nearest; "" where there is
};

/// Looks for the number of this name, see ManoeuvreValue. text: of a manoeuvre that can be read.
ManoeuvreNumber find_number(std::string_view text, const std::string& name);

/// JSON Schema (draft 2020-12) of the format, and the format as a document.
std::string manoeuvre_schema();
std::string manoeuvre_reference();

}  // namespace mbgen
