#pragma once
// Tangents of all force elements.

#include "compiler/formulation/elements/applied_forces.hpp"
#include "compiler/formulation/elements/tyre_tangents.hpp"
#include "compiler/formulation/elements/user_state_tangents.hpp"

namespace mbgen {

/// Tangents of all force elements and user-defined states; elements that share such a state are one. Forces and torques
/// on bodies count as given unless they depend on states. Requires: v about the origins of frames. Cost: linear in the
/// number of elements.
template <class T>
std::vector<ElementTangents<T>> force_tangents(System<T>& system, const Kinematics<T>& k, const Velocities<T>& v) {
  see_values(system, k, v);  // that laws look at
  AppliedForces<T> none;
  none.about = v.about;
  detail::ForceWork<T> work{system, k, v, none};
  std::vector<ElementTangents<T>> elements;
  for (int pass = 0; pass < detail::kTangentPasses; ++pass)
    each_element(system.model, [&](const auto& element) {
      if constexpr (requires { add_tangents(work, element, elements); }) {
        if (detail::kTangentPass<std::decay_t<decltype(element)>> != pass) return;
        const auto heading = within(system, element);
        add_tangents(work, element, elements);
      }
    });
  detail::state_tangents(work, elements);
  return detail::joined_by_states(std::move(elements));
}

}  // namespace mbgen
