// Charts of balls: the same turn and the same motion in both, by differences and by composition.

#include "mbgen/charts.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace mbgen {
namespace {

using Numbers = double[3];

/// Largest difference of two turns, with their motions.
double difference(const ball_detail::Turn<double>& a, const ball_detail::Turn<double>& b) {
  double most = 0;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) most = std::max(most, std::abs(a.row[i][j] - b.row[i][j]));
    most = std::max({most, std::abs(a.velocity[i] - b.velocity[i]), std::abs(a.acceleration[i] - b.acceleration[i])});
  }
  return most;
}

ball_detail::Turn<double> turn_of(const Ball& ball, const Numbers& z, const Numbers& zd, const Numbers& zdd) {
  return ball_detail::turn_of(ball_detail::read<double>(ball, z, zd, zdd));
}

TEST(Charts, HaveTheRatesOfTheirAngles) {
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> uniform(-1, 1);
  constexpr double h = 1e-4;
  for (const int hand : {1, -1}) {
    const Ball ball{{0, 1, 2}, hand};
    for (int n = 0; n < 2000; ++n) {
      Numbers z, zd, zdd;
      for (int k = 0; k < 3; ++k)
        z[k] = 3 * uniform(generator), zd[k] = uniform(generator), zdd[k] = uniform(generator);
      z[1] *= 0.4;
      Numbers there[3];
      for (const int s : {-1, 0, 1}) {
        Numbers& at = there[s + 1];
        for (int k = 0; k < 3; ++k) at[k] = z[k] + s * h * zd[k] + s * s * h * h / 2 * zdd[k];
        change_chart<double>(ball, 1, at, nullptr, nullptr);
      }
      Numbers y = {z[0], z[1], z[2]}, yd = {zd[0], zd[1], zd[2]}, ydd = {zdd[0], zdd[1], zdd[2]};
      change_chart<double>(ball, 1, y, yd, ydd);
      if (std::abs(std::cos(y[1])) < 0.3) continue;
      for (int k = 0; k < 3; ++k) {
        if (std::abs(there[2][k] - there[0][k]) > 1) continue;  // beyond pi
        EXPECT_NEAR(yd[k], (there[2][k] - there[0][k]) / (2 * h), 1e-5);
        EXPECT_NEAR(ydd[k], (there[2][k] - 2 * there[1][k] + there[0][k]) / (h * h), 1e-4);
      }
      const auto before = turn_of(ball, z, zd, zdd);
      change_chart<double>(ball, 0, y, yd, ydd);
      EXPECT_LT(difference(turn_of(ball, y, yd, ydd), before), 1e-12);
    }
  }
}

TEST(Charts, TakeOverInThePole) {
  for (const double sign : {1.0, -1.0}) {
    const Ball ball{{0, 1, 2}, 1};
    Numbers z = {0.3, sign * 1.5707963267948966, 0.2}, zd = {1, 0.5, -0.25};
    const Numbers none = {};
    const auto before = turn_of(ball, z, zd, none);
    double chart = 0;
    EXPECT_TRUE(settle_balls(&ball, 1, &chart, z, zd));
    EXPECT_EQ(chart, 1);
    EXPECT_LT(std::abs(z[1]), 1e-15);
    EXPECT_FALSE(settle_balls(&ball, 1, &chart, z, zd));
    Numbers users = {z[0], z[1], z[2]}, rates = {zd[0], zd[1], zd[2]};
    to_users_angles<double>(&ball, 1, &chart, users, rates, nullptr);
    for (const double rate : rates) EXPECT_TRUE(std::isfinite(rate));
    const auto after = turn_of(ball, users, none, none);
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) EXPECT_NEAR(after.row[i][j], before.row[i][j], 1e-15);
  }
}

}  // namespace
}  // namespace mbgen
