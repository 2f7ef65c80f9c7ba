// The bounds of a cost sheet: reached by systems that make every step as hard as it can be, and never passed.

#include "mbgen/worst_case.hpp"

#include <gtest/gtest.h>

#include "mbgen/solver/rosenbrock.hpp"

namespace mbgen {
namespace {

/// Counts of calls so far.
struct Counter {
  CallCount calls;
  int nearest = 0;          ///< calls of project_nearest among the projections
  bool looks_back = false;  ///< the step is looked at for a leap
};

/// Cause for which a step is taken again with care.
enum class Alarm { none, projection, fifth_evaluation };

/// A coordinate that is singular to project_nearest as long as that makes most work: nodes are clear at the last
/// spacing, and branches do not cross there. In the end of the step they are said to have changed their side, and to
/// cross all the same.
struct Adversary {
  struct State {
    double z[1], zd[1], x[1], t;
  };
  struct Derivative {
    double zdd[1], xd[1];
  };
  Counter& counter;
  Alarm alarm = Alarm::none;

  Status derivative(const State&, Derivative& rates) const noexcept {
    rates = {};
    return note(++counter.calls.accelerations == 5 && alarm == Alarm::fifth_evaluation);
  }
  Status project(State&) const noexcept {
    ++counter.calls.projections;
    return note(alarm == Alarm::projection);
  }
  Status project_nearest(State&) const noexcept {
    ++counter.calls.projections;
    constexpr int kNearest = kCarefulClosing.projections - 2;  // the others are of project_crossing and watch_way
    return counter.nearest++ % kNearest < 1 + 2 * (kSpacings - 1) ? Status{Code::singular_met, 0} : Status{};
  }
  Status project_crossing(State&, double& clearance) const noexcept {
    ++counter.calls.projections;
    clearance = 0.05;
    return counter.looks_back ? Status{} : Status{Code::loop_singular, 0};
  }
  int changed_side(const State&, const State&) const noexcept {
    ++counter.calls.projections;
    counter.looks_back = true;
    counter.nearest = 1;  // no closing comes before the nodes
    return 0;
  }
  Status watch_way(const State& from, const State& to, double, const WayLimits& limits) const noexcept {
    if (limits.least > 0) return {};  // a step whose stages were far from singular positions
    if (limits.aside == 0) {
      ++counter.calls.projections;
      return {};
    }
    changed_side(from, to);
    return {Code::singular_met, 0};
  }
  using Tangents = double;
  Status tangents(const State&, double g, Tangents& values) const noexcept {
    ++counter.calls.matrices;
    values = g;
    return {};
  }
  void solve(const Tangents& g, double, const StateRates<Adversary>& rates, Derivative& change) const noexcept {
    change.zdd[0] = g * rates.derivative.zdd[0];
    change.xd[0] = g * rates.derivative.xd[0];
  }
  static Status note(bool is_near) noexcept { return is_near ? Status{Code::near_singular, 0} : Status{}; }
};

struct Steps {
  CallCount first, later;  ///< calls of the first step and of the sixth
};

template <class Step>
Steps calls_of(Alarm alarm, const Step& step) {
  Counter counter;
  const Adversary system{counter, alarm};
  Adversary::State state = {{0}, {1}, {0}, 0};
  Steps steps;
  for (int k = 0; k < 6; ++k) {
    counter = {};
    EXPECT_TRUE(step(system, state).ok());
    (k == 0 ? steps.first : steps.later) = counter.calls;
  }
  return steps;
}

void expect_calls(CallCount count, CallCount expected) {
  EXPECT_EQ(count.accelerations, expected.accelerations);
  EXPECT_EQ(count.projections, expected.projections);
  EXPECT_EQ(count.matrices, expected.matrices);
}

TEST(WorstCase, callsOfRungeKutta) {
  const auto step = [](const Adversary& system, Adversary::State& state) { return step_rk4(system, state, 0.01); };
  const Steps easy = calls_of(Alarm::none, step), hard = calls_of(Alarm::projection, step);
  expect_calls(easy.first, kRk4Calls.starting);
  expect_calls(easy.later, kRk4Calls.regular);
  expect_calls(hard.first, kRk4Calls.worst);
  expect_calls(hard.later, kRk4Calls.worst);
}

TEST(WorstCase, callsOfTheImplicitMethod) {
  const auto step = [](const Adversary& system, Adversary::State& state) {
    return step_rosenbrock(system, state, 0.01);
  };
  expect_calls(calls_of(Alarm::none, step).later, kRosenbrockCalls.regular);
  expect_calls(calls_of(Alarm::projection, step).later, kRosenbrockCalls.worst);
}

TEST(WorstCase, callsOfAdamsBashforthMoulton) {
  const auto steps = [](Alarm alarm) {
    AbmHistory<Adversary> history{};
    return calls_of(alarm, [&](const Adversary& system, Adversary::State& state) {
      return step_abm4(system, state, history, 0.01);
    });
  };
  const Steps easy = steps(Alarm::none);
  expect_calls(easy.first, kAbm4Calls.starting);
  expect_calls(easy.later, kAbm4Calls.regular);
  expect_calls(steps(Alarm::fifth_evaluation).first, kAbm4Calls.worst);
}

/// Evaluations in a step of a solver with passages.
struct Evaluations {
  int accelerations = 0, closures = 0, terms = 0;
};

/// A loop that takes as many closures as it may: the first projection all of one, the careful ones all that are left,
/// and the end is said to be on another side of a singular position.
struct Glutton {
  using State = Adversary::State;
  using Derivative = Adversary::Derivative;
  using Passage = mbgen::Passage<double, 1, 1, 1>;
  Evaluations& count;
  bool never_passes = true;

  Status take(int most, int& closures) const noexcept {
    if (closures <= 0) return {Code::loop_singular, 0};
    const int taken = closures < most ? closures : most;
    closures -= taken;
    count.closures += taken;
    return {};
  }
  Status derivative(const State&, Derivative& rates) const noexcept { return rates_near({}, rates); }
  Status rates_near(const State&, Derivative& rates) const noexcept {
    rates = {};
    ++count.accelerations;
    return {};
  }
  Status project(State&) const noexcept { return {}; }
  Status project(State&, int& closures) const noexcept {
    const Status status = take(kMostClosures, closures);
    return status.ok() ? Status{Code::singular_met, 0} : status;
  }
  Status project_nearest(State&) const noexcept { return {}; }
  Status project_nearest(State&, int& closures) const noexcept {
    const Status status = take(count.accelerations < kRk4Evaluations ? 1 : kMostClosures, closures);
    return status.ok() ? Status{Code::near_singular, 0} : status;
  }
  Status project_crossing(State&, double& clearance, int& closures) const noexcept {
    clearance = 0;
    return take(kMostClosures, closures);
  }
  int changed_side(const State&, const State&) const noexcept {
    count.terms += 2;
    return 0;
  }
  Status watch_way(const State&, const State&, double, const WayLimits&) const noexcept {
    count.terms += 2;
    return {Code::singular_met, 0};
  }
  Status look_across(const State&, double, Passage& passage) const noexcept {
    passage.spacing = 0;
    const Status status = take(count.accelerations < kRk4Evaluations ? 1 : kLookClosures, passage.closures);
    return status.ok() && !never_passes ? status : Status{Code::loop_singular, 0};
  }
  bool close_across(Passage&, State&) const noexcept { return false; }
  Status rates_across(const Passage&, const State& state, Derivative& rates) const noexcept {
    return rates_near(state, rates);
  }
};

TEST(WorstCase, aStepSharesItsClosures) {
  Evaluations count;
  Glutton::State state = {{0}, {1}, {0}, 0};
  const Status status = step_rk4(Glutton{count}, state, 0.01);
  EXPECT_EQ(status.code, Code::loop_singular);  // it is not known to pass: it ends, and says where
  EXPECT_EQ(status.index, 0);
  EXPECT_EQ(state.t, 0);
  EXPECT_EQ(count.accelerations, kRk4Evaluations);
  EXPECT_EQ(count.closures, kStepClosures);
  EXPECT_EQ(count.terms, kSideTerms);
}

/// A driven coordinate that runs away from its motion.
struct Runaway {
  static constexpr int kCoordinates = 1, kAuxiliaryStates = 0, kBlocks = 0, kEquations = 0, kDrives = 1;
  static constexpr bool kHasClosure = true;
  static constexpr double kClosureTolerance = 1e-12;
  static constexpr BlockLayout kBlockLayout[] = {{}};
  static constexpr int kBlockCoordinate[] = {0}, kDriveCoordinate[] = {0};
  static constexpr unsigned char kDriven[] = {1}, kRedundant[] = {0};
  struct Parameters {};
  struct Inputs {
    int* closures;
  };
  struct State {
    double z[1], zd[1], x[1], t;
  };
  struct Closure {
    double residual[1], dz[1], zd[1], pivot[1];
  };
  static void closure(const Parameters&, const Inputs& inputs, const State&, Closure& result) noexcept {
    ++*inputs.closures;
    result = {{0}, {1}, {0}, {1}};
  }
};

TEST(WorstCase, closuresOfProjection) {
  int closures = 0;
  Runaway::State state = {};
  const Status status = solver_detail::close_loops<Runaway, solver_detail::Correction::of_dependents>(
      Runaway::Parameters{}, Runaway::Inputs{&closures}, state);
  EXPECT_EQ(status.code, Code::loop_not_closed);
  EXPECT_EQ(closures, kMostClosures);
}

}  // namespace
}  // namespace mbgen
