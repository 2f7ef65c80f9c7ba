#include "runtime/generic/tree_mass.hpp"

#include <algorithm>

namespace mbgen {
namespace {

/// Whether a rod with mass may join branches of a group.
bool has_heavy_rods(const Model& model, const Topology& topology, const JointGroup& group) {
  if (group.block < 0) return false;
  const std::vector<int>& loops = topology.blocks[group.block].loops;
  return std::any_of(loops.begin(), loops.end(), [&](int l) {
    const Loop& loop = topology.loops[l];
    return loop.kind == ClosureKind::rod &&
           (model.rods[loop.rod].mass.expression >= 0 || model.rods[loop.rod].mass.value != 0);
  });
}

/// Calls use(joint) for the joints of a joint's own group on its path to the base, itself first.
template <class Use>
void each_of_group_below(const Topology& topology, int joint, int base, const Use& use) {
  for (int j = joint; j != base; j = topology.bodies[j].parent)
    if (topology.group_of[j] == topology.group_of[joint]) use(j);
}

}  // namespace

TreeMass tree_mass_pattern(const Model& model, const Topology& topology) {
  TreeMass mass;
  for (const JointGroup& group : topology.groups) {
    mass.all_with_all.push_back(has_heavy_rods(model, topology, group));
    for (std::size_t c = 0; c < group.joints.size(); ++c) {
      if (mass.all_with_all.back())
        mass.column.insert(mass.column.end(), group.joints.begin(), group.joints.begin() + static_cast<long>(c) + 1);
      else
        each_of_group_below(topology, group.joints[c], group.base, [&](int j) { mass.column.push_back(j); });
      for (int j = group.base; j != kGround; j = topology.bodies[j].parent) mass.column.push_back(j);
      mass.row.resize(mass.column.size(), group.joints[c]);
    }
  }
  mass.value.resize(mass.row.size());
  return mass;
}

void tree_mass_matrix(System<double>& system, const Kinematics<double>& kinematics, const Inertias<double>& inertias,
                      TreeMass& mass) {
  if (mass.all_with_all.empty()) mass = tree_mass_pattern(system.model, system.topology);
  auto next = mass.value.begin();
  const auto add_below = [&](const JointGroup& group, const Spatial<double>& momentum) {
    mbgen::detail::each_momentum_below(system, kinematics, group.base,
                                       system.layout.bodies[group.joints[0]].joint_frame, momentum,
                                       [&](int, double below) { *next++ = below; });
  };
  for (std::size_t g = 0; g < system.topology.groups.size(); ++g) {
    const JointGroup& group = system.topology.groups[g];
    if (mass.all_with_all[g]) {
      const detail::GroupMass<double> own = detail::group_mass(system, kinematics, inertias, group);
      for (std::size_t c = 0; c < group.joints.size(); ++c) {
        for (std::size_t d = 0; d <= c; ++d) *next++ = own.mass[c][d];
        add_below(group, own.momentum[c]);
      }
      continue;
    }
    for (const int i : group.joints) {
      const Spatial<double> momentum = inertias.of_joint(system.layout, i) * kinematics.column[i];
      each_of_group_below(system.topology, i, group.base,
                          [&](int j) { *next++ = dot(kinematics.column[j], momentum); });
      add_below(group, momentum);
    }
  }
}

}  // namespace mbgen
