// The integrators: order of convergence on problems with closed solutions, start-up, failures.

#include "mbgen/integrators.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace mbgen {
namespace {

/// zdd = -z, xd = -x cos t: an oscillator beside an auxiliary state that depends on time.
struct Oscillator {
  struct State {
    double z[1], zd[1], x[1], t;
  };
  struct Derivative {
    double zdd[1], xd[1];
  };
  Status derivative(const State& state, Derivative& rates) const noexcept {
    rates.zdd[0] = -state.z[0];
    rates.xd[0] = -std::cos(state.t) * state.x[0];
    return {};
  }
  Status project(State&) const noexcept { return {}; }
  Status project_nearest(State&) const noexcept { return {}; }

  static State start() { return {{1}, {0.5}, {1}, 0}; }
  /// z = cos t + sin t / 2, x = exp(-sin t).
  static double error(const State& s) {
    const double z = std::cos(s.t) + 0.5 * std::sin(s.t), zd = -std::sin(s.t) + 0.5 * std::cos(s.t);
    return std::abs(s.z[0] - z) + std::abs(s.zd[0] - zd) + std::abs(s.x[0] - std::exp(-std::sin(s.t)));
  }
};

/// A pendulum in Cartesian coordinates with containers, closed and made consistent by the projection: the second
/// coordinate depends on the first by the rod, as the generic runtime's states do. g = l = 1.
struct CartesianPendulum {
  struct State {
    std::vector<double> z, zd, x;
    double t;
  };
  struct Derivative {
    std::vector<double> zdd, xd;
  };
  Status derivative(const State& s, Derivative& rates) const noexcept {
    const double speed = s.zd[0] * s.zd[0] + s.zd[1] * s.zd[1], square = s.z[0] * s.z[0] + s.z[1] * s.z[1];
    const double tension = (speed - s.z[1]) / square;
    rates.zdd.assign({-tension * s.z[0], -tension * s.z[1] - 1});
    rates.xd.clear();
    return {};
  }
  Status project(State& s) const noexcept {
    if (std::abs(s.z[0]) >= 1) return {Code::loop_not_closed, 0};
    s.z[1] = -std::sqrt(1 - s.z[0] * s.z[0]);
    s.zd[1] = -s.z[0] * s.zd[0] / s.z[1];
    return {};
  }
  Status project_nearest(State& s) const noexcept { return project(s); }
  /// Released from 60 degrees.
  static State start() { return {{std::sqrt(0.75), -0.5}, {0, 0}, {}, 0}; }
};

/// Quarter period of a pendulum released from an angle: K(sin(angle/2)) by the arithmetic-geometric mean.
double quarter_period(double angle) {
  double a = 1, b = std::cos(angle / 2);
  for (int i = 0; i < 8; ++i) {
    const double mean = (a + b) / 2;
    b = std::sqrt(a * b);
    a = mean;
  }
  return std::acos(-1.0) / (2 * a);
}

enum class Method { rk4, abm4 };

/// For names of tests.
void PrintTo(Method method, std::ostream* out) { *out << (method == Method::rk4 ? "rk4" : "abm4"); }

template <class System>
typename System::State integrate(Method method, double duration, int steps) {
  const System system;
  typename System::State state = System::start();
  AbmHistory<System> history{};
  const double h = duration / steps;
  for (int i = 0; i < steps; ++i) {
    const Status status = method == Method::rk4 ? step_rk4(system, state, h) : step_abm4(system, state, history, h);
    EXPECT_TRUE(status.ok());
  }
  return state;
}

double observed_order(double coarse, double fine) { return std::log2(coarse / fine); }

class Order : public testing::TestWithParam<Method> {};

TEST_P(Order, IsFourOnAnOscillatorWithAnAuxiliaryState) {
  const double coarse = Oscillator::error(integrate<Oscillator>(GetParam(), 5, 1000));
  const double fine = Oscillator::error(integrate<Oscillator>(GetParam(), 5, 2000));
  EXPECT_NEAR(observed_order(coarse, fine), 4.0, 0.1) << coarse << " " << fine;
  EXPECT_LT(fine, 1e-10);
}

TEST_P(Order, IsFourOnAProjectedPendulum) {
  // After a whole quarter period the pendulum hangs: z = (0, -1), |zd| = sqrt(2 (1 - cos 60 deg)) = 1.
  const double quarter = quarter_period(std::acos(-1.0) / 3);
  const auto error = [&](int steps) {
    const CartesianPendulum::State s = integrate<CartesianPendulum>(GetParam(), quarter, steps);
    EXPECT_NEAR(s.z[0] * s.z[0] + s.z[1] * s.z[1], 1, 1e-15);
    EXPECT_NEAR(s.z[0] * s.zd[0] + s.z[1] * s.zd[1], 0, 1e-15);
    return std::abs(s.z[0]) + std::abs(s.zd[0] + 1);
  };
  const double coarse = error(400), fine = error(800);
  EXPECT_NEAR(observed_order(coarse, fine), 4.0, 0.1) << coarse << " " << fine;
  EXPECT_LT(fine, 1e-10);
}

INSTANTIATE_TEST_SUITE_P(Methods, Order, testing::Values(Method::rk4, Method::abm4), testing::PrintToStringParamName());

TEST(StepRk4, IsTheTaylorSeriesOfTheOscillatorToFourthOrder) {
  const Oscillator system;
  Oscillator::State state = Oscillator::start();
  const double h = 0.25;
  ASSERT_TRUE(step_rk4(system, state, h).ok());
  const double cosine = 1 - h * h / 2 + h * h * h * h / 24, sine = h - h * h * h / 6;
  EXPECT_NEAR(state.z[0], cosine + 0.5 * sine, 1e-15);
  EXPECT_NEAR(state.zd[0], 0.5 * cosine - sine, 1e-15);
  EXPECT_EQ(state.t, h);
}

/// Counts evaluations, and fails on demand.
struct Fallible : Oscillator {
  mutable int evaluations = 0;
  int failing_evaluation = -1;
  bool projection_fails = false;
  Status derivative(const State& state, Derivative& rates) const noexcept {
    if (evaluations++ == failing_evaluation) return {Code::no_inertia, 7};
    return Oscillator::derivative(state, rates);
  }
  Status project(State& state) const noexcept {
    state.z[0] += projection_fails ? 1 : 0;
    return projection_fails ? Status{Code::loop_not_closed, 3} : Status{};
  }
  Status project_nearest(State& state) const noexcept { return project(state); }
};

bool same(const Oscillator::State& a, const Oscillator::State& b) {
  return a.z[0] == b.z[0] && a.zd[0] == b.zd[0] && a.x[0] == b.x[0] && a.t == b.t;
}

TEST(StepAbm4, NeedsTwoEvaluationsAStepOnceItRuns) {
  const Fallible system;
  Oscillator::State state = Oscillator::start();
  AbmHistory<Fallible> history{};
  for (int i = 0; i < 3; ++i) ASSERT_TRUE(step_abm4(system, state, history, 0.01).ok());
  EXPECT_EQ(history.count, 4);
  EXPECT_EQ(system.evaluations, 1 + 3 * 4);
  for (int i = 0; i < 10; ++i) ASSERT_TRUE(step_abm4(system, state, history, 0.01).ok());
  EXPECT_EQ(system.evaluations, 13 + 20);
}

TEST(StepAbm4, StartsAnewWhenTheStepOrTheTimeChanges) {
  const Oscillator system;
  Oscillator::State state = Oscillator::start();
  AbmHistory<Oscillator> history{};
  for (int i = 0; i < 6; ++i) ASSERT_TRUE(step_abm4(system, state, history, 0.01).ok());
  Oscillator::State by_rk4 = state;
  ASSERT_TRUE(step_abm4(system, state, history, 0.02).ok());
  ASSERT_TRUE(step_rk4(system, by_rk4, 0.02).ok());
  EXPECT_TRUE(same(state, by_rk4));
  EXPECT_EQ(history.count, 2);
  state.t = by_rk4.t = 0;
  ASSERT_TRUE(step_abm4(system, state, history, 0.02).ok());
  ASSERT_TRUE(step_rk4(system, by_rk4, 0.02).ok());
  EXPECT_TRUE(same(state, by_rk4));
  EXPECT_EQ(history.count, 2);
}

TEST(Steps, LeaveStateAndHistoryUntouchedWhenAnythingFails) {
  for (int before : {0, 2, 5}) {
    for (int failing = 0; failing < 6; ++failing) {
      Fallible system;
      Oscillator::State state = Oscillator::start();
      AbmHistory<Fallible> history{};
      for (int i = 0; i < before; ++i) ASSERT_TRUE(step_abm4(system, state, history, 0.01).ok());
      const Oscillator::State kept = state;
      const int count = history.count;
      system.evaluations = 0;
      system.failing_evaluation = failing;
      const Status status = step_abm4(system, state, history, 0.01);
      const int needed = before == 0 ? 5 : before == 2 ? 4 : 2;
      EXPECT_EQ(status.ok(), failing >= needed) << before << " " << failing;
      if (status.ok()) continue;
      EXPECT_EQ(status.code, Code::no_inertia);
      EXPECT_EQ(status.index, 7);
      EXPECT_TRUE(same(state, kept));
      EXPECT_EQ(history.count, count);
      system.evaluations = 0;
      EXPECT_EQ(step_rk4(system, state, 0.01).ok(), failing >= 4);
    }
  }
  Fallible system;
  system.projection_fails = true;
  Oscillator::State state = Oscillator::start();
  AbmHistory<Fallible> history{};
  EXPECT_EQ(step_rk4(system, state, 0.01).code, Code::loop_not_closed);
  EXPECT_EQ(step_abm4(system, state, history, 0.01).index, 3);
  EXPECT_TRUE(same(state, Oscillator::start()));
}

TEST(Steps, RefuseAStepThatIsNotPositiveAndFinite) {
  const Oscillator system;
  Oscillator::State state = Oscillator::start();
  AbmHistory<Oscillator> history{};
  using Limits = std::numeric_limits<double>;
  for (const double h : {0.0, -0.01, Limits::quiet_NaN(), Limits::infinity()}) {
    EXPECT_EQ(step_rk4(system, state, h).code, Code::step_invalid);
    EXPECT_EQ(step_abm4(system, state, history, h).code, Code::step_invalid);
  }
  EXPECT_TRUE(same(state, Oscillator::start()));
}

TEST(Steps, ReportAResultThatOverflows) {
  const Oscillator system;
  Oscillator::State state = Oscillator::start();
  state.zd[0] = 1e308;
  EXPECT_EQ(step_rk4(system, state, 100.0).code, Code::not_a_number);
  EXPECT_EQ(state.zd[0], 1e308);
}

}  // namespace
}  // namespace mbgen
