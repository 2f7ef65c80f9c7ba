#pragma once
// How often a step evaluates accelerations and closes loops, at most: the bounds of every loop of this folder that does
// not run over sizes of the model. See closure.hpp, singular_step.hpp and integrators.hpp; tests hold the counts to be
// exact.

#include "mbgen/solver/closure.hpp"
#include "mbgen/solver/singular_step.hpp"

namespace mbgen {

/// Calls of a System's functions; see integrators.hpp.
struct CallCount {
  int accelerations = 0;  ///< of derivative
  int projections = 0;    ///< of project, project_nearest, project_crossing, and of changed_side and watch_way, which
                          ///< are shorter
  int matrices = 0;       ///< of tangents, each followed by kImplicitStages calls of solve
};

constexpr CallCount operator+(CallCount a, CallCount b) noexcept {
  return {a.accelerations + b.accelerations, a.projections + b.projections, a.matrices + b.matrices};
}
constexpr CallCount operator*(int times, CallCount count) noexcept {
  return {times * count.accelerations, times * count.projections, times * count.matrices};
}

/// A step of a generated solver that may choose coordinates again shares kStepClosures among its projections and the
/// nodes around singular positions. On top come Jacobians of two states each: to watch its way, and for the bisection
/// of the place where its loops change their side.
constexpr int kSideTerms = 2 * (1 + kHalvings);
/// Factorisations of its blocks: one per evaluation of accelerations and of closures, a second one where a state in the
/// middle of a crossing is closed, and those of its way.
constexpr int kSideFactorisations = kCrossingClosures + 3 + kHalvings;

/// Evaluations of the closures in one projection: one before each Newton step, and one after the last.
constexpr int kMostClosures = kNewtonIterations + 1;

/// A singular position, passed or finally not passed: nodes on both sides at every spacing, then all nodes evaluated,
/// and the middle closed and checked.
constexpr CallCount kPassageCalls = {2 * kNodes, 2 * kSpacings + 2 * kNodes + 2};

/// A stage closed with care, and its rates.
constexpr CallCount kCarefulClosing = CallCount{0, 1} + kPassageCalls;
constexpr CallCount kCarefulRates = kCarefulClosing + CallCount{1, 0};

/// A careful step checked for a jump: bisection of the place where loops change their side, and a passage there.
constexpr CallCount kSideCalls = CallCount{0, 2 + kHalvings} + kPassageCalls + CallCount{0, -1};

/// Calls in one step, of a System without passages (care.hpp).
struct StepCalls {
  CallCount regular;   ///< far from singular positions, ways not looked at (WayLimits), the history full
  CallCount starting;  ///< the same with an empty history
  CallCount worst;     ///< a step that begins as `starting` and is taken again with every stage closed with care
};

constexpr StepCalls kRk4Calls = {{4, 1}, {4, 1}, CallCount{4, 1} + 4 * kCarefulRates + kCarefulClosing + kSideCalls};
constexpr StepCalls kAbm4Calls = {{2, 1}, {5, 1}, CallCount{5, 1} + 5 * kCarefulRates + kCarefulClosing + kSideCalls};
/// Evaluations of the accelerations of such a solver: each stage plainly and once more with care.
constexpr int kRk4Evaluations = 2 * 4, kAbm4Evaluations = 2 * 5, kRosenbrockEvaluations = 2 * 4;
constexpr int kImplicitStages = 4;
constexpr StepCalls kRosenbrockCalls = {
    {4, 1, 1}, {4, 1, 1}, CallCount{4, 1, 2} + kImplicitStages* kCarefulRates + kCarefulClosing + kSideCalls};

}  // namespace mbgen
