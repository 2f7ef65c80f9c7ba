#pragma once
// How far a body may turn within a step.

#include "compiler/model/model.hpp"
#include "mbgen/turns.hpp"

namespace mbgen {

/// Turn within a step, rad, that an integrator bears: see mbgen/turns.hpp.
constexpr double largest_turn(SolverSettings::Integrator integrator) {
  using Integrator = SolverSettings::Integrator;
  return integrator == Integrator::rk4 ? kRk4Turn : integrator == Integrator::abm4 ? kAbm4Turn : kRosenbrockTurn;
}

}  // namespace mbgen
