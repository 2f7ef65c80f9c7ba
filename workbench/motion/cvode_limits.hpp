#pragma once
// Limits of steps by CVODE.

namespace mbgen {

/// Error of the loops, in tolerances, at which the motion restarts with closed loops.
constexpr double kOpenLoops = 100;
/// Largest number of CVODE steps for one step of the table: more means no progress.
constexpr long kMostSteps = 500'000;
/// Corners reached between two rows of the table; more are chatter, and corners are ignored until the next row.
constexpr int kMostCorners = 100;
/// Shares of the time to an event below this count as zero.
constexpr double kNoTime = 1e-12;
/// Distance beyond a corner, in steps, at which the laws of both sides are compared once more.
constexpr double kBesideCorner = 1e-3;
/// Replaces a zero condition, which is the upper side: CVODE takes zeros as roots, even lasting ones.
constexpr double kUpperSide = 1e-300;
/// Vectors by which the fixed-point iteration is accelerated (Anderson).
constexpr int kAcceleration = 3;

}  // namespace mbgen
