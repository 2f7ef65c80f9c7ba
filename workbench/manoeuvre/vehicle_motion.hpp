#pragma once
// The vehicle of a model: what it is, and how it moves.

#include <optional>
#include <string>
#include <vector>

#include "compiler/model/model.hpp"
#include "workbench/manoeuvre/driver.hpp"
#include "workbench/manoeuvre/vehicle_series.hpp"
#include "workbench/motion/simulation.hpp"

namespace mbgen {

/// Facts about a vehicle that a manoeuvre needs, from the parts of its model at the reference.
struct VehicleFacts {
  double mass = 0;                           ///< kg, of all bodies and rods
  double radius = 0;                         ///< m, mean of the tyres
  double wheelbase = 0;                      ///< m
  double towed_rear = 0;                     ///< m, from the point of the towed unit back to the rearmost tyres
  double front = 0, rear = 0;                ///< m, from the reference point to the foremost and the rearmost tyres
  std::vector<double> tracks;                ///< m, per axle, between its outermost tyres
  std::vector<VehicleSeries::Wheel> wheels;  ///< per tyre of the model; axles from front to rear
};

/// Tyres whose centres are within kSameAxle of each other along x are of one axle. Fails: UserError without a vehicle
/// or without tyres.
VehicleFacts vehicle_facts(const Model& model);
constexpr double kSameAxle = 0.3;  // m

/// Appends the outputs that vehicle_reading takes: `vehicle_x` and so on, and `vehicle_load_TYRE`, before
/// them those of a towed unit, `towed_x` and so on; they are columns of
/// the table too. Fails: UserError where the model has an output of such a name.
void add_vehicle_outputs(Model& model);

/// Index of the first of them. Requires: the model has them, behind its own.
std::size_t first_vehicle_output(const Model& model);

/// A point of the vehicle's motion.
struct VehicleReading {
  PlaneMotion plane;
  double longitudinal_acceleration = 0, vertical_acceleration = 0;  ///< m/s^2
  double yaw_rate = 0, roll = 0, pitch = 0;                         ///< rad/s, rad, rad
  std::vector<double> loads;                                        ///< N, per tyre
  struct Towed {
    PlaneMotion plane;
    double yaw_rate = 0;  ///< rad/s
  };
  std::optional<Towed> towed;  ///< the last unit
};

/// Of a sample of a model with these outputs. first: first_vehicle_output. last: the reading before, near whose
/// headings these are, which are no remainders of a turn; it has a towed unit where the model has one.
VehicleReading vehicle_reading(const Sample& sample, std::size_t first, const VehicleReading& last);

/// Adds a point.
void append(VehicleSeries& series, double t, const VehicleReading& reading, double steer);

}  // namespace mbgen
