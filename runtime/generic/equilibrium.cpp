#include <algorithm>
#include <cmath>

#include "runtime/generic/content.hpp"

namespace mbgen {
namespace {

constexpr int kMostSteps = 100;
constexpr double kLongestStep = 0.05;  // rad or m per step and coordinate
constexpr double kDifference = 1e-6;   // rad or m, for the stiffness by central differences
constexpr double kIndifferent = 1e-7;  // stiffness below this share of the largest leaves a direction where it is
constexpr double kSettled = 1e-11;     // rad or m: Newton steps below it end the search
constexpr double kSlipReach = 1e-3;    // m: a slip deflection of this size counts as much as a unit of a coordinate

/// Static forces of the free directions at a position that satisfies the closures; frozen partition.
struct Balance {
  Eigen::VectorXd force;    ///< Rz' (tree forces at rest)
  Eigen::VectorXd inertia;  ///< diagonal of Rz' M Rz
  Eigen::MatrixXd rz;       ///< coordinates x free directions
};

template <class Content>
Balance balance(Content& content, const GenericState& state) {
  System<double>& system = content.system(state);
  const Kinematics<double> k = kinematics(system);
  const Velocities<double> v = velocities(system, k);
  const Inertias<double> m = inertias(system, k);
  const AppliedForces<double> forces = applied_forces(system, k, v);
  const std::vector<double> still(state.z.size(), 0.0);
  const std::vector<double> q = tree_forces(system, k, m, v, mbgen::accelerations(system, k, v, still), forces, still);
  Balance b;
  b.rz = dense_rz(content.topology, frozen_directions(system, k, content.analysis.blocks, content.analysis.driven));
  b.force = b.rz.transpose() * Eigen::Map<const Eigen::VectorXd>(q.data(), static_cast<Eigen::Index>(q.size()));
  tree_mass_matrix(system, k, m, content.mass);
  Eigen::MatrixXd mass = Eigen::MatrixXd::Zero(b.rz.rows(), b.rz.rows());
  spread(content.mass, mass);
  b.inertia = (b.rz.transpose() * mass * b.rz).diagonal();
  return b;
}

/// The state moved along the unknowns (free directions, then slip deflections) and closed again.
Status moved(const GenericSolver& solver, const GenericState& state, const Balance& b, const Eigen::VectorXd& change,
             GenericState& result) {
  result = state;
  const Eigen::VectorXd dz = b.rz * change.head(b.rz.cols());
  for (std::size_t i = 0; i < result.z.size(); ++i) result.z[i] += dz[static_cast<Eigen::Index>(i)];
  for (std::size_t i = 0; i < result.x.size(); ++i) result.x[i] += change[b.rz.cols() + static_cast<Eigen::Index>(i)];
  return solver.project(result);
}

}  // namespace

Status GenericSolver::equilibrium(GenericState& state) const {
  GenericState trial = state;
  std::fill(trial.zd.begin(), trial.zd.end(), 0.0);
  const auto settle = [&](GenericState& s) {  // motions give their driven coordinates a velocity: at rest it is zero
    const Status status = project(s);
    std::fill(s.zd.begin(), s.zd.end(), 0.0);
    return status;
  };
  if (const Status status = settle(trial); !status.ok()) return status;
  for (int step = 0;; ++step) {
    const Balance here = balance(*content_, trial);
    const Eigen::Index free = here.rz.cols(), unknowns = free + static_cast<Eigen::Index>(trial.x.size());
    if (free == 0) break;
    Eigen::VectorXd reach = Eigen::VectorXd::Constant(unknowns, kSlipReach);
    const Eigen::VectorXd scale = here.inertia.cwiseMax(1e-12).cwiseSqrt().cwiseInverse();
    reach.head(free) = scale / scale.minCoeff();
    Eigen::MatrixXd stiffness(free, unknowns);
    for (Eigen::Index u = 0; u < unknowns; ++u) {
      GenericState ahead, behind;
      const Eigen::VectorXd change = Eigen::VectorXd::Unit(unknowns, u) * kDifference;
      if (const Status status = moved(*this, trial, here, change, ahead); !status.ok()) return status;
      if (const Status status = moved(*this, trial, here, -change, behind); !status.ok()) return status;
      std::fill(ahead.zd.begin(), ahead.zd.end(), 0.0);
      std::fill(behind.zd.begin(), behind.zd.end(), 0.0);
      stiffness.col(u) = (balance(*content_, ahead).force - balance(*content_, behind).force) / (2 * kDifference);
    }
    Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> factors;
    factors.setThreshold(kIndifferent);
    factors.compute(scale.asDiagonal() * stiffness * reach.asDiagonal());
    const Eigen::VectorXd wanted = -(scale.asDiagonal() * here.force);
    Eigen::VectorXd change = reach.asDiagonal() * factors.solve(wanted);
    if (!change.allFinite()) return {Code::not_a_number, -1};
    const double longest = (here.rz * change.head(free)).cwiseAbs().maxCoeff();
    if (longest < kSettled) break;
    if (step + 1 == kMostSteps) return {Code::no_equilibrium, -1};
    if (longest > kLongestStep) change *= kLongestStep / longest;
    GenericState next;
    if (const Status status = moved(*this, trial, here, change, next); !status.ok()) return status;
    std::fill(next.zd.begin(), next.zd.end(), 0.0);
    trial = std::move(next);
  }
  state.z = trial.z;
  state.x = trial.x;
  state.zd = trial.zd;
  return {};
}

}  // namespace mbgen
