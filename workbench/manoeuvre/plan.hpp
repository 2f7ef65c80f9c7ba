#pragma once
// Plan of a manoeuvre for a vehicle: its changes over time, the same form for all types.

#include <limits>
#include <optional>
#include <vector>

#include "workbench/manoeuvre/manoeuvre.hpp"
#include "workbench/manoeuvre/path.hpp"
#include "workbench/manoeuvre/signal.hpp"
#include "workbench/manoeuvre/track.hpp"
#include "workbench/manoeuvre/vehicle_motion.hpp"

namespace mbgen {

/// Torques from an instant on.
struct TorquePhase {
  double at = 0, over = 0;      ///< s: the torques change over some seconds
  bool holds_speed = false;     ///< by the speed controller
  double drive = 0, brake = 0;  ///< N m, without the controller
};

/// Change of an input of the model to a value.
struct InputChange {
  int input = 0;            ///< index into Model::inputs
  double at = 0, over = 0;  ///< s
  double value = 0;
};

struct Plan {
  bool has_driver = false;
  bool is_straight = false;            ///< without a driver, along the line and heading of the start
  Path path;                           ///< in the frame of the start, of a driver
  Signal steer;                        ///< rad at the input, without a driver
  Signal speed;                        ///< m/s, to hold
  std::optional<Track> track;          ///< of a file; its speeds are held instead
  std::vector<TorquePhase> torques;    ///< in order of time, the first at the start
  std::vector<InputChange> others;     ///< in order of time
  std::vector<LaneSection> sections;   ///< in the frame of the start
  double duration = 0;                 ///< s, at the longest
  const char* length_of = "duration";  ///< field of the file that sets this duration
  double begin = 0;                    ///< s, start of the evaluated time
  std::optional<double> free_way;      ///< m of the path, after which the gear is in neutral
  // Conditions of an earlier end.
  double last_way = std::numeric_limits<double>::infinity();                      ///< m of the path
  double last_speed = -1;                                                         ///< m/s, below which it is over
  double above_speed = std::numeric_limits<double>::infinity();                   ///< m/s, likewise above
  double largest_lateral_acceleration = std::numeric_limits<double>::infinity();  ///< m/s^2
};

/// The speed to hold at an instant and a place of the course, m/s.
double wanted_speed(const Plan& plan, double t, double way);

/// Fails: UserError if the vehicle lacks data that the manoeuvre needs. file: of the manoeuvre, for messages.
Plan plan_of(const Manoeuvre& manoeuvre, const Model& model, const VehicleFacts& facts, const std::string& file);

}  // namespace mbgen
