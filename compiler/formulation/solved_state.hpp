#pragma once
// A state with its accelerations and constraint forces: the source of outputs and reactions.

#include "compiler/formulation/elements/force_work.hpp"

namespace mbgen {

template <class T>
struct SolvedState {
  const Kinematics<T>& kinematics;
  const Velocities<T>& velocities;
  const Accelerations<T>& accelerations;  ///< with the true joint accelerations
  const AppliedForces<T>& forces;
  const std::vector<T>& zdd;
  const std::vector<std::vector<T>>& multipliers;  ///< per block, per equation
  const std::vector<T>& drive_forces;              ///< per motion
};

}  // namespace mbgen
