#pragma once
// Largest rotation of a body within a step.

#include "compiler/model/model.hpp"
#include "mbgen/turns.hpp"

namespace mbgen {

/// Largest rotation within a step, rad, accepted by an integrator: see mbgen/turns.hpp.
constexpr double largest_turn(SolverSettings::Integrator integrator) {
  using Integrator = SolverSettings::Integrator;
  return integrator == Integrator::rk4 ? kRk4Turn : integrator == Integrator::abm4 ? kAbm4Turn : kRosenbrockTurn;
}

}  // namespace mbgen
