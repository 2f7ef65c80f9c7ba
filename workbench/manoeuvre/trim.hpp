#pragma once
// Steady motions of a vehicle by speed, bend and grade, with what steering does there.

#include <optional>
#include <string>
#include <vector>

#include "compiler/compile.hpp"
#include "workbench/operating/steady_motion.hpp"

namespace mbgen {

/// A bend is asked by its lateral acceleration or its radius; without both the vehicle drives straight on.
struct TrimRequest {
  double speed = 0;                                 ///< m/s, of the reference point along its path
  std::optional<double> lateral_acceleration = {};  ///< m/s^2, to the left
  std::optional<double> radius = {};                ///< m, of the path of the reference point, positive to the left
};

/// Changes along the steady motions of one speed. Sources: ISO 4138; ISO 8855.
struct SteeringGains {
  double yaw_rate = 0;              ///< 1/s: rad/s over rad at the steering input
  double lateral_acceleration = 0;  ///< m/s^2 over rad
  double sideslip = 0;              ///< rad over rad
  double understeer_gradient = 0;   ///< rad/(m/s^2), at the wheels: d(steer/ratio)/da - wheelbase/speed^2
  double roll_gradient = 0;         ///< rad/(m/s^2)
};

struct Trim {
  SteadyMotion steady;
  LinearSystem system;                                       ///< there, not yet in the rotating frame
  double speed = 0, yaw_rate = 0, lateral_acceleration = 0;  ///< m/s, rad/s, m/s^2 of the reference point
  double steer = 0;                                          ///< rad, at the input
  std::optional<double> drive = {};                          ///< N m, where the vehicle has this input
  double sideslip = 0, roll = 0, pitch = 0;                  ///< rad; sideslip from the heading to the path
  std::vector<double> loads = {};                            ///< N, per tyre
  std::optional<SteeringGains> gains = {};                   ///< none on a grade: bends are not steady there

  /// m, positive to the left; infinite straight on.
  double radius() const { return speed / yaw_rate; }
};

struct TrimSeries {
  std::vector<Trim> trims;  ///< of the first requests
  std::string end;          ///< why there are fewer than requests, as a message without its file; "" if there are all
};

/// Prepares a model for trims: outputs of the vehicle's motion (add_vehicle_outputs). Fails: UserError without a
/// vehicle, tyres or a steering input.
void prepare_trims(Model& model);

/// Inclines gravity as on a road that climbs `grade` (rise over run) along `heading`, rad.
void incline(Model& model, double grade, double heading);

/// Heading of the vehicle at a point, rad. Requires: prepare_trims.
double heading_at(const Compilation& compilation, const OperatingPoint& point);

/// Speed over the ground, m/s. Requires: prepare_trims.
double speed_at(const Compilation& compilation, const OperatingPoint& point);

/// Steady motions one after the other, each from the one before, the first from straight running at `start`: bends
/// tighten by at most 1 m/s^2 at once, so that a motion beyond the limit of grip is not passed over. The drive balances
/// drag. compilation: partitions that become poor are chosen again. start: moving; its rates are scaled to the speed.
/// Fails: UserError if the vehicle does not move at the start, or has no steady motion straight on.
TrimSeries trim_series(Compilation& compilation, const OperatingPoint& start, const std::vector<TrimRequest>& requests);

}  // namespace mbgen
