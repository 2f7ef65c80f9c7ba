#pragma once
// The generic runtime as the integrators see it.

#include "mbgen/integrators.hpp"
#include "runtime/generic/generic.hpp"

namespace mbgen::testing {

/// A system of mbgen/integrators.hpp around a solver, which must outlive it.
struct Dynamics {
  using State = GenericState;
  using Derivative = GenericDerivative;
  const GenericSolver& solver;
  Status derivative(const State& state, Derivative& rates) const noexcept { return solver.solve_motion(state, rates); }
  Status project(State& state) const noexcept { return solver.project_motion(state); }
  Status project_nearest(State& state) const noexcept { return solver.project_nearest(state); }
};

}  // namespace mbgen::testing
