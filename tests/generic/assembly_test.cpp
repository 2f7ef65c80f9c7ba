// Starts nearest to what is asked: a four-bar against its geometry searched point by point, other mechanisms against
// the conditions of a least sum of squares by differences of the residuals.

#include <fmt/format.h>

#include <Eigen/Dense>
#include <cmath>
#include <numbers>
#include <random>

#include "compiler/algebra/dense.hpp"
#include "tests/support/mechanism_support.hpp"
#include "tests/support/model_support.hpp"

namespace mbgen {
namespace {

using namespace mbgen::testing;

/// Pins at (0, 0) and (4, 0), crank 1.5, coupler 4, rocker 3, drawn with the crank upright; angles about y as the
/// joints count them, from there.
constexpr double kBase = 4, kCrank = 1.5, kCoupler = 4, kRocker = 3;

/// Angle of the rocker from the pin at (base, 0) to the tip, from x towards z, on the upper branch (branch 1) or the
/// lower one (-1); NaN where the linkage does not reach.
double rocker_direction(double crank_direction, int branch) {
  const double x = kCrank * std::cos(crank_direction) - kBase, z = kCrank * std::sin(crank_direction);
  const double diagonal = std::hypot(x, z);
  const double cosine = (diagonal * diagonal + kRocker * kRocker - kCoupler * kCoupler) / (2 * diagonal * kRocker);
  return std::atan2(z, x) - branch * std::acos(cosine);
}

std::string four_bar() {
  const double direction = rocker_direction(std::numbers::pi / 2, 1);
  const double x = kBase + kRocker * std::cos(direction), z = kRocker * std::sin(direction);
  return fmt::format(R"({{ "mbgen": 1,
    "bodies": {{
      "ground": {{ "points": {{ "A": [0, 0, 0], "D": [{0}, 0, 0] }} }},
      "crank": {{ "mass": 1, "inertia": [1, 1, 1], "points": {{ "A": [0, 0, 0], "B": [0, 0, {1}] }} }},
      "coupler": {{ "mass": 1, "inertia": [1, 1, 1], "points": {{ "B": [0, 0, {1}], "C": [{2}, 0, {3}] }} }},
      "rocker": {{ "mass": 1, "inertia": [1, 1, 1], "points": {{ "D": [{0}, 0, 0], "C": [{2}, 0, {3}] }} }}
    }},
    "joints": {{
      "crank": {{ "type": "revolute", "from": "ground.A", "to": "crank.A", "axis": "y" }},
      "coupler": {{ "type": "revolute", "from": "crank.B", "to": "coupler.B", "axis": "y" }},
      "rocker": {{ "type": "revolute", "from": "ground.D", "to": "rocker.D", "axis": "y" }},
      "tip": {{ "type": "revolute", "from": "coupler.C", "to": "rocker.C", "axis": "y", "cut": true }}
    }} }})",
                     kBase, kCrank, x, z);
}

double distance_of_angles(double a, double b) { return std::remainder(a - b, 2 * std::numbers::pi); }

/// The least of weight_crank (crank - asked)^2 + weight_rocker (rocker - asked)^2 over both branches, point by point.
double least_of_all(double crank, double weight_crank, double rocker, double weight_rocker) {
  const double reference = rocker_direction(std::numbers::pi / 2, 1);
  double least = INFINITY;
  constexpr int kPoints = 200000;
  for (int i = 0; i < kPoints; ++i) {
    const double z = (2.0 * i / kPoints - 1) * std::numbers::pi;
    for (const int branch : {1, -1}) {
      // A turn about y takes z towards x: directions in the plane fall as joint angles grow.
      const double there = reference - rocker_direction(std::numbers::pi / 2 - z, branch);
      const double off_crank = z - crank, off_rocker = distance_of_angles(there, rocker);
      const double sum = weight_crank * off_crank * off_crank + weight_rocker * off_rocker * off_rocker;
      if (sum < least) least = sum;
    }
  }
  return least;
}

class FourBar : public ::testing::Test {
 protected:
  FourBar() : m(mechanism_of(four_bar())), solver(m.model, m.topology, m.analysis) {}
  int coordinate(const char* name) const { return find_coordinate(m.topology, name); }
  double largest_residual(const GenericState& state) const {
    return largest_absolute(solver.position_residuals(state));
  }

  Mechanism m;
  GenericSolver solver;
};

TEST_F(FourBar, MovesNoMoreThanItMust) {
  const double targets[][4] = {{0.3, 1, 0.4, 1},   {0.3, 1, 0.4, 50},   {0.3, 50, 0.4, 1},  {-0.5, 1, 0.6, 1},
                               {1.0, 2, -0.3, 1},  {0.8, 1, 0.9, 10},   {-1.2, 1, -0.2, 3}, {0.2, 1, -2.4, 20},
                               {-0.4, 1e-3, 3, 1}, {0.05, 1, 0.02, 1e3}};
  for (const auto& [crank, weight_crank, rocker, weight_rocker] : targets) {
    GenericState state = reference_state(m);
    ASSERT_TRUE(solver
                    .assemble(state, {{coordinate("crank"), crank, weight_crank, false},
                                      {coordinate("rocker"), rocker, weight_rocker, false}})
                    .ok());
    EXPECT_LT(largest_residual(state), 1e-9);
    const double off_crank = state.z[coordinate("crank")] - crank, off_rocker = state.z[coordinate("rocker")] - rocker;
    const double found = weight_crank * off_crank * off_crank + weight_rocker * off_rocker * off_rocker;
    const double least = least_of_all(crank, weight_crank, rocker, weight_rocker);
    // The search has points 3e-5 rad apart.
    EXPECT_LT(found, least * (1 + 1e-6) + 1e-9) << crank << " " << rocker;
    EXPECT_GT(found, least * (1 - 1e-3) - 1e-9 * std::max(weight_crank, weight_rocker)) << crank << " " << rocker;
  }
}

TEST_F(FourBar, ALockIsKept) {
  GenericState state = reference_state(m);
  ASSERT_TRUE(
      solver.assemble(state, {{coordinate("crank"), 0.7, 1, true}, {coordinate("rocker"), -0.9, 1, false}}).ok());
  EXPECT_NEAR(state.z[coordinate("crank")], 0.7, 1e-12);
  const double reference = rocker_direction(std::numbers::pi / 2, 1);
  EXPECT_NEAR(state.z[coordinate("rocker")], reference - rocker_direction(std::numbers::pi / 2 - 0.7, 1), 1e-9);
}

TEST_F(FourBar, WhatCannotCloseIsOpenedAsLittleAsCanBe) {
  GenericState state = reference_state(m);
  const double crank = 0.7, rocker = -1.1;
  const Status status =
      solver.assemble(state, {{coordinate("crank"), crank, 1, true}, {coordinate("rocker"), rocker, 1, true}});
  EXPECT_EQ(status.code, Code::loop_not_closed);
  EXPECT_EQ(status.index, 0);
  EXPECT_DOUBLE_EQ(state.z[coordinate("crank")], crank);
  EXPECT_DOUBLE_EQ(state.z[coordinate("rocker")], rocker);
  // The coupler points from the crank's end to the rocker's: what its length lacks is the gap.
  const double a = std::numbers::pi / 2 - crank, d = rocker_direction(std::numbers::pi / 2, 1) - rocker;
  const double between =
      std::hypot(kBase + kRocker * std::cos(d) - kCrank * std::cos(a), kRocker * std::sin(d) - kCrank * std::sin(a));
  const std::vector<double> residuals = solver.position_residuals(state);
  EXPECT_NEAR(std::hypot(residuals[0], residuals[1], residuals[2]), std::abs(between - kCoupler), 1e-9);
}

TEST_F(FourBar, VelocitiesAreTheNearestAlongTheOnlyFreedom) {
  GenericState state = reference_state(m);
  const int crank = coordinate("crank"), rocker = coordinate("rocker");
  ASSERT_TRUE(solver.assemble_velocities(state, {{crank, 3, 4, false}, {rocker, 5, 1, false}}).ok());
  const double step = 1e-6, half = std::numbers::pi / 2;
  const double ratio = (rocker_direction(half + step, 1) - rocker_direction(half - step, 1)) / (2 * step);
  const double rate = (4 * 3 + ratio * 5) / (4 + ratio * ratio);
  EXPECT_NEAR(state.zd[crank], rate, 1e-7);
  EXPECT_NEAR(state.zd[rocker], ratio * rate, 1e-7);
  EXPECT_LT(largest_absolute(solver.velocity_residuals(state)), 1e-12);

  EXPECT_EQ(solver.assemble_velocities(state, {{crank, 3, 1, true}, {rocker, 5, 1, true}}).code, Code::loop_not_closed);
}

/// d residual / d z by central differences.
Eigen::MatrixXd jacobian_by_differences(const GenericSolver& solver, const GenericState& state) {
  Eigen::MatrixXd jacobian;
  for (std::size_t i = 0; i < state.z.size(); ++i) {
    constexpr double kStep = 1e-6;
    GenericState ahead = state, behind = state;
    ahead.z[i] += kStep;
    behind.z[i] -= kStep;
    const std::vector<double> a = solver.position_residuals(ahead), b = solver.position_residuals(behind);
    jacobian.conservativeResize(static_cast<Eigen::Index>(a.size()), static_cast<Eigen::Index>(state.z.size()));
    for (std::size_t e = 0; e < a.size(); ++e)
      jacobian(static_cast<Eigen::Index>(e), static_cast<Eigen::Index>(i)) = (a[e] - b[e]) / (2 * kStep);
  }
  return jacobian;
}

class EveryClosedModel : public ::testing::TestWithParam<std::string> {};

/// At the least sum of squares its gradient is a combination of the closures' rows.
TEST_P(EveryClosedModel, IsNearestToWhatIsAsked) {
  const Mechanism m = load(GetParam());
  const GenericSolver solver(m.model, m.topology, m.analysis);
  GenericState state = reference_state(m);
  ASSERT_TRUE(solver.project(state).ok());
  std::mt19937 random(7);
  std::uniform_real_distribution<double> off(-0.02, 0.02), weight(0.2, 5);
  std::vector<CoordinateTarget> targets;
  for (int i = 0; i < m.topology.size(); ++i)
    if (!m.analysis.driven[i]) targets.push_back({i, state.z[i] + off(random), weight(random), false});
  ASSERT_TRUE(solver.assemble(state, targets).ok());
  EXPECT_LT(largest_absolute(solver.position_residuals(state)), 1e-9);

  const Eigen::MatrixXd all = jacobian_by_differences(solver, state);
  Eigen::MatrixXd movable(all.rows(), static_cast<Eigen::Index>(targets.size()));
  Eigen::VectorXd gradient(static_cast<Eigen::Index>(targets.size()));
  for (std::size_t w = 0; w < targets.size(); ++w) {
    const auto column = static_cast<Eigen::Index>(w);
    movable.col(column) = all.col(targets[w].coordinate);
    gradient[column] = targets[w].weight * (state.z[targets[w].coordinate] - targets[w].value);
  }
  const Eigen::VectorXd multipliers = least_squares(movable.transpose(), gradient, 1e-12);
  const double along_the_closures = (gradient - movable.transpose() * multipliers).lpNorm<Eigen::Infinity>();
  // Where only velocities are held every target is met.
  if (m.analysis.position_freedoms < m.topology.size()) {
    EXPECT_GT(gradient.norm(), 1e-4);
  }
  EXPECT_LT(along_the_closures, 1e-6);
}

INSTANTIATE_TEST_SUITE_P(Models, EveryClosedModel, ::testing::ValuesIn(models_with_loops()), test_name);

}  // namespace
}  // namespace mbgen
