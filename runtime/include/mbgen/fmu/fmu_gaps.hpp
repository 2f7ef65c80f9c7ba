#pragma once
// Rotations of bodies between the evaluations of an importer's integrator. For any method, a step is at least as long
// as the gap between two of its evaluations; refused steps fill gaps and create none.

#include <cmath>

#include "mbgen/turns.hpp"

namespace mbgen::fmu {

/// Rotation between two evaluations, rad, that is too large for any method. Explicit methods of order 4 and 5 evaluate
/// at half of a step or closer, methods of order 8 at a quarter, multistep methods at the ends: such a gap is a step of
/// 1.5 to 6 rad.
constexpr double kFarTurn = 1.5;

/// Turn over a completed step, rad, over the number of instants at which it was evaluated after its start, that the
/// methods of turns.hpp bear: those with two of them (Runge-Kutta of order 4 and below), and all others, multistep and
/// implicit methods in steps of one among them.
constexpr double kTurnOfTwo = kRk4Turn / 2, kTurnOfOthers = kAbm4Turn;

/// Gaps that are kept at a time; others are forgotten.
constexpr int kMostGaps = 8;

/// A gap between two times of evaluations, s, and the turn of a coordinate over it, rad.
struct Gap {
  double from, to, turn;
  int coordinate;
};

/// Evaluations since the last completed step: the latest of them with its velocities, and gaps that are too wide.
template <int coordinates>
struct Evaluations {
  bool has_front = false;
  double front = 0;                                     ///< s
  double rate[coordinates > 0 ? coordinates : 1] = {};  ///< of every coordinate at the front
  Gap gaps[kMostGaps] = {};
  int count = 0;
  double start = 0;                                           ///< s, of the completed step
  double first_rate[coordinates > 0 ? coordinates : 1] = {};  ///< there
  int instants = 0;                                           ///< of evaluations after it, in the order of time

  /// Restarts at a completed step.
  void begin(double t, const double* rates) noexcept {
    has_front = true;
    front = start = t;
    count = instants = 0;
    for (int i = 0; i < coordinates; ++i) first_rate[i] = rate[i] = rates[i];
  }

  /// Divides the gap around an evaluation; if it is too wide, its wider part is kept.
  void divide(double t) noexcept {
    int kept = 0;
    for (int k = 0; k < count; ++k) {
      Gap gap = gaps[k];
      const double width = gap.to - gap.from;
      if (t > gap.from && t < gap.to) {
        (t - gap.from > gap.to - t ? gap.to : gap.from) = t;
        gap.turn *= (gap.to - gap.from) / width;
      }
      if (gap.turn > kFarTurn) gaps[kept++] = gap;
    }
    count = kept;
  }

  /// Adds an evaluation. is_rotation: of a coordinate. The rotation is computed with the smaller rate of the two ends.
  template <class IsRotation>
  void add(double t, const double* rates, const IsRotation& is_rotation) noexcept {
    if (!has_front) return begin(t, rates);
    divide(t);
    if (!(t > front)) return;
    Gap widest{front, t, 0, -1};
    for (int i = 0; i < coordinates; ++i) {
      const double turn = std::fmin(std::abs(rate[i]), std::abs(rates[i])) * (t - front);
      if (turn > widest.turn && is_rotation(i)) widest = {front, t, turn, i};
    }
    if (widest.turn > kFarTurn && count < kMostGaps) gaps[count++] = widest;
    front = t;
    ++instants;
    for (int i = 0; i < coordinates; ++i) rate[i] = rates[i];
  }

  /// The widest turn of a coordinate from one instant of a step that is completed at `end` to the next, in the mean;
  /// coordinate -1 where none is too wide. The turn is taken at the rate of the slower end.
  template <class IsRotation>
  Gap widest_in_mean(double end, const IsRotation& is_rotation) const noexcept {
    Gap result{start, end, instants == 2 ? kTurnOfTwo : kTurnOfOthers, -1};
    if (!has_front || instants == 0) return result;
    for (int i = 0; i < coordinates; ++i) {
      const double turn = std::fmin(std::abs(first_rate[i]), std::abs(rate[i])) * (end - start) / instants;
      if (turn > result.turn && is_rotation(i)) result.turn = turn, result.coordinate = i;
    }
    return result;
  }

  /// The widest gap up to the end of a completed step; coordinate -1 where none is too wide.
  Gap widest(double end) const noexcept {
    Gap result{0, 0, 0, -1};
    for (int k = 0; k < count; ++k)
      if (gaps[k].to <= end && gaps[k].turn > result.turn) result = gaps[k];
    return result;
  }
};

}  // namespace mbgen::fmu
