#include "workbench/motion/branch_guard.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "mbgen/integrators.hpp"

namespace mbgen {
namespace {

/// The functions that check_side needs of a system.
struct GuardedSystem {
  using State = GenericState;
  using Derivative = GenericDerivative;
  GenericSolver& solver;
  const std::function<std::vector<double>(double)>& inputs_at;

  GenericSolver& at(double t) const {
    solver.set_inputs(inputs_at(t));
    return solver;
  }
  Status derivative(const State& state, Derivative& rates) const { return at(state.t).solve_motion(state, rates); }
  Status project_nearest(State& state) const { return at(state.t).project_nearest(state); }
  Status project_crossing(State& state, double& clearance) const {
    return at(state.t).project_crossing(state, clearance);
  }
  int changed_side(const State& from, const State& to) const { return at(from.t).changed_side(from, to); }
};

}  // namespace

BranchGuard::BranchGuard(const Compilation& compilation, std::function<std::vector<double>(double)> inputs_at)
    : solver_(compilation.model, compilation.topology, compilation.analysis), inputs_at_(std::move(inputs_at)) {
  for (const LoopBlock& block : compilation.topology.blocks)
    joints_.insert(joints_.end(), block.joints.begin(), block.joints.end());
}

double BranchGuard::way(const GenericState& from, const GenericState& to) const {
  double longest = 0;
  for (const int j : joints_) {
    const auto i = static_cast<std::size_t>(j);
    longest = std::max(longest, std::abs(to.z[i] - from.z[i]));
  }
  return longest;
}

Status BranchGuard::look(const GenericState& from, const GenericState& to, double h) const {
  if (joints_.empty() || from.charts != to.charts) return {};
  return integrator_detail::check_side(GuardedSystem{solver_, inputs_at_}, from, to, h);
}

Engine with_branch_guard(const Compilation& compilation, const Engine& engine, const InputsOverTime& inputs) {
  const auto guard = std::make_shared<BranchGuard>(compilation, [&inputs](double t) { return inputs.at(t); });
  constexpr double kLooksItself = 0.05;  // rad or m
  const double least = is_cartesian(engine.name) ? 0 : kLooksItself;
  Engine guarded = engine;
  guarded.step = [guard, least, step = engine.step](GenericState& state, double h) {
    GenericState trial = state;
    const Status stepped = step(trial, h);
    const bool looks = stepped.ok() && stepped.code != Code::singular_met && guard->way(state, trial) >= least;
    const Status seen = looks ? guard->look(state, trial, h) : stepped;
    if (!seen.ok()) return seen;
    state = std::move(trial);
    return more_telling(stepped, seen);
  };
  return guarded;
}

bool LeapWatch::look(const GenericState& last, const GenericState& closed) {
  constexpr double kShorter = 0.1;  // than the step that leapt
  constexpr double kLonger = 2;     // after each step that did not: the way over the place takes few of them
  const Status seen = guard_.look(last, closed, closed.t - last.t);
  if (seen.ok()) {
    notice_ = more_telling(notice_, seen);
    longest_ *= kLonger;
    if (closed.t > leapt_to_) tries_ = 0;
    return false;
  }
  ++tries_;  // also of steps so short that they lead nowhere
  leapt_ = seen;
  leapt_to_ = tries_ == 1 ? closed.t : std::max(leapt_to_, closed.t);
  longest_ = kShorter * (closed.t - last.t);
  return true;
}

}  // namespace mbgen
