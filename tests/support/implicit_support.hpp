#pragma once
// Mechanisms as implicit steps see them: the matrix that a step works with, and that of differences.

#include <Eigen/Core>
#include <vector>

#include "compiler/algebra/dense.hpp"
#include "mbgen/solver/rosenbrock.hpp"
#include "tests/support/dynamics.hpp"
#include "tests/support/mechanism_support.hpp"

namespace mbgen::testing {

/// A mechanism with its free coordinates.
struct Free {
  Mechanism m;
  GenericSolver solver{m.model, m.topology, m.analysis};
  std::vector<int> coordinates = free_coordinates(m.topology, m.analysis);

  Eigen::Index half() const { return static_cast<Eigen::Index>(coordinates.size()); }

  /// Velocities of the free coordinates as targets that are met.
  std::vector<CoordinateTarget> locked(const Eigen::VectorXd& velocities) const {
    std::vector<CoordinateTarget> targets;
    for (Eigen::Index i = 0; i < half(); ++i) targets.push_back({coordinates[i], velocities[i], 1, true});
    return targets;
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
    const Eigen::MatrixXd identity = Eigen::MatrixXd::Identity(size, size);
    return identity / kG - solved(changes, identity);
  }
};

inline double largest_difference(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  return (a - b).cwiseAbs().maxCoeff() / b.cwiseAbs().maxCoeff();
}

/// Positions after so many steps; charts of balls as they are.
inline std::vector<double> positions_after(const Free& at, GenericState state, double duration, int steps,
                                           bool implicit) {
  const Dynamics dynamics{at.solver};
  for (int i = 0; i < steps; ++i) {
    const Status status =
        implicit ? step_rosenbrock(dynamics, state, duration / steps) : step_rk4(dynamics, state, duration / steps);
    if (!status.ok()) return {};
  }
  return state.z;
}

inline double distance_of(const std::vector<double>& a, const std::vector<double>& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

}  // namespace mbgen::testing
