#pragma once
// Limits of steps by CVODE.

namespace mbgen {

/// Error of the loops, in tolerances, at which the motion starts anew with closed ones.
constexpr double kOpenLoops = 100;
/// Steps of CVODE for one step of the table: more is no progress.
constexpr long kMostSteps = 500'000;
/// Arrivals at corners between two rows of the table; more are chatter, and no corner is looked for until the next row.
constexpr int kMostCorners = 100;
/// Part of the time to an event that is no time.
constexpr double kNoTime = 1e-12;
/// Part of a step beyond a corner at which the laws of both sides are compared once more.
constexpr double kBesideCorner = 1e-3;
/// In place of a condition that is zero, which is the upper side: CVODE takes zeros for roots, also those that last.
constexpr double kUpperSide = 1e-300;
/// Vectors by which the fixed-point iteration is accelerated (Anderson).
constexpr int kAcceleration = 3;

}  // namespace mbgen
