#pragma once
// Steady motion: moving coordinates have constant rates, all others are at rest.

#include <string>
#include <vector>

#include "compiler/compile.hpp"
#include "workbench/operating/steady_request.hpp"

namespace mbgen {

/// A motion without accelerations of the independent coordinates and with constant auxiliary states. Coordinates that
/// move in `start` have constant rates, some of which are prescribed; the rates of all others are zero. If a
/// coordinate rotates about an axis and is supported by translations only, as a vehicle's yaw angle, the translations
/// across this axis rotate with it, and have the centripetal acceleration.
struct SteadyMotion {
  OperatingPoint point;
  double turning = 0;        ///< rad/s, of the vehicle as a whole
  int across[2] = {-1, -1};  ///< tree coordinates of the rotating translations; -1 without rotation
  double largest = 0;        ///< remaining acceleration, rad/s^2 or m/s^2
  std::vector<std::string> free_directions = {};  ///< undetermined directions of rates and inputs, in words
  std::string changes = {};       ///< the acceleration that arises along the motion, in words; empty if it is steady
  Eigen::MatrixXd by_goals = {};  ///< change of the states of the linear system, then of all inputs, over each goal
};

/// Marks as neutral the modes of position in the rotating frame: their frequency is the rate of rotation.
void mark_places(const SteadyMotion& motion, std::vector<Mode>& list);

/// Damped Newton iteration from `start` with the derivatives of the linearisation. It converges when accelerations are
/// below 1e-7, or when their forces are below 1e-8 of the model's weight and no step reduces them. Sticking frictions
/// stay within their limits.
/// Fails: UserError for unknown names, and if there is no steady motion near by; it names the coordinate that still
/// accelerates, the output that misses its value, or the friction beyond its limit.
SteadyMotion steady_motion(const Compilation& compilation, const OperatingPoint& start, const SteadyRequest& request);

/// A note if several motions have the prescribed rates; none otherwise.
std::string free_directions_note(const Compilation& compilation, const SteadyMotion& steady);

/// A note if accelerations arise along the motion; none otherwise.
std::string instant_note(const Compilation& compilation, const SteadyMotion& steady);

/// A note if forces are at corners of their laws, as dampers with two slopes whose ends are at rest to each other:
/// their derivatives are then of the side that rounding has. None otherwise.
std::string corners_note(const Compilation& compilation, const SteadyMotion& steady);

/// Rates of a steady motion, and the inputs found, as text.
std::string steady_text(const Compilation& compilation, const SteadyMotion& steady, const SteadyRequest& request);

/// Sets the auxiliary states to their stationary values at the point's positions, velocities and inputs. Fails:
/// UserError as linearise.
void set_steady_states(const Compilation& compilation, OperatingPoint& point);

/// The system in the rotating frame: deviations of the translations across, and of their rates, are along rotating
/// axes, so that A is constant.
LinearSystem turning_with(const SteadyMotion& motion, LinearSystem system);

}  // namespace mbgen
