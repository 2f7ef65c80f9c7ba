#pragma once
// Tangents of all force elements.

#include "compiler/formulation/elements/bushing_tangents.hpp"
#include "compiler/formulation/elements/force_tangents.hpp"
#include "compiler/formulation/elements/tyre_tangents.hpp"

namespace mbgen {

/// Tangents of all force elements and user-defined states; elements that share such a state are one. Forces and torques
/// on bodies count as given unless they depend on states. Requires: v about the origins of frames. Cost: linear in the
/// number of elements.
template <class T>
std::vector<ElementTangents<T>> force_tangents(System<T>& system, const Kinematics<T>& k, const Velocities<T>& v) {
  see_states_and_lengths(system, k, v);  // that laws look at
  AppliedForces<T> none;
  none.about = v.about;
  detail::ForceWork<T> work{system, k, v, none};
  std::vector<ElementTangents<T>> elements;
  detail::spring_tangents(work, elements);
  detail::joint_tangents(work, elements);
  detail::friction_tangents(work, elements);
  detail::tyre_tangents(work, elements);
  detail::bushing_tangents(work, elements);
  detail::bump_stop_tangents(work, elements);
  detail::body_force_tangents(work, elements);
  detail::state_tangents(work, elements);
  return detail::joined_by_states(std::move(elements));
}

}  // namespace mbgen
