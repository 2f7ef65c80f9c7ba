#pragma once
// Detection of steps that jump from one branch of a motion to another, for engines without their own.

#include <functional>
#include <utility>
#include <vector>

#include "workbench/engines/engine.hpp"

namespace mbgen {

/// Checks steps by the Jacobians of the loops in relative coordinates, as generated code checks its steps, see
/// check_way of mbgen/solver/singular_step.hpp.
class BranchGuard {
 public:
  /// inputs_at: inputs of the model at a time. most: see WayLimits; 0 for steps with error control, which can only
  /// jump. It keeps a reference to the compilation.
  BranchGuard(const Compilation& compilation, std::function<std::vector<double>(double)> inputs_at, double most);

  /// Checks a step of h seconds between two closed states, unless it changes charts. Result: ok; singular_met if it
  /// passed a singular position. Fails: loop_singular if it jumped across a position where branches do not cross, or
  /// turned aside from one within a step that is too long for it.
  Status look(const GenericState& from, const GenericState& to, double h) const;
  /// Largest displacement of a coordinate in a loop, rad or m.
  double way(const GenericState& from, const GenericState& to) const;

 private:
  mutable GenericSolver solver_;  ///< for its inputs
  std::function<std::vector<double>(double)> inputs_at_;
  std::vector<int> joints_;  ///< coordinates in loops
  double most_;
};

/// The engine with a check of its steps: a step that jumped fails and leaves its state. Engines with a check of their
/// own are returned as they are; judges have none, nor have solvers whose loops keep their frozen partition.
Engine with_branch_guard(const Compilation& compilation, const Engine& engine);

/// Steps of error control that jumped; shorter ones repeat them.
class LeapWatch {
 public:
  explicit LeapWatch(BranchGuard guard) : guard_(std::move(guard)) {}

  /// Whether a step from `last` to `closed` jumped to another branch, and is to be repeated.
  bool look(const GenericState& last, const GenericState& closed);
  /// Bound of steps that start at t, s; 0 for no bound.
  double longest(double t) const { return t < leapt_to_ ? longest_ : 0; }
  /// After a jump: ok while shorter steps are to be tried, else loop_singular.
  Status status() const { return tries_ > kMostTries ? leapt_ : Status{}; }
  /// singular_met if a singular position was passed since the last call.
  Status take_notice() { return std::exchange(notice_, Status{}); }

 private:
  static constexpr int kMostTries = 8;

  BranchGuard guard_;
  Status notice_, leapt_;
  double longest_ = 0;   ///< s, of a step over the place of the last leap
  double leapt_to_ = 0;  ///< s, where it ended
  int tries_ = 0;        ///< at that place
};

}  // namespace mbgen
