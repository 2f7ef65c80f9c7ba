#pragma once
// Steps that leap from one branch of a motion to another, for engines that do not look for it themselves.

#include <functional>
#include <utility>
#include <vector>

#include "workbench/engines/engine.hpp"

namespace mbgen {

/// Looks at steps by the Jacobians of the loops in relative coordinates, as the steps of generated code are looked at,
/// see check_way of mbgen/solver/singular_step.hpp.
class BranchGuard {
 public:
  /// inputs_at: of the model, at a time. most: see WayLimits; 0 for steps whose error is controlled, which only may
  /// leap. It keeps a reference to the compilation.
  BranchGuard(const Compilation& compilation, std::function<std::vector<double>(double)> inputs_at, double most);

  /// Looks at a step of h seconds between two closed states, but for one that changes charts. Result: ok; singular_met
  /// where it passed a singular position. Fails: loop_singular where it leapt over one that branches do not cross at,
  /// or turned aside from one within a step that is too long for it.
  Status look(const GenericState& from, const GenericState& to, double h) const;
  /// rad or m, the largest way of a coordinate in a loop.
  double way(const GenericState& from, const GenericState& to) const;

 private:
  mutable GenericSolver solver_;  ///< for its inputs
  std::function<std::vector<double>(double)> inputs_at_;
  std::vector<int> joints_;  ///< coordinates in loops
  double most_;
};

/// The engine with steps that are looked at: one that leapt fails and leaves its state. Engines that look themselves
/// are returned as they are; judges do not, nor do solvers whose loops keep their frozen partition.
Engine with_branch_guard(const Compilation& compilation, const Engine& engine);

/// Steps of error control that leapt, which are taken again by shorter ones.
class LeapWatch {
 public:
  explicit LeapWatch(BranchGuard guard) : guard_(std::move(guard)) {}

  /// Whether a step from `last` to `closed` leapt to another branch, and is to be taken again.
  bool look(const GenericState& last, const GenericState& closed);
  /// s, of steps that start at t; 0 for no bound.
  double longest(double t) const { return t < leapt_to_ ? longest_ : 0; }
  /// Of a step that leapt: ok while shorter ones are to be tried, else loop_singular.
  Status status() const { return tries_ > kMostTries ? leapt_ : Status{}; }
  /// singular_met where a singular position was passed since the last call.
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
