#pragma once
// The generic runtime as the integrators see it.

#include "mbgen/integrators.hpp"
#include "runtime/generic/generic.hpp"
#include "tests/support/mechanism_support.hpp"

namespace mbgen::testing {

/// A system of mbgen/integrators.hpp around a solver, which must outlive it.
struct Dynamics {
  using State = GenericState;
  using Derivative = GenericDerivative;
  const GenericSolver& solver;
  Status derivative(const State& state, Derivative& rates) const noexcept { return solver.solve_motion(state, rates); }
  Status project(State& state) const noexcept { return solver.project_motion(state); }
  Status project_nearest(State& state) const noexcept { return solver.project_nearest(state); }
  Status project_crossing(State& state, double& clearance) const noexcept {
    return solver.project_crossing(state, clearance);
  }
  int changed_side(const State& from, const State& to) const noexcept { return solver.changed_side(from, to); }
  Status watch_way(const State& from, const State& to, double h, const WayLimits& limits) const noexcept {
    return solver.watch_way(from, to, h, limits);
  }

  using Tangents = GenericTangents;
  Status tangents(const State& state, double g, Tangents& values) const noexcept {
    return solver.tangents(state, g, values);
  }
  void solve(const Tangents& values, double g, const StateRates<Dynamics>& rates, Derivative& change) const noexcept {
    change = solver.changes(values, g, rates.zd, rates.derivative);
  }
};

/// A mechanism in a state of its own, at first that of its reference, and the generic runtime that moves it.
class MechanismInState {
 public:
  explicit MechanismInState(Mechanism m)
      : m_(std::move(m)), solver_(m_.model, m_.topology, m_.analysis), state_(reference_state(m_)) {}

  void set(const std::string& name, double position, double velocity) {
    state_.z[index(name)] = position;
    state_.zd[index(name)] = velocity;
  }
  double z(const std::string& name) const { return state_.z[index(name)]; }
  double zd(const std::string& name) const { return state_.zd[index(name)]; }
  double zdd(const std::string& name) const { return derivative_.zdd[index(name)]; }
  const Analysis& analysis() const { return m_.analysis; }
  const GenericSolver& solver() const { return solver_; }
  GenericState& state() { return state_; }

 protected:
  std::size_t index(const std::string& name) const {
    return static_cast<std::size_t>(find_coordinate(m_.topology, name));
  }

  Mechanism m_;
  GenericSolver solver_;
  GenericState state_;
  GenericDerivative derivative_;
};

}  // namespace mbgen::testing
