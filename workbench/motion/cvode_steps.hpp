#pragma once
// Steps of an engine's motion by CVODE.

#include <memory>

#include "workbench/motion/branch_guard.hpp"
#include "workbench/motion/controlled_motion.hpp"
#include "workbench/motion/error_control.hpp"

namespace mbgen {

/// Whether mbgen is built with SUNDIALS.
bool has_cvode();

/// Steps through a motion.
class Stepper {
 public:
  virtual ~Stepper() = default;
  /// Advances the state by h seconds. It is unchanged on failure.
  virtual Status step(GenericState& state, double h) = 0;
};

/// See with_error_control. record: outlives the stepper. Requires: has_cvode().
std::unique_ptr<Stepper> make_cvode_stepper(ControlledMotion motion, BranchGuard guard, const ErrorControl& control,
                                            ErrorControlRecord& record);

}  // namespace mbgen
