#include "runtime/generic/maggi.hpp"

#include <algorithm>

namespace mbgen {
namespace {

constexpr double kRankTolerance = 1e-10;  // relative to the first pivot
constexpr double kNoInertia = 1e-12;      // pivot over diagonal of the reduced mass matrix

}  // namespace

BlockFactors::BlockFactors(const std::vector<std::vector<double>>& jacobian, const std::vector<int>& driven,
                           int rank_limit) {
  const auto equations = static_cast<Eigen::Index>(jacobian.size());
  const auto coordinates = static_cast<Eigen::Index>(jacobian.empty() ? 0 : jacobian[0].size());
  jacobian_.resize(equations, coordinates);
  for (Eigen::Index e = 0; e < equations; ++e)
    for (Eigen::Index c = 0; c < coordinates; ++c) jacobian_(e, c) = jacobian[e][c];
  std::vector<int> movable;
  for (int c = 0; c < coordinates; ++c)
    if (std::find(driven.begin(), driven.end(), c) == driven.end()) movable.push_back(c);
  Eigen::MatrixXd candidates(equations, movable.size());
  for (std::size_t c = 0; c < movable.size(); ++c) candidates.col(c) = jacobian_.col(movable[c]);
  Eigen::FullPivLU<Eigen::MatrixXd> all(candidates);
  all.setThreshold(kRankTolerance);
  rank_ = std::min<int>(rank_limit, candidates.size() == 0 ? 0 : static_cast<int>(all.rank()));
  std::vector<bool> is_dependent(coordinates, false);
  std::vector<int> row_at(equations);
  for (Eigen::Index e = 0; e < equations && candidates.size() > 0; ++e)
    row_at[all.permutationP().indices()[e]] = static_cast<int>(e);
  for (int k = 0; k < rank_; ++k) {
    rows_.push_back(row_at[k]);
    dependent_columns_.push_back(movable[all.permutationQ().indices()[k]]);
    is_dependent[dependent_columns_.back()] = true;
  }
  for (int c : movable)
    if (!is_dependent[c]) free_columns_.push_back(c);
  dependent_.resize(rank_, rank_);
  for (int r = 0; r < rank_; ++r)
    for (int c = 0; c < rank_; ++c) dependent_(r, c) = jacobian_(rows_[r], dependent_columns_[c]);
  factors_.compute(dependent_);
}

void BlockFactors::solve(const std::vector<double>& right_hand_side, std::vector<double>& x) const {
  if (rank_ == 0) return;
  Eigen::VectorXd given = Eigen::Map<const Eigen::VectorXd>(x.data(), static_cast<Eigen::Index>(x.size()));
  for (int c : dependent_columns_) given[c] = 0;
  Eigen::VectorXd b(rank_);
  for (int r = 0; r < rank_; ++r) b[r] = right_hand_side[rows_[r]] - jacobian_.row(rows_[r]).dot(given);
  const Eigen::VectorXd dependent = factors_.solve(b);
  for (int c = 0; c < rank_; ++c) x[dependent_columns_[c]] = dependent[c];
}

std::vector<std::vector<double>> BlockFactors::rz() const {
  std::vector<std::vector<double>> result(jacobian_.cols());
  const std::vector<double> still(jacobian_.rows(), 0.0);
  for (int free : free_columns_) {
    std::vector<double> column(jacobian_.cols(), 0.0);
    column[free] = 1;
    solve(still, column);
    for (std::size_t c = 0; c < column.size(); ++c) result[c].push_back(column[c]);
  }
  return result;
}

std::vector<double> BlockFactors::multipliers(const std::vector<double>& right_hand_side) const {
  std::vector<double> lambda(jacobian_.rows(), 0.0);
  if (rank_ == 0) return lambda;
  Eigen::VectorXd b(rank_);
  for (int c = 0; c < rank_; ++c) b[c] = right_hand_side[dependent_columns_[c]];
  const Eigen::VectorXd y = dependent_.transpose().fullPivLu().solve(b);
  for (int r = 0; r < rank_; ++r) lambda[rows_[r]] = y[r];
  return lambda;
}

Eigen::MatrixXd tree_mass_matrix(System<double>& system, const Kinematics<double>& kinematics,
                                 const Inertias<double>& inertias) {
  const int n = system.topology.size();
  Eigen::MatrixXd mass = Eigen::MatrixXd::Zero(n, n);
  for (const JointGroup& group : system.topology.groups) {
    const detail::GroupMass<double> block = detail::group_mass(system, kinematics, inertias, group);
    const int frame = system.layout.bodies[group.joints[0]].joint_frame;
    for (std::size_t c = 0; c < group.joints.size(); ++c) {
      const int i = group.joints[c];
      for (std::size_t d = 0; d < group.joints.size(); ++d) mass(i, group.joints[d]) = block.mass[c][d];
      const std::vector<double> below =
          detail::momentum_below(system, kinematics, group.base, frame, block.momentum[c]);
      for (int j = 0; j < n; ++j)
        if (below[j] != 0) mass(i, j) = mass(j, i) = below[j];
    }
  }
  return mass;
}

Eigen::MatrixXd dense_rz(const Topology& topology, const std::vector<GroupProjection<double>>& projections) {
  Eigen::Index free = 0;
  for (const GroupProjection<double>& p : projections) free += static_cast<Eigen::Index>(p.rz[0].size());
  Eigen::MatrixXd rz = Eigen::MatrixXd::Zero(topology.size(), free);
  Eigen::Index first = 0;
  for (std::size_t g = 0; g < projections.size(); ++g) {
    for (std::size_t c = 0; c < projections[g].rz.size(); ++c)
      for (std::size_t q = 0; q < projections[g].rz[c].size(); ++q)
        rz(topology.groups[g].joints[c], first + static_cast<Eigen::Index>(q)) = projections[g].rz[c][q];
    first += static_cast<Eigen::Index>(projections[g].rz[0].size());
  }
  return rz;
}

std::vector<double> solve_maggi(const Eigen::MatrixXd& mass, const std::vector<double>& q,
                                const std::vector<double>& zdd_star, const Topology& topology,
                                const std::vector<GroupProjection<double>>& projections, int& singular) {
  const Eigen::Index n = mass.rows();
  const Eigen::MatrixXd rz = dense_rz(topology, projections);
  const Eigen::MatrixXd reduced = rz.transpose() * mass * rz;
  const Eigen::VectorXd right_hand_side = rz.transpose() * Eigen::Map<const Eigen::VectorXd>(q.data(), n);
  Eigen::VectorXd x = Eigen::VectorXd::Zero(rz.cols());
  if (rz.cols() > 0) {
    const Eigen::VectorXd scale = reduced.diagonal().cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
    const Eigen::LDLT<Eigen::MatrixXd> factors(scale.asDiagonal() * reduced * scale.asDiagonal());
    if (!(factors.vectorD().minCoeff() > kNoInertia)) {
      Eigen::Index row = 0, direction = 0;
      reduced.diagonal().minCoeff(&direction);
      rz.col(direction).cwiseAbs().maxCoeff(&row);
      singular = static_cast<int>(row);
      return {};
    }
    x = scale.asDiagonal() * factors.solve(scale.asDiagonal() * right_hand_side);
  }
  const Eigen::VectorXd zdd = Eigen::Map<const Eigen::VectorXd>(zdd_star.data(), n) + rz * x;
  return {zdd.data(), zdd.data() + n};
}

}  // namespace mbgen
