#include "workbench/motion/branch_guard.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "compiler/model/inputs.hpp"
#include "compiler/model/model.hpp"
#include "mbgen/integrators.hpp"

namespace mbgen {
namespace {

/// The functions that check_way needs of a system.
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
  Status watch_way(const State& from, const State& to, double h, const WayLimits& limits) const {
    if (limits.most > 0) return at(from.t).watch_way(from, to, h, limits);
    const int block = changed_side(from, to);
    return block < 0 ? Status{} : Status{Code::singular_met, block};
  }
};

/// Inputs of the step that an engine is in, as it was told.
struct StepInputs {
  std::vector<double> values;
  double start = 0;  ///< s
};

}  // namespace

BranchGuard::BranchGuard(const Compilation& compilation, std::function<std::vector<double>(double)> inputs_at,
                         double most)
    : solver_(compilation.model, compilation.topology, compilation.analysis),
      inputs_at_(std::move(inputs_at)),
      most_(most) {
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
  return integrator_detail::check_way(GuardedSystem{solver_, inputs_at_}, from, to, h, {most_, 0});
}

Engine with_branch_guard(const Compilation& compilation, const Engine& engine) {
  const bool is_judge = is_cartesian(engine.name);
  if (!is_judge && chooses_again(compilation.topology)) return engine;
  const auto inputs = std::make_shared<StepInputs>();
  const auto inputs_at = [inputs, list = compilation.model.inputs](double t) {
    return advanced_inputs(list, inputs->values, t - inputs->start);
  };
  const double most = is_judge ? kRk4Turn : largest_turn(compilation.model.solver.integrator);
  const auto guard = std::make_shared<BranchGuard>(compilation, inputs_at, most);
  constexpr double kFar = 0.05;  // rad or m, of loops that are too large to be looked at every time
  const double least = is_judge ? 0 : kFar;
  Engine guarded = engine;
  guarded.set_inputs = [inputs, set_inputs = engine.set_inputs](const std::vector<double>& values) {
    inputs->values = values;
    set_inputs(values);
  };
  guarded.step = [guard, inputs, least, step = engine.step](GenericState& state, double h) {
    GenericState trial = state;
    const Status stepped = step(trial, h);
    const bool looks = stepped.ok() && stepped.code != Code::singular_met && guard->way(state, trial) >= least;
    inputs->start = state.t;
    const Status seen = looks ? guard->look(state, trial, h) : stepped;
    if (!seen.ok()) return seen;
    state = std::move(trial);
    return graver(stepped, seen);
  };
  return guarded;
}

bool LeapWatch::look(const GenericState& last, const GenericState& closed) {
  constexpr double kShorter = 0.1;  // than the step that leapt
  constexpr double kLonger = 2;     // after each step that did not: the way over the place takes few of them
  const Status seen = guard_.look(last, closed, closed.t - last.t);
  if (seen.ok()) {
    notice_ = graver(notice_, seen);
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
