#include "runtime/generic/balance.hpp"

#include <algorithm>
#include <limits>

#include "compiler/model/auxiliary_states.hpp"
#include "runtime/generic/rest_forces.hpp"

namespace mbgen {
namespace {

constexpr double kDifference = 1e-6;  // rad or m, for the stiffness by central differences

/// Forces without inertias.
Balance balance_of(const GenericEquations& equations, const RestForces<double>& rest) {
  const std::vector<double>& q = rest.tree;
  Balance b;
  b.rz = dense_rz(equations.topology, rest.directions);
  const std::vector<double>& magnitudes = equations.magnitudes;
  const auto first = static_cast<std::size_t>(slip_state_count(equations.model));
  const Eigen::Index states =
      auxiliary_state_count(equations.model) - held_state_count(equations.model) - static_cast<Eigen::Index>(first);
  b.force.resize(b.rz.cols() + states);
  b.force.head(b.rz.cols()) =
      b.rz.transpose() * Eigen::Map<const Eigen::VectorXd>(q.data(), static_cast<Eigen::Index>(q.size()));
  for (std::size_t i = 0; i < static_cast<std::size_t>(states); ++i)
    b.force[b.rz.cols() + static_cast<Eigen::Index>(i)] = rest.applied.xd[first + i] / magnitudes[first + i];
  return b;
}

Eigen::VectorXd forces_at(GenericEquations& equations, const GenericState& state) {
  return balance_of(equations, rest_forces(equations.system(state), equations.analysis)).force;
}

}  // namespace

Balance balance(GenericEquations& equations, const GenericState& state) {
  System<double>& system = equations.system(state);
  const RestForces<double> rest = rest_forces(system, equations.analysis);
  Balance b = balance_of(equations, rest);
  tree_mass_matrix(system, rest.kinematics, rest.inertias, equations.mass);
  Eigen::MatrixXd mass = Eigen::MatrixXd::Zero(b.rz.rows(), b.rz.rows());
  spread(equations.mass, mass);
  b.inertia = (b.rz.transpose() * mass * b.rz).diagonal();
  return b;
}

Status brought_to_rest(const GenericSolver& solver, GenericState& state) {
  const Status status = solver.project(state);
  std::fill(state.zd.begin(), state.zd.end(), 0.0);
  return status;
}

Eigen::Index unknowns_of(const GenericEquations& equations, const Balance& b) {
  const int moving = auxiliary_state_count(equations.model) - held_state_count(equations.model);
  return b.rz.cols() + moving;
}

Status moved(const GenericSolver& solver, const GenericEquations& equations, const GenericState& state,
             const Balance& b, const Eigen::VectorXd& change, GenericState& result) {
  result = state;
  const Eigen::VectorXd dz = b.rz * change.head(b.rz.cols());
  for (std::size_t i = 0; i < result.z.size(); ++i) result.z[i] += dz[static_cast<Eigen::Index>(i)];
  for (Eigen::Index i = 0; i < change.size() - b.rz.cols(); ++i) {
    const auto x = static_cast<std::size_t>(i);
    result.x[x] += change[b.rz.cols() + i] * equations.magnitudes[x];
  }
  return brought_to_rest(solver, result);
}

Status stiffness_by_differences(const GenericSolver& solver, GenericEquations& equations, const GenericState& state,
                                const Balance& b, const Pinned& pinned, Eigen::MatrixXd& stiffness) {
  const Eigen::Index unknowns = unknowns_of(equations, b);
  stiffness.resize(b.force.size(), unknowns);
  for (Eigen::Index u = 0; u < unknowns; ++u) {
    if (u >= b.rz.cols() && pinned[static_cast<std::size_t>(u - b.rz.cols())]) {
      stiffness.col(u).setZero();
      continue;
    }
    const Eigen::VectorXd change = Eigen::VectorXd::Unit(unknowns, u) * kDifference;
    GenericState ahead, behind;
    if (const Status status = moved(solver, equations, state, b, change, ahead); !status.ok()) return status;
    if (const Status status = moved(solver, equations, state, b, -change, behind); !status.ok()) return status;
    stiffness.col(u) = (forces_at(equations, ahead) - forces_at(equations, behind)) / (2 * kDifference);
  }
  return {};
}

Status stiffness_at(const GenericSolver& solver, GenericEquations& equations, const GenericState& state,
                    const Balance& b, const Pinned& pinned, Eigen::MatrixXd& stiffness) {
  stiffness = stiffness_by_slopes(equations, state, b, pinned);
  if (stiffness.allFinite()) return {};
  return stiffness_by_differences(solver, equations, state, b, pinned, stiffness);
}

Eigen::VectorXd effective_inertia(const Balance& b) {
  constexpr double kRounding = 1e-28;  // of the largest inertia: squares of rounded directions
  constexpr double kInPlace = 1e-12;   // kg or kg m^2, of the largest inertia where that is below 1
  const double largest = b.inertia.size() > 0 ? b.inertia.maxCoeff() : 0;
  const double in_place = std::max(kInPlace * std::min(largest, 1.0), std::numeric_limits<double>::min());
  return (b.inertia.array() > kRounding * largest).select(b.inertia, in_place);
}

double unbalanced_acceleration(const Balance& b) {
  if (b.rz.cols() == 0) return 0;
  return (b.rz * b.force.head(b.rz.cols()).cwiseQuotient(effective_inertia(b))).cwiseAbs().maxCoeff();
}

}  // namespace mbgen
