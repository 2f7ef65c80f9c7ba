#pragma once
// Generalised forces on coordinates.

#include "compiler/formulation/elements/element_tangents.hpp"

namespace mbgen {
namespace detail {

template <class T>
void apply(ForceWork<T>& work, const JointForce& force) {
  add_joint_force(work, force.joint, work.value(force.force, "force", force.name));
}

template <>
inline constexpr int kTangentPass<JointForce> = 0;

template <class T>
void add_tangents(ForceWork<T>& work, const JointForce& force, std::vector<ElementTangents<T>>& elements) {
  using S = Slope<T>;
  elements.push_back(differentiated<T>(work, {{tree_local(work.system, force.joint)}, {}, {}, {force.force.expression}},
                                       [&](const LawPoint<S>&) {
                                         return LawResult<S>{{number<S>(work, force.force, "force", force.name)}, {}};
                                       }));
}

}  // namespace detail
}  // namespace mbgen
