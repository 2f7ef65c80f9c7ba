#pragma once
// The only freedom of a loop block followed along its whole motion: which coordinate may be free, and which order of
// pivots comes near zero nowhere.

#include <vector>

#include "compiler/analysis/configuration.hpp"
#include "compiler/analysis/findings.hpp"

namespace mbgen {

/// Blocks of as many pivots are looked at along their motion: another partition at run time costs more than a usual
/// step there.
constexpr int kFollowedFrom = 12;

/// Samples of a motion; empty where there is none, or more than one.
struct MotionAlong {
  std::vector<SparseRows> jacobians;
  std::vector<std::vector<double>> ways;  ///< per coordinate of the block: its rate, 1 of the fastest one
};

/// The motion of block `b` from the reference until it is there again, or as far as it goes both ways. Of a block with
/// motions, several freedoms or less than kFollowedFrom pivots: none. Requires: a block that is closed at the
/// reference. Cost: at most 240 positions.
MotionAlong motion_along(NumericSystem& numbers, std::size_t b, const Configuration& reference,
                         const LoopPartition& partition);

/// The free coordinate of a partition, or a better one where it comes to rest somewhere, as a rocker does where it
/// turns back: among the coordinates without a rest the one on which most equations depend, as on a crank.
int free_coordinate_along(const MotionAlong& along, const LoopPartition& partition);

/// Orders the pivots by the fine structure under the free coordinate, if the given order comes near zero somewhere
/// along the motion and the other one keeps farther away: once the free coordinate is known, the dependent Jacobian is
/// block triangular, each leg of a walking machine a chain of small systems, and two equations for two coordinates have
/// four orders. Result: the smallest monitor of the partition along the motion, 1 without samples. Source: Dulmage and
/// Mendelsohn.
double order_along_motion(const MotionAlong& along, std::size_t coordinates, LoopPartition& partition);

/// The same of all candidates of a block: the cheapest that keeps clear of zero becomes its partition, and others that
/// do not are no candidates any more. Nothing changes where none does.
void prefer_along_motion(const MotionAlong& along, std::size_t coordinates, BlockAnalysis& block);

}  // namespace mbgen
