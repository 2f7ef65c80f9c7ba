#include "runtime/generic/tree_mass.hpp"

namespace mbgen {

TreeMass tree_mass_pattern(const Topology& topology) {
  TreeMass mass;
  for (const JointGroup& group : topology.groups)
    for (std::size_t c = 0; c < group.joints.size(); ++c) {
      mass.column.insert(mass.column.end(), group.joints.begin(), group.joints.begin() + c + 1);
      for (int j = group.base; j != kGround; j = topology.bodies[j].parent) mass.column.push_back(j);
      mass.row.resize(mass.column.size(), group.joints[c]);
    }
  mass.value.resize(mass.row.size());
  return mass;
}

void tree_mass_matrix(System<double>& system, const Kinematics<double>& kinematics, const Inertias<double>& inertias,
                      TreeMass& mass) {
  auto next = mass.value.begin();
  for (const JointGroup& group : system.topology.groups) {
    const detail::GroupMass<double> own = detail::group_mass(system, kinematics, inertias, group);
    const int frame = system.layout.bodies[group.joints[0]].joint_frame;
    for (std::size_t c = 0; c < group.joints.size(); ++c) {
      for (std::size_t d = 0; d <= c; ++d) *next++ = own.mass[c][d];
      detail::each_momentum_below(system, kinematics, group.base, frame, own.momentum[c],
                                  [&](int, double momentum) { *next++ = momentum; });
    }
  }
}

}  // namespace mbgen
