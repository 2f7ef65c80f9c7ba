#include <algorithm>
#include <cmath>

#include "compiler/algebra/dense.hpp"
#include "compiler/model/auxiliary_states.hpp"
#include "mbgen/newton.hpp"
#include "runtime/generic/equations.hpp"
#include "runtime/generic/generic.hpp"

namespace mbgen {
namespace {

constexpr double kDifference = 1e-6;   // rad or m, for the stiffness by central differences
constexpr double kIndifferent = 1e-7;  // kIndifferentShare for a stiffness, which differences give to seven digits
constexpr double kBalanced = 1e-3;     // rad/s^2 or m/s^2: accelerations below it are left to Newton's steps alone
constexpr double kSlipReach = 0.1;     // m: a slip deflection of this size counts as much as a unit of a coordinate

/// Static forces of the free directions at a position that satisfies the closures; frozen partition.
struct Balance {
  Eigen::VectorXd force;    ///< Rz' (tree forces at rest)
  Eigen::VectorXd inertia;  ///< diagonal of Rz' M Rz
  Eigen::MatrixXd rz;       ///< coordinates x free directions
};

Balance balance(GenericEquations& equations, const GenericState& state) {
  System<double>& system = equations.system(state);
  const Kinematics<double> k = kinematics(system);
  const Velocities<double> v = velocities(system, k);
  const Inertias<double> m = inertias(system, k);
  const AppliedForces<double> forces = applied_forces(system, k, v);
  const std::vector<double> still(state.z.size(), 0.0);
  const std::vector<double> q = tree_forces(system, k, m, v, mbgen::accelerations(system, k, v, still), forces, still);
  Balance b;
  b.rz =
      dense_rz(equations.topology, frozen_directions(system, k, equations.analysis.blocks, equations.analysis.driven));
  b.force = b.rz.transpose() * Eigen::Map<const Eigen::VectorXd>(q.data(), static_cast<Eigen::Index>(q.size()));
  tree_mass_matrix(system, k, m, equations.mass);
  Eigen::MatrixXd mass = Eigen::MatrixXd::Zero(b.rz.rows(), b.rz.rows());
  spread(equations.mass, mass);
  b.inertia = (b.rz.transpose() * mass * b.rz).diagonal();
  return b;
}

/// Closed, with driven coordinates at their motions, and at rest although those may have velocities.
Status settled(const GenericSolver& solver, GenericState& state) {
  const Status status = solver.project(state);
  std::fill(state.zd.begin(), state.zd.end(), 0.0);
  return status;
}

/// The state moved along the unknowns (free directions, then slip deflections) and settled again.
Status moved(const GenericSolver& solver, const GenericState& state, const Balance& b, const Eigen::VectorXd& change,
             GenericState& result) {
  result = state;
  const Eigen::VectorXd dz = b.rz * change.head(b.rz.cols());
  for (std::size_t i = 0; i < result.z.size(); ++i) result.z[i] += dz[static_cast<Eigen::Index>(i)];
  for (Eigen::Index i = 0; i < change.size() - b.rz.cols(); ++i)
    result.x[static_cast<std::size_t>(i)] += change[b.rz.cols() + i];
  return settled(solver, result);
}

/// d force / d unknowns by central differences along the closures.
Status stiffness_at(const GenericSolver& solver, GenericEquations& equations, const GenericState& state,
                    const Balance& b, Eigen::MatrixXd& stiffness) {
  const Eigen::Index unknowns = b.rz.cols() + slip_state_count(equations.model);
  stiffness.resize(b.rz.cols(), unknowns);
  for (Eigen::Index u = 0; u < unknowns; ++u) {
    const Eigen::VectorXd change = Eigen::VectorXd::Unit(unknowns, u) * kDifference;
    GenericState ahead, behind;
    if (const Status status = moved(solver, state, b, change, ahead); !status.ok()) return status;
    if (const Status status = moved(solver, state, b, -change, behind); !status.ok()) return status;
    stiffness.col(u) = (balance(equations, ahead).force - balance(equations, behind).force) / (2 * kDifference);
  }
  return {};
}

/// Whether the search goes downhill, or straight to where the forces balance, which need not hold the bodies there.
enum class Search { downhill, straight };

/// The next change of the unknowns: of all that balance the linearised forces the smallest. Far from balance a drag on
/// the inertias joins the stiffness: where nothing holds the bodies they sink no further than kLargestBalanceStep, and
/// they go downhill. It fades with the unbalanced acceleration (1/s^2 or m/s^2), so that the end is Newton's. Source:
/// C. T. Kelley, D. E. Keyes, "Convergence Analysis of Pseudo-Transient Continuation", SIAM J. Numer. Anal. 35(2),
/// 1998, with the drag of switched evolution relaxation.
Eigen::VectorXd next_change(const Balance& b, const Eigen::MatrixXd& stiffness, double unbalanced, Search search) {
  const Eigen::Index free = b.rz.cols();
  const Eigen::VectorXd scale = b.inertia.cwiseMax(1e-12).cwiseSqrt().cwiseInverse();
  const double unit = scale.minCoeff();
  Eigen::VectorXd reach = Eigen::VectorXd::Constant(stiffness.cols(), kSlipReach);
  reach.head(free) = scale / unit;
  Eigen::MatrixXd matrix = scale.asDiagonal() * stiffness * reach.asDiagonal();
  if (search == Search::downhill && unbalanced > kBalanced)
    matrix.leftCols(free).diagonal().array() -= unbalanced / (kLargestBalanceStep * unit);
  const Eigen::VectorXd wanted = -(scale.asDiagonal() * b.force);
  return reach.asDiagonal() * least_squares(matrix, wanted, kIndifferent);
}

/// Largest acceleration of a coordinate that the forces would cause if every free direction moved alone.
double unbalanced_acceleration(const Balance& b) {
  return (b.rz * b.force.cwiseQuotient(b.inertia.cwiseMax(1e-12))).cwiseAbs().maxCoeff();
}

/// Walks from a settled state to a balance; `trial` is the last state that was tried.
Status walk_to_balance(const GenericSolver& solver, GenericEquations& equations, Search search, int most_steps,
                       GenericState& trial) {
  for (int step = 0;; ++step) {
    const Balance here = balance(equations, trial);
    if (here.rz.cols() == 0) return {};
    const double unbalanced = unbalanced_acceleration(here);
    Eigen::MatrixXd stiffness;
    if (const Status status = stiffness_at(solver, equations, trial, here, stiffness); !status.ok()) return status;
    Eigen::VectorXd change = next_change(here, stiffness, unbalanced, search);
    if (!change.allFinite()) return {Code::not_a_number, -1};
    const double longest = (here.rz * change.head(here.rz.cols())).cwiseAbs().maxCoeff();
    if (longest < kRoundingStep && unbalanced < kBalanced) return {};
    if (longest < kRoundingStep || step + 1 == most_steps) return {Code::no_equilibrium, -1};
    change *= shortening(longest, kLargestBalanceStep);
    GenericState next;
    if (const Status status = moved(solver, trial, here, change, next); !status.ok()) return status;
    trial = std::move(next);
  }
}

}  // namespace

Status GenericSolver::equilibrium(GenericState& state) const {
  GenericState start = state;
  std::fill(start.zd.begin(), start.zd.end(), 0.0);
  std::fill(start.x.begin() + slip_state_count(equations_->model), start.x.end(), 0.0);  // Maxwell branches relaxed
  if (const Status status = settled(*this, start); !status.ok()) return status;
  GenericState found = start;
  Status status = walk_to_balance(*this, *equations_, Search::downhill, kBalanceIterations, found);
  if (!status.ok()) {
    GenericState near = start;
    if (walk_to_balance(*this, *equations_, Search::straight, kStraightIterations, near).ok()) {
      found = std::move(near);
      status = {};
    }
  }
  state = std::move(found);
  return status;
}

}  // namespace mbgen
