#pragma once
// The vehicle of a model: its data and its motion.

#include <optional>
#include <string>
#include <vector>

#include "compiler/model/model.hpp"
#include "workbench/manoeuvre/driver.hpp"
#include "workbench/manoeuvre/vehicle_series.hpp"
#include "workbench/motion/simulation.hpp"

namespace mbgen {

/// Data of a vehicle for manoeuvres, from the parts of its model in the reference position.
struct VehicleFacts {
  double mass = 0;             ///< kg, of all bodies and rods
  double radius = 0;           ///< m, mean of the tyres
  double wheelbase = 0;        ///< m
  double towed_rear = 0;       ///< m, from the reference point of the towed unit back to the rearmost tyres
  double front = 0, rear = 0;  ///< m, from the reference point to the foremost and the rearmost tyres
  std::vector<double> tracks;  ///< m, per axle, between its outermost tyres
  std::vector<VehicleSeries::Wheel> wheels;  ///< per tyre of the model; axles from front to rear
};

/// Axle of each tyre, from front to rear: 0, 1, ...
std::vector<int> axles_of_tyres(const Model& model);

/// Tyres belong to one axle if their centres are within kSameAxle of each other along x. Fails: UserError without a
/// vehicle, without tyres, or for an input of the vehicle in a unit other than rad and N m.
VehicleFacts vehicle_facts(const Model& model);
constexpr double kSameAxle = 0.3;  // m

/// Appends the outputs of vehicle_reading: outputs of a towed unit (`towed_x`, ...), then `vehicle_x`, ...,
/// `vehicle_load_TYRE`. They are also columns of the table. Fails: UserError if the model has an output of such a name.
void add_vehicle_outputs(Model& model);

/// Index of the first vehicle output. Requires: the model has them, after its own outputs.
std::size_t first_vehicle_output(const Model& model);

/// Motion of a towed unit.
struct TowedReading {
  PlaneMotion plane;
  double yaw_rate = 0;  ///< rad/s
};

/// A point of the vehicle's motion.
struct VehicleReading {
  PlaneMotion plane;
  double longitudinal_acceleration = 0, vertical_acceleration = 0;  ///< m/s^2
  double yaw_rate = 0, roll = 0, pitch = 0;                         ///< rad/s, rad, rad
  std::vector<double> loads;                                        ///< N, per tyre
  std::optional<TowedReading> towed;                                ///< the last unit
};

/// Vehicle motion of a sample. first: first_vehicle_output. last: the reading before; headings are continued from it
/// without jumps, and it has a towed unit if the model has one.
VehicleReading vehicle_reading(const Sample& sample, std::size_t first, const VehicleReading& last);

/// Adds a point.
void append(VehicleSeries& series, double t, const VehicleReading& reading, double steer);

}  // namespace mbgen
