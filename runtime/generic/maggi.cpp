#include "runtime/generic/maggi.hpp"

namespace mbgen {
namespace {

constexpr double kNoInertia = 1e-12;  // pivot over diagonal of the reduced mass matrix

}  // namespace

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

void spread(const TreeMass& mass, Eigen::MatrixXd& whole) {
  for (std::size_t e = 0; e < mass.value.size(); ++e)
    whole(mass.row[e], mass.column[e]) = whole(mass.column[e], mass.row[e]) = mass.value[e];
}

int solve_free(const ReducedEquations& reduced, Eigen::VectorXd& free) {
  const Eigen::MatrixXd& mass = reduced.mass;
  if (mass.rows() == 0) {
    free.resize(0);
    return -1;
  }
  const Eigen::VectorXd scale = mass.diagonal().cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
  const Eigen::LDLT<Eigen::MatrixXd> factors(scale.asDiagonal() * mass * scale.asDiagonal());
  if (!(factors.vectorD().minCoeff() > kNoInertia)) {
    Eigen::Index direction = 0;
    mass.diagonal().minCoeff(&direction);
    return static_cast<int>(direction);
  }
  free = scale.asDiagonal() * factors.solve(scale.asDiagonal() * reduced.right_hand_side);
  return -1;
}

}  // namespace mbgen
