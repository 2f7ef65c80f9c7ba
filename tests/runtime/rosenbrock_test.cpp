// The linearly implicit integrator: order with any matrix, stability with the exact one, stiff problems.

#include "mbgen/solver/rosenbrock.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <functional>

namespace mbgen {
namespace {

/// zdd = force(z, zd, t) and xd = rate(x, z, t) with a matrix that the test chooses: derivatives of force and rate.
struct Mass {
  struct State {
    double z[1], zd[1], x[1], t;
  };
  struct Derivative {
    double zdd[1], xd[1];
  };
  /// (1 - g d - g^2 k) change of zd = g zdd + g^2 k zd.
  struct Tangents {
    double k, d, decay;
  };
  std::function<double(double z, double zd, double t)> force;
  std::function<double(double x, double z, double t)> rate;
  std::function<Tangents(const State&)> matrix;

  Status derivative(const State& s, Derivative& rates) const noexcept {
    rates.zdd[0] = force(s.z[0], s.zd[0], s.t);
    rates.xd[0] = rate(s.x[0], s.z[0], s.t);
    return {};
  }
  Status project(State&) const noexcept { return {}; }
  Status project_nearest(State&) const noexcept { return {}; }
  Status tangents(const State& s, double, Tangents& values) const noexcept {
    values = matrix(s);
    return {};
  }
  void solve(const Tangents& m, double g, const StateRates<Mass>& rates, Derivative& change) const noexcept {
    change.zdd[0] = (g * rates.derivative.zdd[0] + g * g * m.k * rates.zd[0]) / (1 - g * m.d - g * g * m.k);
    change.xd[0] = g / (1 - g * m.decay) * rates.derivative.xd[0];
  }
};

double no_rate(double, double, double) { return 0; }

Mass::State integrated(const Mass& mass, Mass::State state, double duration, int steps) {
  for (int i = 0; i < steps; ++i) EXPECT_TRUE(step_rosenbrock(mass, state, duration / steps).ok());
  return state;
}

/// zd' = eigenvalue zd for one step of 1 s from 1, or xd = eigenvalue x.
double damped(double eigenvalue, bool auxiliary) {
  const Mass mass{[=](double, double zd, double) { return eigenvalue * zd; },
                  [=](double x, double, double) { return eigenvalue * x; },
                  [=](const Mass::State&) {
                    return Mass::Tangents{0, eigenvalue, eigenvalue};
                  }};
  const Mass::State s = integrated(mass, {{0}, {1}, {1}, 0}, 1, 1);
  return auxiliary ? s.x[0] : s.zd[0];
}

/// Stability function at z: the only one of order three whose denominator is (1 - gamma z)^4 and that is zero at
/// infinity. Its numerator is the series of (1 - gamma z)^4 exp(z) up to z^3.
template <class T>
T stability(const T& z) {
  constexpr double c = kRosenbrockFactor;
  const T pole = 1.0 - c * z;
  const T numerator = 1.0 + (1 - 4 * c) * z + (0.5 - 4 * c + 6 * c * c) * z * z +
                      (1.0 / 6 - 2 * c + 6 * c * c - 4 * c * c * c) * z * z * z;
  return numerator / (pole * pole * pole * pole);
}

TEST(Rosenbrock, DampsTheWholeNegativeAxisAndForgetsTheStiffest) {
  for (const bool auxiliary : {false, true}) {
    for (double z = 1e-3; z < 1e9; z *= 1.3) {
      EXPECT_NEAR(damped(-z, auxiliary), stability(-z), 1e-12) << z;
      EXPECT_LT(std::abs(damped(-z, auxiliary)), 1) << z;
    }
    EXPECT_NEAR(damped(-1e9, auxiliary), 0, 1e-8);
    EXPECT_NEAR(damped(-1e6, auxiliary) / stability(-1e6), 1, 1e-6) << "towards zero as 1 / z";
    EXPECT_NEAR(damped(-0.01, auxiliary), std::exp(-0.01), 3e-10) << "of order three";
  }
}

/// Energy-like size of an undamped oscillator of angular frequency w after one step of 1 s from z = 1.
double oscillated(double w) {
  const Mass mass{[=](double z, double, double) { return -w * w * z; }, no_rate,
                  [=](const Mass::State&) {
                    return Mass::Tangents{-w * w, 0, 0};
                  }};
  const Mass::State s = integrated(mass, {{1}, {0}, {0}, 0}, 1, 1);
  return std::hypot(s.z[0], s.zd[0] / w);
}

TEST(Rosenbrock, NeverFeedsAnOscillatorAndForgetsTheStiffest) {
  for (double w = 1e-2; w < 1e6; w *= 1.3) {
    EXPECT_NEAR(oscillated(w), std::abs(stability(std::complex<double>(0, w))), 1e-10) << w;
    EXPECT_LE(oscillated(w), 1 + 1e-15) << w;
  }
  EXPECT_NEAR(oscillated(1e8), 0, 1e-6);
}

/// Errors of position and velocity, and of an auxiliary state that they drive.
struct Errors {
  double motion, auxiliary;
};

/// A Duffing oscillator with a force over time; a matrix that has nothing to do with it in place of its own.
Errors duffing_errors(const Mass::Tangents& matrix, int steps) {
  const Mass mass{[](double z, double zd, double t) { return -z - z * z * z - 0.3 * zd + std::cos(2 * t); },
                  [](double x, double z, double t) { return -x * z + std::sin(t); },
                  [=](const Mass::State&) { return matrix; }};
  const Mass::State start{{1}, {0.5}, {1}, 0};
  Mass::State reference = start;
  for (int i = 0; i < 4000; ++i) EXPECT_TRUE(step_rk4(mass, reference, 2.0 / 4000).ok());
  const Mass::State s = integrated(mass, start, 2, steps);
  return {std::abs(s.z[0] - reference.z[0]) + std::abs(s.zd[0] - reference.zd[0]), std::abs(s.x[0] - reference.x[0])};
}

TEST(Rosenbrock, IsOfOrderThreeWhateverTheMatrix) {
  for (const Mass::Tangents& matrix : {Mass::Tangents{}, Mass::Tangents{-4, -0.3, -1}, Mass::Tangents{-7, 2, 3}}) {
    const Errors coarse = duffing_errors(matrix, 200), fine = duffing_errors(matrix, 400);
    EXPECT_NEAR(std::log2(coarse.motion / fine.motion), 3, 0.15) << matrix.k;
    EXPECT_NEAR(std::log2(coarse.auxiliary / fine.auxiliary), 3, 0.15) << matrix.k;
  }
}

/// zd follows sin t by a damper of this rate, or an auxiliary state does by its own decay (A. Prothero, A. Robinson,
/// 1974). Error after 1 s.
double prothero_robinson(double rate, int steps, bool auxiliary) {
  const auto follow = [=](double y, double t) { return -rate * (y - std::sin(t)) + std::cos(t); };
  const Mass mass{[=](double, double zd, double t) { return follow(zd, t); },
                  [=](double x, double, double t) { return follow(x, t); },
                  [=](const Mass::State&) {
                    return Mass::Tangents{0, -rate, -rate};
                  }};
  const Mass::State s = integrated(mass, {{0}, {0}, {0}, 0}, 1, steps);
  return std::abs((auxiliary ? s.x[0] : s.zd[0]) - std::sin(1.0));
}

TEST(Rosenbrock, KeepsOrderTwoOnStiffProblemsWithoutDerivativesByTime) {
  for (const bool auxiliary : {false, true}) {
    for (const double rate : {1e2, 1e3, 1e4, 1e6}) {
      const double coarse = prothero_robinson(rate, 50, auxiliary), fine = prothero_robinson(rate, 100, auxiliary);
      EXPECT_GT(std::log2(coarse / fine), 1.9) << rate;
      EXPECT_LT(fine, 1e-6) << rate;
    }
  }
}

/// y on the slow branch of van der Pol's equation from y = 2, whatever the small parameter:
/// ln y - y^2 / 2 = t + ln 2 - 2.
double slow_van_der_pol(double t) {
  double y = 2;
  for (int i = 0; i < 50; ++i) y -= (std::log(y) - y * y / 2 - t - std::log(2.0) + 2) / (1 / y - y);
  return y;
}

TEST(Rosenbrock, FollowsVanDerPolWhereRungeKuttaDiverges) {
  // epsilon = 1e-6: E. Hairer, G. Wanner, Solving Ordinary Differential Equations II, 1996, section IV.10.
  constexpr double kStiffness = 1e6;
  const auto force = [=](double z, double zd, double) { return kStiffness * ((1 - z * z) * zd - z); };
  const Mass mass{
      force, no_rate, [=](const Mass::State& s) {
        return Mass::Tangents{kStiffness * (-2 * s.z[0] * s.zd[0] - 1), kStiffness * (1 - s.z[0] * s.z[0]), 0};
      }};
  const Mass::State start{{2}, {-0.66}, {0}, 0};
  EXPECT_NEAR(integrated(mass, start, 0.5, 500).z[0], slow_van_der_pol(0.5), 5e-6);
  Mass::State by_runge_kutta = start;
  Status status;
  for (int i = 0; i < 100 && status.ok(); ++i) status = step_rk4(mass, by_runge_kutta, 1e-3);
  EXPECT_EQ(status.code, Code::not_a_number);
}

TEST(Rosenbrock, RefusesAStepThatIsNone) {
  const Mass mass{[](double, double, double) { return 0.0; }, no_rate,
                  [](const Mass::State&) { return Mass::Tangents{}; }};
  Mass::State state{};
  for (const double h : {0.0, -1.0, std::nan("")}) EXPECT_EQ(step_rosenbrock(mass, state, h).code, Code::step_invalid);
}

}  // namespace
}  // namespace mbgen
