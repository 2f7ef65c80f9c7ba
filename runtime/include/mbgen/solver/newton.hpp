#pragma once
// The limits of Newton's method wherever mbgen uses it: generated solvers, generic runtime, judges, analysis, studies.
// Three uses differ: a projection starts near its end, a search starts anywhere, a balance changes with every step.

#include "mbgen/math/precision.hpp"

namespace mbgen {

/// Steps of a projection before a block counts as not closed; from a fair guess five are enough.
constexpr int kNewtonIterations = 20;
/// Steps of a projection for the derivatives of closed coordinates: one is exact, two more meet what rounding left.
constexpr int kDerivativeSteps = 3;
/// Closures of a state in the middle of a crossing: half as many, each factorises twice.
constexpr int kCrossingClosures = kNewtonIterations / 2;
/// Steps of a search: ten shortened ones make half a turn, and at a singular position a residual falls to a quarter
/// per step.
constexpr int kSearchIterations = 40;
/// Steps of a search for the nearest closed position, which may not exist: every failed step only raises the damping.
constexpr int kNearestIterations = 400;
/// Steps of a search for an equilibrium, five rad or m of kLargestBalanceStep.
constexpr int kBalanceIterations = 100;
/// Steps straight to a balance that need not be stable: one farther away than half a rad or m is another one.
constexpr int kStraightIterations = 10;
/// Steps of a search for a steady motion; each costs a linearisation.
constexpr int kSteadyIterations = 60;

/// Largest change of a coordinate in one step of a projection (rad or m): a linear step is meaningless for half a turn.
template <class Real>
inline constexpr Real kLargestNewtonStep = Real(0.5);
/// The same in a search (rad or m): shorter, because far from closed loops a step can cross to another assembly mode.
constexpr double kLargestSearchStep = 0.3;
/// The same towards a balance of forces (rad or m): springs and contacts change their stiffness within a few degrees.
constexpr double kLargestBalanceStep = 0.05;
/// A step that moves no coordinate by more (rad or m) ends a search: rounding moves them as far.
constexpr double kRoundingStep = 1e-11;
/// A step of this size (rad) was the last: Newton squares the error, and the square is below rounding.
constexpr double kLastStep = 1e-9;

/// Largest residual of closed loops in the analysis (m or 1): a tenth of the smallest one that it calls a
/// contradiction.
constexpr double kClosedForRank = 1e-11;
/// Largest residual of loops that count as closed (m or 1, per second for velocities): as the solvers accept it.
constexpr double kClosed = kRoundingFloor<double>;
/// Residual (m or 1) that no step can lower: rounding of positions of some metres, over sixteen digits.
constexpr double kSmallestResidual = 1e-13;
/// Singular values below this share of the largest leave their direction where it is: divided by this share, rounding
/// stays below 1e-6.
constexpr double kIndifferentShare = 1e-9;

/// Factor of a step whose largest change is `size`, so that no coordinate changes by more than `limit`.
template <class Real>
constexpr Real shortening(Real size, Real limit) noexcept {
  return size > limit ? limit / size : Real(1);
}

}  // namespace mbgen
