#pragma once
// Bushings in Cartesian coordinates.

#include "compiler/model/auxiliary_states.hpp"
#include "runtime/judges/mechanism.hpp"

namespace mbgen::cartesian {

/// A bushing at one instant.
struct BushingAtWork {
  Vector6d deflection;            ///< m, then rad, counted as its freedoms are
  Eigen::Vector3d force, moment;  ///< on `from`, in the bushing's axes, at the point of `to`: N, N m
  Load on_from, on_to;
  std::vector<double> xd;  ///< rates of the extensions of its Maxwell branches
};

/// extensions: of its Maxwell branches. Gives no number where the bodies turn by more than kLargestBushingTurn.
BushingAtWork bushing_at_work(const Bushing& bushing, const PartFrames& part, const std::vector<Moving>& bodies,
                              const double* extensions, const Values& value);

/// Adds the loads of all bushings and the rates of their states. x: all auxiliary states.
void add_bushings(const Model& model, const Parts& parts, const std::vector<Moving>& bodies,
                  const std::vector<double>& x, const Values& values, Forces& forces);

}  // namespace mbgen::cartesian
