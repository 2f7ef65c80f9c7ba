// The linearly implicit integrator on mechanisms: its matrix against differences of the accelerations, orders, stiff
// problems.

#include <Eigen/Dense>
#include <cstdio>

#include "mbgen/rosenbrock.hpp"
#include "tests/support/dynamics.hpp"
#include "tests/support/mechanism_support.hpp"

namespace mbgen {
namespace {

using namespace mbgen::testing;

/// A mechanism with its free coordinates.
struct Free {
  Mechanism m;
  GenericSolver solver{m.model, m.topology, m.analysis};
  std::vector<int> coordinates = free_coordinates(m.topology, m.analysis);

  Eigen::Index half() const { return static_cast<Eigen::Index>(coordinates.size()); }

  /// Velocities of the free coordinates as wishes that are met.
  std::vector<CoordinateWish> locked(const Eigen::VectorXd& velocities) const {
    std::vector<CoordinateWish> wishes;
    for (Eigen::Index i = 0; i < half(); ++i) wishes.push_back({coordinates[i], velocities[i], 1, true});
    return wishes;
  }
  /// The state with its free positions, velocities and auxiliary states moved, closed.
  GenericState moved(GenericState state, const Eigen::VectorXd& by) const {
    Eigen::VectorXd velocities(half());
    for (Eigen::Index i = 0; i < half(); ++i) velocities[i] = state.zd[coordinates[i]] + by[half() + i];
    GenericState along = state;  // its velocities are the change of positions
    EXPECT_TRUE(solver.assemble_velocities(along, locked(by.head(half()))).ok());
    for (std::size_t i = 0; i < state.z.size(); ++i) state.z[i] += m.analysis.driven[i] ? 0 : along.zd[i];
    for (std::size_t s = 0; s < state.x.size(); ++s) state.x[s] += by[2 * half() + static_cast<Eigen::Index>(s)];
    EXPECT_TRUE(solver.project(state).ok());
    EXPECT_TRUE(solver.assemble_velocities(state, locked(velocities)).ok());
    return state;
  }
  Eigen::VectorXd values(const std::vector<double>& z, const std::vector<double>& zd,
                         const std::vector<double>& x) const {
    Eigen::VectorXd result(2 * half() + static_cast<Eigen::Index>(x.size()));
    for (Eigen::Index i = 0; i < half(); ++i) {
      result[i] = z[coordinates[i]];
      result[half() + i] = zd[coordinates[i]];
    }
    for (std::size_t s = 0; s < x.size(); ++s) result[2 * half() + static_cast<Eigen::Index>(s)] = x[s];
    return result;
  }
  Eigen::VectorXd rates(const GenericState& state) const {
    GenericDerivative derivative;
    EXPECT_TRUE(solver.accelerations(state, std::vector<double>(state.z.size(), 0.0), derivative).ok());
    return values(state.zd, derivative.zdd, derivative.xd);
  }

  /// Derivatives of the rates of all free states by central differences.
  Eigen::MatrixXd differences(const GenericState& state) const {
    const Eigen::Index size = 2 * half() + static_cast<Eigen::Index>(state.x.size());
    Eigen::MatrixXd result(size, size);
    constexpr double kBy = 1e-6;
    for (Eigen::Index j = 0; j < size; ++j) {
      const Eigen::VectorXd by = kBy * Eigen::VectorXd::Unit(size, j);
      result.col(j) = (rates(moved(state, by)) - rates(moved(state, -by))) / (2 * kBy);
    }
    return result;
  }

  /// The matrix that an implicit step works with: A of (1 / g - A) change = rates, from changes for unit rates.
  Eigen::MatrixXd matrix(const GenericState& state) const {
    constexpr double kG = 1e-2;
    GenericTangents tangents;
    EXPECT_TRUE(solver.tangents(state, kG, tangents).ok());
    EXPECT_NE(tangents.equations, nullptr);
    const Eigen::Index size = 2 * half() + static_cast<Eigen::Index>(state.x.size());
    Eigen::MatrixXd changes(size, size);
    for (Eigen::Index j = 0; j < size; ++j) {
      std::vector<double> zd(state.z.size(), 0.0);
      GenericDerivative unit{zd, std::vector<double>(state.x.size(), 0.0)};
      if (j < half())
        zd[coordinates[j]] = 1;
      else if (j < 2 * half())
        unit.zdd[coordinates[j - half()]] = 1;
      else
        unit.xd[j - 2 * half()] = 1;
      const GenericDerivative change = solver.changes(tangents, kG, zd, unit);
      for (std::size_t i = 0; i < zd.size(); ++i) zd[i] = kG * (zd[i] + change.zdd[i]);
      changes.col(j) = values(zd, change.zdd, change.xd);
    }
    return Eigen::MatrixXd::Identity(size, size) / kG - changes.inverse();
  }
};

/// A loop of bars with springs of every kind at rest, where no force changes its direction. All laws are stiff.
constexpr const char* kSprung = R"json({ "mbgen": 1, "name": "sprung", "gravity": [0, 0, 0],
  "bodies": {
    "ground": { "points": { "a": [0, 0, 0], "d": [0.9, 0, 0], "anchor": [0.3, 0, 0.9] } },
    "crank": { "mass": 1, "com": [0, 0, 0.2], "inertia": [0.02, 0.02, 0.001],
      "points": { "a": [0, 0, 0], "b": [0, 0, 0.4], "tip": [0.1, 0.02, 0.5] } },
    "coupler": { "mass": 2, "com": [0.4, 0, 0.5], "inertia": [0.01, 0.1, 0.1],
      "points": { "b": [0, 0, 0.4], "c": [0.8, 0, 0.6], "rider": [0.5, 0, 0.7] } },
    "rocker": { "mass": 1.5, "com": [0.85, 0, 0.3], "inertia": [0.05, 0.05, 0.001],
      "points": { "c": [0.8, 0, 0.6], "d": [0.9, 0, 0] } },
    "rider": { "mass": 0.5, "com": [0.5, 0, 0.7], "inertia": [0.001, 0.001, 0.001],
      "points": { "pin": [0.5, 0, 0.7], "end": [0.6, 0, 0.9] } }
  },
  "joints": {
    "a": { "type": "revolute", "from": "ground.a", "to": "crank.a", "axis": "y" },
    "b": { "type": "revolute", "from": "crank.b", "to": "coupler.b", "axis": "y" },
    "c": { "type": "revolute", "from": "coupler.c", "to": "rocker.c", "axis": "y" },
    "d": { "type": "revolute", "from": "ground.d", "to": "rocker.d", "axis": "y" },
    "rider": { "type": "revolute", "from": "coupler.rider", "to": "rider.pin", "axis": "y" }
  },
  "springs": {
    "across": { "from": "crank.tip", "to": "rider.end", "stiffness": 3e5, "damping": 2e3 },
    "table": { "from": "ground.anchor", "to": "coupler.rider",
      "stiffness": { "table": [[-0.1, -4e4], [-0.01, -2e3], [0.01, 2e3], [0.1, 9e4]] } },
    "law": { "from": "ground.anchor", "to": "crank.tip", 
      "force": "1e3*sin(100*(length - 0.44766058571198786)) + 50*tanh(rate)" }
  },
  "joint_springs": {
    "rider": { "joint": "rider", "relative_to": "a", "stiffness": 5e4, "damping": 30, "force": "1e3*position^3" }
  },
  "frictions": { "d": { "joint": "d", "coulomb": 40, "stiction": 60, "viscous": 3, "velocity": 0.01 } },
  "joint_forces": { "controller": { "joint": "a", "force": "-4e4*z.rider - 100*zd.d" } }
})json";

double largest_difference(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  return (a - b).cwiseAbs().maxCoeff() / b.cwiseAbs().maxCoeff();
}

TEST(Implicit, MatrixIsThatOfTheMechanismWhereNoForceTurns) {
  const Free sprung{mechanism_of(kSprung)};
  const GenericState state = reference_state(sprung.m);
  ASSERT_LT(sprung.rates(state).cwiseAbs().maxCoeff(), 1e-6);
  EXPECT_LT(largest_difference(sprung.matrix(state), sprung.differences(state)), 1e-7);
}

// Forces by load are left out, and the drag of the tyre on its hub.
TEST(Implicit, MatrixHasWhatIsStiffInATyre) {
  const Free wheel{load("models/pulled_wheel.json")};
  GenericState state = reference_state(wheel.m);
  state.zd[find_coordinate(wheel.m.topology, "pull")] = 15;
  state.zd[find_coordinate(wheel.m.topology, "wheel")] = 47;
  state.x = {0.004, 0.002};
  state = wheel.moved(state, Eigen::VectorXd::Zero(2 * wheel.half() + 2));
  const Eigen::MatrixXd own = wheel.matrix(state), whole = wheel.differences(state);
  EXPECT_LT(largest_difference(own.rightCols(2), whole.rightCols(2)), 1e-6) << "by the deflection states";
  EXPECT_LT(largest_difference(own.bottomRows(2).middleCols(2, 2), whole.bottomRows(2).middleCols(2, 2)), 0.01);
  EXPECT_NEAR(own(2, 0) / whole(2, 0), 1, 0.01) << "vertical";
}

/// Positions after so many steps; charts of balls as they are.
std::vector<double> positions_after(const Free& at, GenericState state, double duration, int steps, bool implicit) {
  const Dynamics dynamics{at.solver};
  for (int i = 0; i < steps; ++i) {
    const Status status =
        implicit ? step_rosenbrock(dynamics, state, duration / steps) : step_rk4(dynamics, state, duration / steps);
    if (!status.ok()) return {};
  }
  return state.z;
}

double distance_of(const std::vector<double>& a, const std::vector<double>& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

// The fastest eigenvalue of the governor is -8117 1/s: beyond Runge-Kutta's region at steps above 3.4e-4 s.
TEST(Implicit, FlyballGovernorAtAMillisecond) {
  const Free governor{load("models/iftomm/a05_flyball_governor.json")};
  GenericState start = reference_state(governor.m);
  start.zd[find_coordinate(governor.m.topology, "shaft")] = 2 * std::acos(-1.0);
  constexpr double kDuration = 0.2;
  const std::vector<double> exact = positions_after(governor, start, kDuration, 2000, false);
  ASSERT_FALSE(exact.empty());
  const double coarse = distance_of(positions_after(governor, start, kDuration, 200, true), exact),
               fine = distance_of(positions_after(governor, start, kDuration, 400, true), exact);
  std::printf("flyball governor: errors %.2e, %.2e rad at 1 ms and 0.5 ms\n", coarse, fine);
  EXPECT_LT(coarse, 1e-6);
  EXPECT_GT(coarse / fine, 3.5);
  const std::vector<double> diverged = positions_after(governor, start, kDuration, 200, false);
  EXPECT_TRUE(diverged.empty() || !(distance_of(diverged, exact) < 1));
}

// Loops, closed by projection: of order three against the published solution's reference.
TEST(Implicit, AndrewsMechanismWithOrderThree) {
  const Free andrews{load("models/andrews_squeezer.json")};
  const GenericState start = reference_state(andrews.m);
  const std::vector<double> exact = positions_after(andrews, start, 0.005, 800, false);
  const double coarse = distance_of(positions_after(andrews, start, 0.005, 100, true), exact),
               fine = distance_of(positions_after(andrews, start, 0.005, 200, true), exact);
  std::printf("Andrews at 0.005 s: errors %.2e, %.2e rad at 100, 200 steps, ratio %.2f\n", coarse, fine, coarse / fine);
  EXPECT_GT(coarse / fine, 6);
  EXPECT_LT(fine, 1e-5);
}

}  // namespace
}  // namespace mbgen
