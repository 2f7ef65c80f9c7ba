#pragma once
// A mechanism with states of its own that the generic engine steps.

#include <algorithm>
#include <string>
#include <vector>

#include "compiler/model/auxiliary_states.hpp"
#include "mbgen/integrators.hpp"
#include "tests/support/mechanism_support.hpp"

namespace mbgen::testing {

/// A mechanism that is stepped.
class Course {
 public:
  using State = GenericState;
  using Derivative = GenericDerivative;

  explicit Course(const Mechanism& m)
      : mechanism(m), solver(m.model, m.topology, m.analysis), state(reference_state(m)) {}
  explicit Course(const std::string& text) : Course(mechanism_of(text)) {}

  Status derivative(const GenericState& at, GenericDerivative& rates) const noexcept {
    return solver.solve_motion(at, rates);
  }
  Status project(GenericState& at) const noexcept { return solver.project_motion(at); }
  Status project_nearest(GenericState& at) const noexcept { return solver.project_nearest(at); }
  Status project_crossing(GenericState& at, double& clearance) const noexcept {
    return solver.project_crossing(at, clearance);
  }
  Status sample(GenericState& at, double h, bool& any) const noexcept { return solver.sample(at, h, any); }

  /// `count` steps of h seconds by Runge-Kutta, or Adams where a history is given.
  Status step(int count, double h, AbmHistory<Course>* history = nullptr) {
    const double start = state.t;
    for (int k = 1; k <= count; ++k) {
      const Status status = history ? step_abm4(*this, state, *history, h) : step_rk4(*this, state, h);
      if (!status.ok()) return status;
      state.t = start + k * h;
    }
    return {};
  }

  double x(const std::string& name) const { return state.x[place(name)]; }
  std::size_t place(const std::string& name) const {
    const std::vector<std::string> names = auxiliary_state_names(mechanism.model);
    return static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
  }

  const Mechanism mechanism;
  GenericSolver solver;
  GenericState state;
};

}  // namespace mbgen::testing
