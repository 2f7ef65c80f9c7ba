// Steps through singular positions: a bead on two curves that cross, and on two that nearly do.

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "mbgen/blocks.hpp"
#include "mbgen/integrators.hpp"

namespace mbgen {
namespace {

/// A bead of mass 1 on y^2 = sin(x)^2 + gap under gravity -y. Without a gap the curves y = sin(x) and y = -sin(x) cross
/// at every multiple of pi, where all derivatives of the closure vanish.
struct Bead {
  struct State {
    double z[2], zd[2], x[1], t;
  };
  struct Derivative {
    double zdd[2], xd[1];
  };
  double gap = 0;
  double gravity = 0;

  double residual(const State& s) const { return s.z[1] * s.z[1] - std::sin(s.z[0]) * std::sin(s.z[0]) - gap; }
  static double slope(const State& s, int i) { return i == 0 ? -std::sin(2 * s.z[0]) : 2 * s.z[1]; }
  static double square(const State& s) { return slope(s, 0) * slope(s, 0) + slope(s, 1) * slope(s, 1); }

  static Status notice(const State& s) {
    const double pivot = std::max(std::abs(slope(s, 0)), std::abs(slope(s, 1)));
    if (pivot < 1e-10) return {Code::loop_singular, 0};
    return solver_detail::notice_of(0, 1, pivot, 1.0);
  }

  Status derivative(const State& s, Derivative& rates) const noexcept {
    const Status status = notice(s);
    if (!status.ok()) return status;
    const double curvature = 2 * s.zd[1] * s.zd[1] - 2 * std::cos(2 * s.z[0]) * s.zd[0] * s.zd[0];
    const double force = (-gravity * slope(s, 1) + curvature) / square(s);
    rates.zdd[0] = -slope(s, 0) * force;
    rates.zdd[1] = -gravity - slope(s, 1) * force;
    rates.xd[0] = 0;
    return status;
  }
  Status project_nearest(State& s) const noexcept {
    State closed = s;
    for (double previous = INFINITY;;) {
      const Status status = notice(closed);
      if (!status.ok()) return status;
      const double size = std::abs(residual(closed));
      const bool gains = size > 0 && size < 0.5 * previous;
      if (!gains && size > 1e-9) return {Code::loop_not_closed, 0};
      previous = size;
      const double open = gains ? residual(closed) : slope(closed, 0) * s.zd[0] + slope(closed, 1) * s.zd[1];
      double* const corrected = gains ? closed.z : closed.zd;
      const double correction[] = {slope(closed, 0) * open / square(closed), slope(closed, 1) * open / square(closed)};
      for (int i = 0; i < 2; ++i) corrected[i] -= correction[i];
      if (!gains) {
        s = closed;
        return status;
      }
    }
  }
  Status project(State& s) const noexcept { return project_nearest(s); }
  /// All derivatives of the closure vanish at a crossing: nothing is corrected there.
  Status project_crossing(State& s, double& clearance) const noexcept {
    clearance = std::max(std::abs(slope(s, 0)), std::abs(slope(s, 1)));
    return std::abs(residual(s)) <= 8e-12 ? Status{} : Status{Code::loop_singular, 0};
  }
  int changed_side(const State& from, const State& to) const noexcept {
    return slope(from, 0) * slope(to, 0) + slope(from, 1) * slope(to, 1) < 0 ? 0 : -1;
  }
  Status watch_way(const State& from, const State& to, double h, const WayLimits& limits) const noexcept {
    LoopWay way;
    for (int i = 0; i < 2; ++i) way.add(from.zd[i], to.zd[i]);
    if (std::hypot(to.z[0] - from.z[0], to.z[1] - from.z[1]) < limits.least) return {};
    const auto clearance = [](const State& s) { return std::max(std::abs(slope(s, 0)), std::abs(slope(s, 1))); };
    if (h * way.fastest <= limits.most * std::min(clearance(from), clearance(to))) return {};
    if (way.turns(limits)) return {Code::loop_singular, 0};
    return {changed_side(from, to) < 0 ? Code::ok : Code::singular_met, changed_side(from, to)};
  }

  double energy(const State& s) const { return (s.zd[0] * s.zd[0] + s.zd[1] * s.zd[1]) / 2 + gravity * s.z[1]; }
};

/// The bead on the curve y(x) alone, where x is a coordinate that never fails: zdd (1 + y'^2) = -(zd^2 y'' + g) y'.
struct OnCurve {
  struct State {
    double z[1], zd[1], x[1], t;
  };
  struct Derivative {
    double zdd[1], xd[1];
  };
  double gap, gravity;
  Status derivative(const State& s, Derivative& rates) const noexcept {
    const double sine = std::sin(s.z[0]), cosine = std::cos(s.z[0]);
    const double y = std::sqrt(sine * sine + gap);
    const double first = gap > 0 ? sine * cosine / y : cosine;
    const double second = gap > 0 ? (std::cos(2 * s.z[0]) - first * first) / y : -sine;
    rates.zdd[0] = -(s.zd[0] * s.zd[0] * second + gravity) * first / (1 + first * first);
    rates.xd[0] = 0;
    return {};
  }
  Status project(State&) const noexcept { return {}; }
  Status project_nearest(State&) const noexcept { return {}; }
};

struct Journey {
  Bead::State state;
  Status failure;
  int passed = 0, near = 0;
  double drift = 0;
};

enum class Scheme { rk4, abm4 };

/// For names of tests.
void PrintTo(Scheme method, std::ostream* out) { *out << (method == Scheme::rk4 ? "rk4" : "abm4"); }

Journey follow(const Bead& bead, Bead::State state, double duration, int steps, Scheme method = Scheme::rk4) {
  Journey journey{state, {}};
  AbmHistory<Bead> history{};
  const double h = duration / steps, energy = bead.energy(state);
  for (int i = 0; i < steps; ++i) {
    const Status status =
        method == Scheme::rk4 ? step_rk4(bead, journey.state, h) : step_abm4(bead, journey.state, history, h);
    if (!status.ok()) {
      journey.failure = status;
      return journey;
    }
    journey.passed += status.code == Code::singular_met ? 1 : 0;
    journey.near += status.code == Code::near_singular ? 1 : 0;
    journey.drift = std::max(journey.drift, std::abs(bead.energy(journey.state) - energy));
  }
  return journey;
}

double x_on_curve(const OnCurve& curve, double x, double xd, double duration) {
  OnCurve::State state{{x}, {xd}, {0}, 0};
  const int steps = 20000;
  for (int i = 0; i < steps; ++i) EXPECT_TRUE(step_rk4(curve, state, duration / steps).ok());
  return state.z[0];
}

Bead::State start_at(double x, double speed_x) { return {{x, std::sin(x)}, {speed_x, speed_x * std::cos(x)}, {0}, 0}; }

class SingularStep : public testing::TestWithParam<Scheme> {};

TEST_P(SingularStep, KeepsOrderFourThroughThreeCrossings) {
  const Bead bead{0, 1.5};
  const double exact = x_on_curve({0, 1.5}, -1, 2.5, 4);
  double previous = 0;
  for (const int refinement : {1, 2, 4}) {
    const Journey through = follow(bead, start_at(-1, 2.5), 4, 400 * refinement, GetParam());
    ASSERT_TRUE(through.failure.ok());
    EXPECT_GT(through.state.z[0], 2 * std::acos(-1.0));  // past 0, pi and 2 pi
    EXPECT_NEAR(through.state.z[1], std::sin(through.state.z[0]), 1e-12) << "the branch it came on";
    EXPECT_GE(through.passed, 3);
    const double error = std::abs(through.state.z[0] - exact);
    EXPECT_TRUE(refinement == 1 || previous / error > 12) << previous << " " << error;
    previous = error;
  }
  EXPECT_LT(previous, 1e-8);
}

TEST_P(SingularStep, LosesNoEnergyHoweverCloseStepsComeToIt) {
  for (const int steps : {100, 1000, 10000, 100000}) {
    const Journey through = follow({0, 0}, start_at(-0.4, 1), 1, steps, GetParam());
    ASSERT_TRUE(through.failure.ok()) << steps;
    EXPECT_GT(through.passed, 0) << steps;
    // Rounding over the third power of kNearSingular, and the order of the method.
    EXPECT_LT(through.drift, std::max(1e-10, std::pow(2.0 / steps, 4))) << steps;
  }
}

INSTANTIATE_TEST_SUITE_P(Methods, SingularStep, testing::Values(Scheme::rk4, Scheme::abm4),
                         testing::PrintToStringParamName());

TEST(Singular, VelocityTellsTheBranchOfAStartInTheCrossing) {
  for (const double side : {1.0, -1.0}) {
    const Journey through = follow({0, 0}, {{0, 0}, {1, side}, {0}, 0}, 0.5, 50);
    ASSERT_TRUE(through.failure.ok());
    EXPECT_NEAR(through.state.z[1], side * std::sin(through.state.z[0]), 1e-14);
    EXPECT_LT(through.drift, 1e-9);
  }
}

TEST(Singular, AStartAtRestInTheCrossingHasNoBranch) {
  const Journey stuck = follow({0, 1}, {{0, 0}, {0, 0}, {0}, 0}, 0.5, 50);
  EXPECT_EQ(stuck.failure.code, Code::loop_singular);
  EXPECT_EQ(stuck.failure.index, 0);
  EXPECT_EQ(stuck.state.t, 0);
}

TEST(Singular, ACrossingThatIsNoneIsNotCrossed) {
  // The upper curve turns within a hundredth, or a thousandth; the bead must turn with it, and not go on below.
  for (const auto& [gap, steps] : {std::pair{1e-4, 8000}, std::pair{1e-6, 80000}}) {
    const Bead bead{gap, 0};
    const double x = -0.4, y = std::sqrt(std::sin(x) * std::sin(x) + gap);
    const Bead::State start{{x, y}, {1, std::sin(x) * std::cos(x) / y}, {0}, 0};
    const Journey around = follow(bead, start, 0.8, steps);
    ASSERT_TRUE(around.failure.ok());
    EXPECT_EQ(around.passed, 0);
    EXPECT_GT(around.near, 0);
    EXPECT_GT(around.state.z[1], 0.3);
    EXPECT_NEAR(around.state.z[0], x_on_curve({gap, 0}, x, 1, 0.8), 1e-6) << gap;
  }
}

// Steps that would leap from the upper curve to the lower one, and those that turn with it.
TEST_P(SingularStep, CurvesThatComeCloseAreNotTakenForACrossing) {
  for (const double gap : {1e-6, 1e-8, 1e-10}) {
    const Bead bead{gap, 0};
    const double x = -0.4, y = std::sqrt(std::sin(x) * std::sin(x) + gap);
    const Bead::State start{{x, y}, {1, std::sin(x) * std::cos(x) / y}, {0}, 0};
    // Most of the long ones have no stage in the singular position, and only the side tells.
    for (const int steps : {8, 11, 20, 30, 80, 300, 1000}) {
      if (steps == 8 && GetParam() == Scheme::abm4) continue;  // 0.1 a step, and no stage between: none is near
      const Journey stopped = follow(bead, start, 0.8, steps, GetParam());
      EXPECT_EQ(stopped.failure.code, Code::loop_singular) << gap << " " << steps;
      EXPECT_NEAR(stopped.state.z[0], 0, std::max(0.02, 0.8 / steps)) << gap << " " << steps;
      EXPECT_GT(stopped.state.z[1], 0) << "on the branch it came on";
      EXPECT_EQ(stopped.passed, 0);
    }
  }
}

TEST_P(SingularStep, LongStepsPassACrossing) {
  for (const int steps : {8, 11, 20, 30, 80}) {
    const Journey through = follow({0, 0}, start_at(-0.4, 1), 0.8, steps, GetParam());
    ASSERT_TRUE(through.failure.ok()) << steps;
    EXPECT_GE(through.passed, steps == 8 && GetParam() == Scheme::abm4 ? 0 : 1) << steps;
    EXPECT_NEAR(through.state.z[1], std::sin(through.state.z[0]), 1e-9) << steps;
    EXPECT_GT(through.state.z[0], 0.1) << steps;
  }
}

TEST(Singular, RatesInMotionAreThoseOfTheBranch) {
  // At the crossing of y = sin(x): x'' = -g / 2, y'' = x'' cos(0).
  const Bead bead{0, 3};
  for (const double distance : {0.0, 1e-12, 1e-8, 1e-5, 1e-3}) {
    Bead::Derivative rates{};
    ASSERT_TRUE(rates_in_motion(bead, start_at(distance, 2), 1e-3, rates).ok()) << distance;
    EXPECT_NEAR(rates.zdd[0], -1.5, 1e-9 + 10 * distance) << distance;
    EXPECT_NEAR(rates.zdd[1], -1.5, 1e-9 + 10 * distance) << distance;
  }
}

}  // namespace
}  // namespace mbgen
