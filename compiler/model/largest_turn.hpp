#pragma once
// How far a body may turn within a step.

#include "compiler/model/model.hpp"

namespace mbgen {

/// Turn within a step, rad, that an integrator bears: forces that turn with a body come out right to 0.1 % (an
/// unbalanced rotor on a spring, tests/cli/resolved_test.cpp).
constexpr double largest_turn(SolverSettings::Integrator integrator) {
  return integrator == SolverSettings::Integrator::rk4 ? 0.5 : 0.3;
}

}  // namespace mbgen
