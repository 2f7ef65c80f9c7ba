// Positions and velocities nearest to the targets, with the loops closed: weighted least squares with locks,
// loop block by loop block, since no closure sees the coordinates of two blocks.

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "compiler/algebra/dense.hpp"
#include "compiler/analysis/configuration.hpp"
#include "mbgen/solver/newton.hpp"
#include "runtime/generic/equations.hpp"
#include "runtime/generic/generic.hpp"
#include "runtime/generic/nearest.hpp"

namespace mbgen {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kLargestMove = 0.05;         // rad or m: of a target between two positions closed one after the other
constexpr double kMostMoves = 20000;          // larger ones then, for targets that are farther away
constexpr int kStepsOnTheWay = 4;             // of the searches before: the next one starts where they end
constexpr double kEasier = 0.2, kHarder = 5;  // factors of the damping after success and failure of a step

/// Targets for a block. Columns as in LoopBlock::joints.
struct Demand {
  std::vector<int> fixed, movable;  ///< columns
  VectorXd value;                   ///< per column, zero where nothing is asked
  VectorXd weight;  ///< per movable column: square root of the weight over the largest one, zero where nothing is asked
};

/// A loop block of a state, whose coordinates are to move.
struct MovableBlock {
  GenericEquations& equations;
  const LoopBlock& block;
  const Demand& demand;
  GenericState& state;
};

/// Residual and Jacobian of a block: of positions without the rows that hold velocities alone.
struct Closure {
  VectorXd residual;
  SparseRows jacobian;
};

/// x nearest to zero with a x = b in the sense of least squares.
VectorXd least(const MatrixXd& a, const VectorXd& b) {
  return a.size() == 0 ? VectorXd(VectorXd::Zero(a.cols())) : least_squares(a, b, kIndifferentShare);
}

/// The same with damping * |x|^2 beside the squares.
VectorXd least(const MatrixXd& a, const VectorXd& b, double damping) {
  MatrixXd stacked(a.rows() + a.cols(), a.cols());
  stacked << a, std::sqrt(damping) * MatrixXd::Identity(a.cols(), a.cols());
  VectorXd right_hand_side = VectorXd::Zero(stacked.rows());
  right_hand_side.head(b.size()) = b;
  return least(stacked, right_hand_side);
}

/// Orthonormal directions in which the product with `a` does not change.
MatrixXd indifferent_directions(const MatrixXd& a) {
  if (a.size() == 0) return MatrixXd::Identity(a.cols(), a.cols());
  return mbgen::indifferent_directions(a, kIndifferentShare);
}

double largest(const VectorXd& values) { return values.size() > 0 ? values.lpNorm<Eigen::Infinity>() : 0.0; }

/// Shortened where it moves a coordinate farther than kLargestSearchStep.
VectorXd capped(const VectorXd& step) { return step * shortening(largest(step), kLargestSearchStep); }

/// Driven coordinates as locked targets, in place of other targets for them.
std::vector<CoordinateTarget> with_drives(std::vector<CoordinateTarget> targets,
                                          const std::vector<Drive<double>>& drives, double Drive<double>::*value) {
  for (const Drive<double>& drive : drives) {
    std::erase_if(targets, [&](const CoordinateTarget& target) { return target.coordinate == drive.coordinate; });
    targets.push_back({drive.coordinate, drive.*value, 1, true});
  }
  return targets;
}

Demand demand_of(const LoopBlock& block, const std::vector<CoordinateTarget>& targets) {
  Demand demand;
  demand.value = VectorXd::Zero(static_cast<Index>(block.joints.size()));
  std::vector<double> weights;
  for (std::size_t c = 0; c < block.joints.size(); ++c) {
    const auto target =
        std::find_if(targets.begin(), targets.end(), [&](const auto& w) { return w.coordinate == block.joints[c]; });
    const bool asked = target != targets.end();
    if (asked) demand.value[static_cast<Index>(c)] = target->value;
    if (asked && target->locked) {
      demand.fixed.push_back(static_cast<int>(c));
    } else {
      demand.movable.push_back(static_cast<int>(c));
      weights.push_back(asked ? target->weight : 0.0);
    }
  }
  demand.weight = Eigen::Map<const VectorXd>(weights.data(), static_cast<Index>(weights.size()));
  const double heaviest = largest(demand.weight);
  if (heaviest > 0) demand.weight = (demand.weight / heaviest).cwiseSqrt();
  return demand;
}

VectorXd of_block(const LoopBlock& block, const std::vector<double>& values) {
  VectorXd result(static_cast<Index>(block.joints.size()));
  for (std::size_t c = 0; c < block.joints.size(); ++c) result[static_cast<Index>(c)] = values[block.joints[c]];
  return result;
}

void set_block(const LoopBlock& block, const VectorXd& from, std::vector<double>& values) {
  for (std::size_t c = 0; c < block.joints.size(); ++c) values[block.joints[c]] = from[static_cast<Index>(c)];
}

/// Rows of a block that hold positions.
std::vector<int> position_rows(const MovableBlock& m) {
  const std::vector<int> others = velocity_rows(m.equations.model, m.equations.topology, m.block);
  std::vector<int> rows;
  for (int row = 0; row < m.block.equations; ++row)
    if (std::find(others.begin(), others.end(), row) == others.end()) rows.push_back(row);
  return rows;
}

/// The given rows of a block that is evaluated, over the given columns.
MatrixXd dense(const SparseRows& rows, std::size_t columns, const std::vector<int>& taken) {
  MatrixXd all = MatrixXd::Zero(static_cast<Index>(rows.size()), static_cast<Index>(columns));
  for (std::size_t e = 0; e < rows.size(); ++e)
    for (std::size_t i = 0; i < rows[e].columns.size(); ++i)
      all(static_cast<Index>(e), rows[e].columns[i]) = rows[e].values[i];
  return all(Eigen::all, taken);
}

/// rows x, x zero but at the given columns.
VectorXd product(const SparseRows& rows, const std::vector<int>& columns, const VectorXd& x) {
  VectorXd of_columns = VectorXd::Zero(x.size());
  of_columns(columns) = x(columns);
  return product(rows, of_columns);
}

/// All rows of the closure at block coordinates z, which the state takes over.
Closure all_rows_at(const MovableBlock& m, const VectorXd& z) {
  set_block(m.block, z, m.state.z);
  System<double>& system = m.equations.system(m.state);
  SparseClosure<double> closed = sparse_closure(system, kinematics(system), m.block, m.equations.rest);
  return {Eigen::Map<const VectorXd>(closed.residual.data(), static_cast<Index>(closed.residual.size())),
          std::move(closed.jacobian)};
}

/// Its rows that hold positions.
Closure closure_at(const MovableBlock& m, const VectorXd& z) {
  Closure all = all_rows_at(m, z);
  const std::vector<int> rows = position_rows(m);
  Closure result{all.residual(rows), {}};
  for (const int row : rows) result.jacobian.push_back(std::move(all.jacobian[static_cast<std::size_t>(row)]));
  return result;
}

/// Movable columns of its Jacobian, dense or sparse: a large block is too large for dense decompositions.
MatrixXd dense_movable(const MovableBlock& m, const SparseRows& jacobian) {
  return dense(jacobian, m.block.joints.size(), m.demand.movable);
}
SparseEquations sparse_movable(const MovableBlock& m, const SparseRows& jacobian) {
  return {jacobian, static_cast<int>(m.block.joints.size()), m.demand.movable};
}

/// Change of the movable coordinates that closes a block, damped.
VectorXd closing_change(const MovableBlock& m, const Closure& here, double damping) {
  return is_large(m.block) ? sparse_movable(m, here.jacobian).damped(-here.residual, damping)
                           : least(dense_movable(m, here.jacobian), -here.residual, damping);
}

/// Motions of the movable coordinates that keep a block closed, at a position.
class Tangent {
 public:
  Tangent(const MovableBlock& m, const VectorXd& z) : demand_(m.demand) {
    const Closure here = closure_at(m, z);
    if (is_large(m.block))
      equations_ = sparse_movable(m, here.jacobian);
    else
      directions_ = indifferent_directions(dense_movable(m, here.jacobian));
  }
  bool is_empty() const { return equations_ ? equations_->is_rigid() : directions_.cols() == 0; }
  /// The change that meets the weighted targets best, damped. lacking: per movable column.
  VectorXd change(const VectorXd& lacking, double damping) const {
    if (!equations_) return directions_ * least(demand_.weight.asDiagonal() * directions_, lacking, damping);
    constexpr double kLeastDamping = 1e-8;  // of coordinates without a target, that the equations stay regular
    const VectorXd held = demand_.weight.cwiseAbs2().array() + std::max(damping, kLeastDamping);
    return equations_->least(held, demand_.weight.cwiseProduct(lacking), VectorXd::Zero(equations_->given()));
  }

 private:
  const Demand& demand_;
  MatrixXd directions_;
  std::optional<SparseEquations> equations_;  ///< of a large block, in place of the directions
};

/// Closes a block by its movable coordinates, or opens it as little as can be. Damping by the squared residual keeps
/// Newton's order: N. Yamashita, M. Fukushima, "On the rate of convergence of the Levenberg-Marquardt method",
/// Computing Supplement 15, 2001. Result: |Phi|.
double close(const MovableBlock& m, VectorXd& z) {
  Closure here = closure_at(m, z);
  double damping = 1;
  for (int step = 0; step < kNearestIterations && here.residual.norm() > kSmallestResidual; ++step) {
    const VectorXd change = capped(closing_change(m, here, damping * here.residual.squaredNorm()));
    VectorXd trial = z;
    trial(m.demand.movable) += change;
    Closure there = closure_at(m, trial);
    const bool gains = there.residual.norm() < here.residual.norm();
    damping *= gains ? kEasier : kHarder;
    if (gains) {
      z = std::move(trial);
      here = std::move(there);
    }
    if (!(largest(change) > kRoundingStep)) break;
  }
  set_block(m.block, z, m.state.z);
  return here.residual.norm();
}

/// Weighted distances of the movable columns from a target.
VectorXd missing(const Demand& demand, const VectorXd& target, const VectorXd& z) {
  return demand.weight.cwiseProduct(target(demand.movable) - z(demand.movable));
}

/// Takes the fixed coordinates to their place on the way from `start` to the targets (share: 0 to 1), closes the
/// block, and goes along the closures to where the other targets, taken as far, are met best. Result: |Phi|.
double approach(const MovableBlock& m, const VectorXd& start, double share, int most_steps, VectorXd& z) {
  const Demand& demand = m.demand;
  const VectorXd target = start + share * (demand.value - start);
  z(demand.fixed) = target(demand.fixed);
  double open = close(m, z), damping = 1e-6;
  std::optional<Tangent> tangent(std::in_place, m, z);
  for (int step = 0; step < most_steps && !tangent->is_empty(); ++step) {
    const VectorXd lacking = missing(demand, target, z);
    const VectorXd change = capped(tangent->change(lacking, damping));
    if (!(largest(change) > kRoundingStep)) break;
    VectorXd trial = z;
    trial(demand.movable) += change;
    const double open_there = close(m, trial);
    const bool gains = missing(demand, target, trial).norm() < lacking.norm() && open_there <= std::max(open, kClosed);
    damping *= gains ? kEasier : kHarder;
    if (gains) {
      z = std::move(trial);
      open = open_there;
      tangent.emplace(m, z);
    }
  }
  set_block(m.block, z, m.state.z);
  return open;
}

/// A position of a block that was found: how far it is open, and its distance from the targets.
struct Found {
  VectorXd z;
  double open = 0, missing = 0;
};

/// Follows the closures from the block's position to the targets, in moves so small that it stays on its branch.
Found followed(const MovableBlock& m, const VectorXd& start) {
  const VectorXd way = m.demand.value - start;
  const double farthest =
      std::max(largest(way(m.demand.fixed)), largest(m.demand.weight.cwiseSign().cwiseProduct(way(m.demand.movable))));
  const double moves = std::clamp(std::ceil(farthest / kLargestMove), 1.0, kMostMoves);
  Found found{start};
  for (int k = 1; k < static_cast<int>(moves); ++k) approach(m, start, k / moves, kStepsOnTheWay, found.z);
  found.open = approach(m, start, 1, kNearestIterations, found.z);
  found.missing = missing(m.demand, m.demand.value, found.z).norm();
  return found;
}

/// Closes the block from the very values of the targets, which may lie on another branch.
Found leapt(const MovableBlock& m, const VectorXd& start) {
  Found found{m.demand.value};
  for (std::size_t c = 0; c < m.demand.movable.size(); ++c) {
    const int column = m.demand.movable[c];
    if (m.demand.weight[static_cast<Index>(c)] == 0) found.z[column] = start[column];
  }
  found.open = approach(m, start, 1, kNearestIterations, found.z);
  found.missing = missing(m.demand, m.demand.value, found.z).norm();
  return found;
}

/// Takes a block to its targets. Result: |Phi|.
double assemble_block(const MovableBlock& m) {
  const VectorXd start = of_block(m.block, m.state.z);
  Found best = followed(m, start);
  if (!(best.open <= kClosed) || best.missing > kClosed) {
    Found other = leapt(m, start);
    const bool closes = best.open <= kClosed && other.open <= kClosed;
    if (closes ? other.missing < best.missing : other.open < best.open) best = std::move(other);
  }
  set_block(m.block, best.z, m.state.z);
  return best.open;
}

/// Velocities of the movable coordinates nearest to the targets, with rows x = b.
VectorXd nearest_velocities(const MovableBlock& m, const SparseRows& jacobian, const VectorXd& b) {
  const Demand& demand = m.demand;
  if (is_large(m.block)) return sparse_movable(m, jacobian).nearest(demand.weight, demand.value(demand.movable), b);
  const MatrixXd movable = dense_movable(m, jacobian);
  const VectorXd needed = least(movable, b);
  const MatrixXd directions = indifferent_directions(movable);
  const VectorXd lacking = demand.weight.cwiseProduct(demand.value(demand.movable) - needed);
  return needed + directions * least(demand.weight.asDiagonal() * directions, lacking);
}

/// The block's velocities nearest to the targets, with Phi_z zd = 0. Result: |Phi_z zd|.
double set_velocities(const MovableBlock& m) {
  const Demand& demand = m.demand;
  const SparseRows jacobian = all_rows_at(m, of_block(m.block, m.state.z)).jacobian;
  VectorXd zd = demand.value;
  zd(demand.movable) = nearest_velocities(m, jacobian, -product(jacobian, demand.fixed, demand.value));
  set_block(m.block, zd, m.state.zd);
  return product(jacobian, zd).norm();
}

}  // namespace

Status GenericSolver::assemble(GenericState& state, const std::vector<CoordinateTarget>& positions) const {
  if (const Status status = equations_->check_arguments(state, {}); !status.ok()) return status;
  const std::vector<double> start = state.z;
  System<double>& system = equations_->system(state);
  if (const Status status = GenericEquations::follow_motions(system, state); !status.ok()) return status;
  const std::vector<CoordinateTarget> targets = with_drives(positions, drives(system), &Drive<double>::position);
  for (const CoordinateTarget& target : targets) state.z[target.coordinate] = target.value;
  for (const LoopBlock& block : equations_->topology.blocks) set_block(block, of_block(block, start), state.z);
  Status result;
  for (std::size_t b = 0; b < equations_->topology.blocks.size(); ++b) {
    const LoopBlock& block = equations_->topology.blocks[b];
    const Demand demand = demand_of(block, targets);
    if (demand.fixed.empty() && largest(demand.weight) == 0) continue;
    const double open = assemble_block({*equations_, block, demand, state});
    if (!(open <= kClosed) && result.ok()) result = {Code::loop_not_closed, static_cast<int>(b)};
  }
  return result;
}

Status GenericSolver::assemble_velocities(GenericState& state, const std::vector<CoordinateTarget>& velocities) const {
  if (const Status status = equations_->check_arguments(state, {}); !status.ok()) return status;
  System<double>& system = equations_->system(state);
  if (const Status status = GenericEquations::follow_motions(system, state); !status.ok()) return status;
  const std::vector<CoordinateTarget> targets = with_drives(velocities, drives(system), &Drive<double>::velocity);
  for (const CoordinateTarget& target : targets) state.zd[target.coordinate] = target.value;
  Status result;
  for (std::size_t b = 0; b < equations_->topology.blocks.size(); ++b) {
    const LoopBlock& block = equations_->topology.blocks[b];
    const Demand demand = demand_of(block, targets);
    const double open = set_velocities({*equations_, block, demand, state});
    const double scale = std::max(1.0, largest(of_block(block, state.zd)));
    if (!(open <= kClosed * scale) && result.ok()) result = {Code::loop_not_closed, static_cast<int>(b)};
  }
  return result;
}

}  // namespace mbgen
