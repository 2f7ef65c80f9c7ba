#pragma once
// Numbers that the standards of vehicle dynamics define, from the motion of a vehicle. Definitions by formula:
// docs/use/metrics.md. Axes are those of ISO 8855: x forward, y to the left, z up.
//
// Every function computes what its series allows. A value that it cannot give is missing from the values and stands in
// the notes with the reason; so does a series that cannot be used at all. Every value is finite.

#include <string>
#include <vector>

#include "workbench/manoeuvre/vehicle_series.hpp"
#include "workbench/results/table.hpp"

namespace mbgen {

/// A curve of a diagram. NaN in y interrupts it.
struct DiagramCurve {
  std::string name;
  std::vector<double> x, y;
};

/// A diagram beside the values.
struct Diagram {
  std::string title;
  Heading x, y;
  std::vector<DiagramCurve> curves;
};

struct VehicleMetrics {
  std::vector<VehicleMetric> values = {};
  std::vector<Diagram> diagrams = {};
  /// Missing metrics with the reason; remarks on the others.
  std::vector<std::string> notes = {};
};

/// Steady-state circular driving with slowly growing lateral acceleration, ISO 4138.
struct SteadyCircle {
  enum class Kind { constant_radius, constant_speed, constant_steer };
  Kind kind = Kind::constant_radius;
  double wheelbase = 0;             ///< m
  double radius = 0;                ///< m, nominal, at constant_radius; 0: the path is not checked
  double steering_ratio = 1;        ///< angle at the steering input over the angle at the wheels
  double linear_limit = 3;          ///< m/s^2: gradients are slopes of straight lines fitted below it
  std::vector<double> tracks = {};  ///< m, per axle; none: shares of the load transfer instead of the roll moment
};
VehicleMetrics steady_circle_metrics(const VehicleSeries& series, const SteadyCircle& circle);

/// A step of the steering angle at constant speed, ISO 7401.
struct StepSteer {
  double steady_time = 1;   ///< s at the end, over which steady values are averaged
  double smoothing = 0.05;  ///< s, half width of the local parabola, about 10 Hz; 0: none
};
VehicleMetrics step_steer_metrics(const VehicleSeries& series, const StepSteer& step);

/// Sines of growing frequency, pulses or random steering at constant speed, ISO 7401.
struct SineSweep {
  double lowest = 0, highest = 0;  ///< Hz, band of the steering angle; 0: from its spectrum
  double segment = 0;              ///< s, window of Welch's method; 0: a third of the series, at most 20 s
};
VehicleMetrics sine_sweep_metrics(const VehicleSeries& series, const SineSweep& sweep);

/// Slow sine steering about straight ahead, ISO 13674-1.
struct Weave {
  double frequency = 0.2;  ///< Hz
  double settled = 0;      ///< s, start of the whole cycles; 0: after the first cycle
  double end = 0;          ///< s, of the steering; 0: of the series
};
VehicleMetrics weave_metrics(const VehicleSeries& series, const Weave& weave);

/// A sine of steering that rests at its second peak, ISO 19365 and UN Regulation 140.
struct SineWithDwell {
  double begin = 0;        ///< s, of the steering
  double frequency = 0.7;  ///< Hz
  double dwell = 0.5;      ///< s
};
VehicleMetrics dwell_metrics(const VehicleSeries& series, const SineWithDwell& sine);

/// A section of the track of a lane change, in the frame of the track.
struct LaneSection {
  double from = 0, to = 0;     ///< m, along x
  double left = 0, right = 0;  ///< m, y of its limits, left > right
};

/// Lane change, ISO 3888-1 and ISO 3888-2.
struct LaneChange {
  std::vector<LaneSection> sections;  ///< in driving order
  double x = 0, y = 0, heading = 0;   ///< m, m, rad: the frame of the track in the world
  double front = 0, rear = 0, to_left = 0,
         to_right = 0;  ///< m, >= 0: from the reference point to the sides of the body
};
VehicleMetrics lane_change_metrics(const VehicleSeries& series, const LaneChange& lanes);

/// Motion of the last towed unit relative to the first unit, ISO 14791.
struct Towing {
  double front = 0,
         towed_rear = 0;   ///< m, from the points of both units to the foremost axle, and back to the rearmost
  bool is_circle = false;  ///< of constant radius: offtracking is the steady one of the circle
  double begin = 0;        ///< s: offtracking of a circle counts from here on
};
VehicleMetrics towing_metrics(const VehicleSeries& series, const Towing& towing);

/// Braking to standstill, straight ahead or on split friction; deceleration by UN Regulation 13.
struct Braking {
  double begin = 0;  ///< s: when the brake is applied
};
VehicleMetrics braking_metrics(const VehicleSeries& series, const Braking& braking);

/// Speeds and accelerations of a drive along a course.
VehicleMetrics track_metrics(const VehicleSeries& series);

/// Start from standstill.
struct StandingStart {
  double at = 0;  ///< s: when the drive takes over
};
/// Times from there to round speeds, rollback, distance.
VehicleMetrics start_metrics(const VehicleSeries& series, const StandingStart& start);

/// Ride over a road, ISO 2631-1.
struct Ride {
  double begin = 0;  ///< s: start of the evaluated time
};
VehicleMetrics ride_metrics(const VehicleSeries& series, const Ride& ride);

/// Factor of the frequency weighting W_k of ISO 2631-1 for vertical vibration of seated people. frequency: Hz.
double vertical_weighting(double frequency);

}  // namespace mbgen
