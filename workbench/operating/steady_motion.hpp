#pragma once
// Steady motion: moving coordinates keep constant rates, all others stand still.

#include <string>
#include <vector>

#include "compiler/compile.hpp"

namespace mbgen {

/// Request for a steady motion.
struct SteadyWish {
  std::vector<std::string>
      hold;  ///< coordinate=rate; none: the first translation that moves at the start where an
             ///< input is found for it, else no rate: they take the values at which drive and drag balance
  std::vector<std::string> solve;  ///< inputs that are to be found: a drive, a steering angle
};

/// A motion whose independent coordinates have no acceleration and whose auxiliary states are constant: coordinates
/// that move in `start`, or that are held, keep constant rates; held rates are given; all others are zero. If a
/// coordinate rotates about an axis that only translations carry, as a vehicle yaws, translations across this axis
/// rotate with it, and have the accelerations of the circle.
struct SteadyMotion {
  OperatingPoint point;
  double turning = 0;        ///< rad/s, of the vehicle as a whole
  int across[2] = {-1, -1};  ///< tree coordinates of the translations that turn; -1 where nothing turns
  double largest = 0;        ///< acceleration that is left, rad/s^2 or m/s^2
  std::vector<std::string> free_directions = {};  ///< along which rates and inputs may be chosen, in words
};

/// Marks as neutral the modes that are places seen by who turns with the motion: they go round at its rate.
void mark_places(const SteadyMotion& motion, std::vector<Mode>& list);

/// Searches from `start` by Newton's iteration on the derivatives of the linearisation, steps shortened until they lead
/// nearer. Accelerations count as none below 1e-7, or where the forces behind them are 1e-8 of the model's weight and
/// no step lowers them. Frictions that stick hold no more than they can.
/// Fails: UserError for unknown names, and where there is none near by: with the coordinate that goes on to accelerate,
/// or the friction that would have to hold more.
SteadyMotion steady_motion(const Compilation& compilation, const OperatingPoint& start, const SteadyWish& wish);

/// A note where the holds leave more than one motion; none else.
std::string free_directions_note(const Compilation& compilation, const SteadyMotion& steady);

/// The rates that a steady motion keeps, and the inputs that were found, for people.
std::string steady_text(const Compilation& compilation, const SteadyMotion& steady, const SteadyWish& wish);

/// Sets the auxiliary states to where they stand still at the point's positions, velocities and inputs.
/// Fails: UserError as linearise.
void settle_auxiliary(const Compilation& compilation, OperatingPoint& point);

/// The system seen by who turns with the motion: deviations of the translations across and of their rates are along
/// axes that turn, so that A does not change with time.
LinearSystem turning_with(const SteadyMotion& motion, LinearSystem system);

}  // namespace mbgen
