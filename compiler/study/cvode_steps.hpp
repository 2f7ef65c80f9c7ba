#pragma once
// Steps of an engine's motion by CVODE.

#include <memory>

#include "compiler/engines/engine.hpp"
#include "compiler/study/error_control.hpp"
#include "compiler/study/inputs_over_time.hpp"

namespace mbgen {

/// Whether mbgen is built with SUNDIALS.
bool has_cvode();

/// Steps through a motion.
class Stepper {
 public:
  virtual ~Stepper() = default;
  /// The motion h seconds later. Unchanged on failure.
  virtual Status step(GenericState& state, double h) = 0;
};

/// See with_error_control. record: outlives the stepper. Requires: has_cvode().
std::unique_ptr<Stepper> make_cvode_stepper(const Engine& engine, const InputsOverTime& inputs,
                                            const ErrorControl& control, ErrorControlRecord& record);

}  // namespace mbgen
