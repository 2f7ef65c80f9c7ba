#include "runtime/generic/sparse_projection.hpp"

#include <algorithm>

namespace mbgen {

SparseProjection::SparseProjection(const Model& model, const Topology& topology, const LoopShape& shape)
    : mass_rows_(topology.bodies.size()),
      rz_(static_cast<std::size_t>(shape.directions)),
      coupled_(rz_.size()),
      row_(topology.bodies.size()) {
  const TreeMass pattern = tree_mass_pattern(model, topology);
  for (int e = 0; e < static_cast<int>(pattern.row.size()); ++e) {
    const int i = pattern.row[e], j = pattern.column[e];
    mass_rows_[i].push_back({j, e});
    if (i != j && topology.group_of[i] == topology.group_of[j]) mass_rows_[j].push_back({i, e});
  }
  for (const FreeJoint& joint : shape.free_joints) rz_[joint.direction] = {{joint.coordinate, 1.0}};
  couple_directions(topology, shape);
}

/// Directions of a group meet those before them of their own group, and all of the groups below it.
void SparseProjection::couple_directions(const Topology& topology, const LoopShape& shape) {
  std::vector<std::vector<int>> of_group(topology.groups.size());
  for (const FreeJoint& joint : shape.free_joints)
    of_group[topology.group_of[joint.coordinate]].push_back(joint.direction);
  for (const BlockShape& block : shape.blocks)
    for (int q = 0; q < block.directions(); ++q)
      of_group[topology.group_of[block.joints[0]]].push_back(block.first_direction + q);
  for (std::size_t g = 0; g < of_group.size(); ++g)
    for (int d : of_group[g]) {
      for (int own : of_group[g])
        if (own <= d) coupled_[d].push_back(own);
      for (int h = topology.groups[g].parent; h >= 0; h = topology.groups[h].parent)
        coupled_[d].insert(coupled_[d].end(), of_group[h].begin(), of_group[h].end());
    }
}

void SparseProjection::reduce(const TreeMass& mass, const std::vector<double>& q, ReducedEquations& reduced) {
  const auto times = [](const std::vector<RzEntry>& column, const std::vector<double>& values) {
    double sum = 0;
    for (const RzEntry& entry : column) sum += entry.value * values[entry.coordinate];
    return sum;
  };
  const auto directions = static_cast<Eigen::Index>(rz_.size());
  reduced.mass.setZero(directions, directions);
  reduced.right_hand_side.resize(directions);
  for (std::size_t d = 0; d < rz_.size(); ++d) {
    std::fill(row_.begin(), row_.end(), 0.0);
    for (const RzEntry& entry : rz_[d])
      for (const MassEntry& m : mass_rows_[entry.coordinate]) row_[m.column] += entry.value * mass.value[m.source];
    const auto row = static_cast<Eigen::Index>(d);
    for (int below : coupled_[d]) reduced.mass(row, below) = times(rz_[below], row_);
    reduced.right_hand_side[row] = times(rz_[d], q);
  }
}

void SparseProjection::add_rz_times(const Eigen::VectorXd& free, std::vector<double>& x) const {
  for (std::size_t d = 0; d < rz_.size(); ++d)
    for (const RzEntry& entry : rz_[d]) x[entry.coordinate] += entry.value * free[static_cast<Eigen::Index>(d)];
}

}  // namespace mbgen
