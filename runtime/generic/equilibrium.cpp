#include <algorithm>
#include <cmath>

#include "compiler/algebra/dense.hpp"
#include "compiler/model/auxiliary_states.hpp"
#include "mbgen/newton.hpp"
#include "runtime/generic/equations.hpp"
#include "runtime/generic/generic.hpp"

namespace mbgen {
namespace {

constexpr double kDifference = 1e-6;     // rad or m, for the stiffness by central differences
constexpr double kIndifferent = 1e-7;    // kIndifferentShare for a stiffness, which differences give to seven digits
constexpr double kBalanced = 1e-3;       // rad/s^2 or m/s^2: accelerations below it are left to Newton's steps alone
constexpr double kSettledStates = 1e-8;  // of their magnitudes: states of the user's own that differences resolve
constexpr double kSlipReach = 0.1;       // m: a slip deflection of this size counts as much as a unit of a coordinate

/// Static forces of the free directions at a position that satisfies the closures; frozen partition. States of the
/// user's own have to stand still, too.
struct Balance {
  Eigen::VectorXd force;    ///< Rz' (tree forces at rest), then rates of the states over their magnitudes, 1/s
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
  const std::vector<double>& magnitudes = equations.magnitudes;
  const auto first = static_cast<Eigen::Index>(slip_state_count(equations.model));
  const Eigen::Index states = auxiliary_state_count(equations.model) - held_state_count(equations.model) - first;
  b.force.resize(b.rz.cols() + states);
  b.force.head(b.rz.cols()) =
      b.rz.transpose() * Eigen::Map<const Eigen::VectorXd>(q.data(), static_cast<Eigen::Index>(q.size()));
  for (Eigen::Index i = 0; i < states; ++i)
    b.force[b.rz.cols() + i] = forces.xd[first + i] / magnitudes[static_cast<std::size_t>(first + i)];
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

/// Unknowns of a search: the free directions, then the auxiliary states that move, in parts of their magnitudes.
Eigen::Index unknowns_of(const GenericEquations& equations, const Balance& b) {
  const int moving = auxiliary_state_count(equations.model) - held_state_count(equations.model);
  return b.rz.cols() + moving;
}

/// The state moved along the unknowns and settled again.
Status moved(const GenericSolver& solver, const GenericEquations& equations, const GenericState& state,
             const Balance& b, const Eigen::VectorXd& change, GenericState& result) {
  result = state;
  const Eigen::VectorXd dz = b.rz * change.head(b.rz.cols());
  for (std::size_t i = 0; i < result.z.size(); ++i) result.z[i] += dz[static_cast<Eigen::Index>(i)];
  for (Eigen::Index i = 0; i < change.size() - b.rz.cols(); ++i) {
    const auto x = static_cast<std::size_t>(i);
    result.x[x] += change[b.rz.cols() + i] * equations.magnitudes[x];
  }
  return settled(solver, result);
}

/// d force / d unknowns by central differences along the closures.
Status stiffness_at(const GenericSolver& solver, GenericEquations& equations, const GenericState& state,
                    const Balance& b, Eigen::MatrixXd& stiffness) {
  const Eigen::Index unknowns = unknowns_of(equations, b);
  stiffness.resize(b.force.size(), unknowns);
  const Eigen::Index first_held = b.rz.cols() + first_turn(equations.model);
  const Eigen::Index last_held = b.rz.cols() + slip_state_count(equations.model);
  for (Eigen::Index u = 0; u < unknowns; ++u) {
    if (u >= first_held && u < last_held) {  // turns and bristles stay straight: bent at rest they would bear any load
      stiffness.col(u).setZero();
      continue;
    }
    const Eigen::VectorXd change = Eigen::VectorXd::Unit(unknowns, u) * kDifference;
    GenericState ahead, behind;
    if (const Status status = moved(solver, equations, state, b, change, ahead); !status.ok()) return status;
    if (const Status status = moved(solver, equations, state, b, -change, behind); !status.ok()) return status;
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
  const Eigen::Index states = b.force.size() - free;
  const Eigen::VectorXd scale = b.inertia.cwiseMax(1e-12).cwiseSqrt().cwiseInverse();
  const double unit = free > 0 ? scale.minCoeff() : 1;
  Eigen::VectorXd reach = Eigen::VectorXd::Constant(stiffness.cols(), kSlipReach);
  reach.head(free) = scale / unit;
  reach.tail(states).setOnes();
  // Rates of states count as much as accelerations, whatever their units.
  Eigen::VectorXd weight(b.force.size());
  weight.head(free) = scale;
  const auto size_of_row = [&](Eigen::Index row) { return stiffness.row(row).cwiseProduct(reach.transpose()).norm(); };
  double largest = 0;
  for (Eigen::Index i = 0; i < free; ++i) largest = std::max(largest, scale[i] * size_of_row(i));
  for (Eigen::Index i = free; i < free + states; ++i)
    weight[i] = (largest > 0 ? largest : 1) / std::max(size_of_row(i), 1e-300);
  Eigen::MatrixXd matrix = weight.asDiagonal() * stiffness * reach.asDiagonal();
  if (search == Search::downhill && unbalanced > kBalanced)
    matrix.leftCols(free).diagonal().array() -= unbalanced / (kLargestBalanceStep * unit);
  const Eigen::VectorXd wanted = -(weight.asDiagonal() * b.force);
  return reach.asDiagonal() * least_squares(matrix, wanted, kIndifferent);
}

/// Largest acceleration of a coordinate that the forces would cause if every free direction moved alone.
double unbalanced_acceleration(const Balance& b) {
  if (b.rz.cols() == 0) return 0;
  return (b.rz * b.force.head(b.rz.cols()).cwiseQuotient(b.inertia.cwiseMax(1e-12))).cwiseAbs().maxCoeff();
}

/// Largest change of a coordinate, rad or m.
double longest_move(const Balance& b, const Eigen::VectorXd& change) {
  return b.rz.cols() == 0 ? 0 : (b.rz * change.head(b.rz.cols())).cwiseAbs().maxCoeff();
}

/// Largest change of a state of the user's own, in parts of its magnitude.
double longest_of_states(const Balance& b, const Eigen::VectorXd& change) {
  const Eigen::Index states = b.force.size() - b.rz.cols();
  return states == 0 ? 0 : change.tail(states).cwiseAbs().maxCoeff();
}

/// Walks from a settled state to a balance; `trial` is the last state that was tried.
Status walk_to_balance(const GenericSolver& solver, GenericEquations& equations, Search search, int most_steps,
                       GenericState& trial) {
  for (int step = 0;; ++step) {
    const Balance here = balance(equations, trial);
    if (here.force.size() == 0) return {};
    const double unbalanced = unbalanced_acceleration(here);
    Eigen::MatrixXd stiffness;
    if (const Status status = stiffness_at(solver, equations, trial, here, stiffness); !status.ok()) return status;
    Eigen::VectorXd change = next_change(here, stiffness, unbalanced, search);
    if (!change.allFinite()) return {Code::not_a_number, -1};
    const double longest = longest_move(here, change), of_states = longest_of_states(here, change);
    const bool is_still = longest < kRoundingStep && of_states < kSettledStates;
    if (is_still && unbalanced < kBalanced) return {};
    if (is_still || step + 1 == most_steps) return {Code::no_equilibrium, -1};
    change *= shortening(longest, kLargestBalanceStep);
    GenericState next;
    if (const Status status = moved(solver, equations, trial, here, change, next); !status.ok()) return status;
    trial = std::move(next);
  }
}

}  // namespace

Status GenericSolver::equilibrium(GenericState& state) const {
  GenericState start = state;
  std::fill(start.zd.begin(), start.zd.end(), 0.0);
  const auto x = start.x.begin();  // turns and bristles straight, Maxwell branches relaxed
  std::fill(x + first_turn(equations_->model), x + first_user_state(equations_->model), 0.0);
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
