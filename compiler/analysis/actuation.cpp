#include "compiler/analysis/actuation.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include "compiler/algebra/dense.hpp"
#include "compiler/algebra/median.hpp"
#include "compiler/analysis/direction_names.hpp"
#include "compiler/analysis/elimination_order.hpp"
#include "mbgen/solver/orthonormal.hpp"

namespace mbgen {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

/// Pivots below this share of the largest, of rows and columns of like size, are rounding.
constexpr double kNoForce = 1e-9;

/// Entries of Rz' B below this share of the largest possible ones are rounding: of a cylinder that pushes
/// through the axis of a joint, of a motor whose coordinate stands still.
constexpr double kNoLever = 1e-9;

/// Entries of B as large as an actuator could have them, per tree coordinate: of a cylinder its length about each joint
/// that it loads, of a motor its gear on all coordinates of the loops.
std::vector<double> possible_levers(const detail::ForceWork<double>& work, const Actuator& actuator) {
  const Topology& topology = work.system.topology;
  const double gear = std::abs(work.value(actuator.gear));
  std::vector<double> levers(topology.bodies.size(), 0.0);
  const std::vector<double> force = detail::unit_force(work, actuator);
  if (actuator.joint) {
    for (std::size_t j = 0; j < levers.size(); ++j)
      for (const int c : topology.groups[topology.group_of[j]].joints)
        if (force[j] != 0) levers[c] = gear;
    return levers;
  }
  const double length = detail::AlongLine<double>(work, actuator.from, actuator.to, -1).position;
  for (std::size_t j = 0; j < levers.size(); ++j)
    if (force[j] != 0) levers[j] = topology.bodies[j].kind == FreedomKind::revolute ? gear * length : gear;
  return levers;
}

/// Rz' B at a position, without rounding of levers: directions x actuators; and the smallest speed of the actuators,
/// see Analysis::typical_actuation.
struct ActuationAt {
  MatrixXd matrix;
  double smallest_speed = 0;
};

/// Rows of Rz of all coordinates, row by row: coordinates x directions.
std::vector<double> directions_of_all(const Topology& topology, const std::vector<GroupProjection<double>>& projections,
                                      std::size_t directions) {
  std::vector<double> rz(topology.bodies.size() * directions, 0.0);
  std::size_t first = 0;
  for (std::size_t g = 0; g < projections.size(); ++g) {
    const auto& rows = projections[g].rz;
    for (std::size_t c = 0; c < rows.size(); ++c)
      std::copy(rows[c].begin(), rows[c].end(),
                rz.begin() + static_cast<std::ptrdiff_t>(topology.groups[g].joints[c] * directions + first));
    if (!rows.empty()) first += rows[0].size();
  }
  return rz;
}

double smallest_speed(const System<double>& system, const MatrixXd& actuation,
                      const std::vector<GroupProjection<double>>& projections) {
  const int directions = static_cast<int>(actuation.rows()), actuators = static_cast<int>(actuation.cols());
  if (actuators < directions) return 0;
  const std::size_t count = static_cast<std::size_t>(directions);
  std::vector<double> rz = directions_of_all(system.topology, projections, count), r(count * count), work(count);
  std::vector<double> speeds(static_cast<std::size_t>(actuators) * count, 0.0), along(count);
  std::vector<int> order(count);
  orthonormalise(system.topology.size(), directions, rz.data(), r.data(), order.data());
  // Rows of B' Q: Q = Rz R^-1, its columns in their order.
  for (int a = 0; a < actuators; ++a) {
    double* const row = speeds.data() + a * directions;
    for (int k = 0; k < directions; ++k) {
      double value = actuation(order[static_cast<std::size_t>(k)], a);
      for (int j = 0; j < k; ++j) value -= row[j] * r[static_cast<std::size_t>(j * directions + k)];
      row[k] = value / r[static_cast<std::size_t>(k * directions + k)];
    }
  }
  for (int a = 0; a < actuators; ++a)
    for (int k = 0; k < directions; ++k)
      speeds[static_cast<std::size_t>(a * directions + k)] /=
          std::sqrt(system.model.actuators[static_cast<std::size_t>(a)].weight);
  return orthonormalise(actuators, directions, speeds.data(), r.data(), order.data());
}

ActuationAt actuation_at(NumericSystem& numbers, const Analysis& analysis, const std::vector<double>& z,
                         std::size_t directions) {
  System<double>& system = numbers.at(z);
  const Kinematics<double> k = kinematics(system);
  const Velocities<double> v = velocities(system, k);
  const std::vector<GroupProjection<double>> projections =
      frozen_directions(system, k, analysis.directions.partitions, analysis.directions.held);
  const std::vector<SparseRow<double>> rows = actuation(system, k, v, projections);
  MatrixXd matrix = MatrixXd::Zero(static_cast<Index>(directions), static_cast<Index>(system.model.actuators.size()));
  for (std::size_t q = 0; q < rows.size(); ++q)
    for (std::size_t i = 0; i < rows[q].columns.size(); ++i)
      matrix(static_cast<Index>(q), rows[q].columns[i]) = rows[q].values[i];
  AppliedForces<double> none;
  none.about = v.about;
  const detail::ForceWork<double> work{system, k, v, none};
  std::vector<GroupProjection<double>> without_signs = projections;
  for (GroupProjection<double>& projection : without_signs)
    for (std::vector<double>& row : projection.rz)
      for (double& entry : row) entry = std::abs(entry);
  for (Index a = 0; a < matrix.cols(); ++a) {
    const Actuator& actuator = system.model.actuators[static_cast<std::size_t>(a)];
    const std::vector<double> possible =
        detail::along_directions(system.topology, without_signs, possible_levers(work, actuator));
    for (Index q = 0; q < matrix.rows(); ++q)
      if (std::abs(matrix(q, a)) <= kNoLever * possible[static_cast<std::size_t>(q)]) matrix(q, a) = 0;
  }
  const double smallest = smallest_speed(system, matrix, projections);
  return {std::move(matrix), smallest};
}

/// Columns, then rows, of largest entry 1; zeros stay.
MatrixXd of_like_size(MatrixXd matrix) {
  const auto divide = [](auto part) {
    const double largest = part.cwiseAbs().maxCoeff();
    if (largest > 0) part /= largest;
  };
  for (Index c = 0; c < matrix.cols(); ++c) divide(matrix.col(c));
  for (Index r = 0; r < matrix.rows(); ++r) divide(matrix.row(r));
  return matrix;
}

/// Smallest singular value over the largest, of chosen columns of like size; 0 for fewer columns than rows.
double clearance_of(const MatrixXd& matrix, const std::vector<int>& columns) {
  if (static_cast<Index>(columns.size()) < matrix.rows()) return 0;
  const Eigen::VectorXd values = singular_values(of_like_size(matrix(Eigen::all, columns)));
  return values[0] > 0 ? values[values.size() - 1] / values[0] : 0;
}

/// The actuators that move every direction best in the worst of the configurations in which any do.
std::vector<int> chosen_actuators(const std::vector<MatrixXd>& matrices) {
  std::set<std::vector<int>> candidates;
  for (const MatrixXd& matrix : matrices) {
    std::vector<int> columns = leading_columns(of_like_size(matrix), kNoForce);
    std::sort(columns.begin(), columns.end());
    candidates.insert(std::move(columns));
  }
  std::vector<int> best;
  double most = -1;
  for (const std::vector<int>& candidate : candidates) {
    double worst = 1;
    for (const MatrixXd& matrix : matrices) worst = std::min(worst, clearance_of(matrix, candidate));
    if (worst <= most) continue;
    most = worst;
    best = candidate;
  }
  return best;
}

/// Directions beyond the rank of the best configuration.
std::vector<int> directions_without_force(const std::vector<MatrixXd>& matrices, const std::vector<int>& names) {
  std::vector<int> moved;
  for (const MatrixXd& matrix : matrices) {
    std::vector<int> rows = leading_columns(of_like_size(matrix).transpose(), kNoForce);
    if (rows.size() > moved.size()) moved = std::move(rows);
  }
  std::vector<int> left;
  for (std::size_t q = 0; q < names.size(); ++q)
    if (std::find(moved.begin(), moved.end(), static_cast<int>(q)) == moved.end()) left.push_back(names[q]);
  return left;
}

/// The free directions and those of motions that actuators give.
ActuatedDirections directions_of(const Model& model, const Topology& topology, const Analysis& analysis) {
  ActuatedDirections directions{{analysis.blocks.begin(), analysis.blocks.end()}, analysis.driven};
  for (const Motion& motion : model.motions) {
    const int moved = motion.is_actuated ? tree_coordinate(topology, motion.joint) : -1;
    if (moved < 0) continue;
    directions.held[moved] = false;
    const JointGroup& group = topology.groups[topology.group_of[moved]];
    if (group.block < 0) continue;
    LoopPartition& partition = directions.partitions[group.block];
    const int column = static_cast<int>(std::ranges::find(group.joints, moved) - group.joints.begin());
    std::erase(partition.driven, column);
    partition.independent.insert(std::ranges::lower_bound(partition.independent, column), column);
  }
  return directions;
}

}  // namespace

void set_actuation(NumericSystem& numbers, const std::vector<Configuration>& configurations, Analysis& analysis) {
  analysis.actuation = {};
  analysis.typical_actuation = 0;
  analysis.unactuated.clear();
  const Model& model = numbers.model();
  if (model.actuators.empty()) return;
  analysis.directions = directions_of(model, numbers.topology(), analysis);
  const std::vector<int> names =
      names_of_directions(numbers.topology(), analysis.directions.partitions, analysis.directions.held);
  LoopPartition& partition = analysis.actuation;
  if (names.empty()) {
    partition.independent.resize(model.actuators.size());
    std::iota(partition.independent.begin(), partition.independent.end(), 0);
    return;
  }
  std::vector<MatrixXd> all, regular;
  std::vector<double> speeds;
  for (const Configuration& configuration : configurations) {
    if (std::find(configuration.closed.begin(), configuration.closed.end(), false) != configuration.closed.end())
      continue;
    ActuationAt at = actuation_at(numbers, analysis, configuration.z, names.size());
    all.push_back(std::move(at.matrix));
    if (leading_columns(of_like_size(all.back()), kNoForce).size() != names.size()) continue;
    regular.push_back(all.back());
    if (std::isfinite(at.smallest_speed)) speeds.push_back(at.smallest_speed);
  }
  if (regular.empty()) {
    analysis.unactuated = directions_without_force(all, names);
    return;
  }
  analysis.typical_actuation = median(std::move(speeds));
  Candidate candidate;
  candidate.rows.resize(names.size());
  std::iota(candidate.rows.begin(), candidate.rows.end(), 0);
  candidate.columns = chosen_actuators(regular);
  partition.dependent = candidate.columns;
  for (int i = 0; i < static_cast<int>(model.actuators.size()); ++i)
    if (!std::binary_search(candidate.columns.begin(), candidate.columns.end(), i)) partition.independent.push_back(i);
  std::vector<bool> used;
  for (const MatrixXd& matrix : regular) used.push_back(clearance_of(matrix, candidate.columns) > kNoForce);
  if (std::find(used.begin(), used.end(), true) == used.end()) used.assign(regular.size(), true);
  partition.pivots = order_pivots(regular, used, candidate).pivots;
}

}  // namespace mbgen
