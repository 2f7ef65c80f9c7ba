#pragma once
// Tangents of the user's states.

#include "compiler/formulation/elements/element_tangents.hpp"

namespace mbgen {
namespace detail {

/// The user's states, each as an element without a force.
template <class T>
void state_tangents(ForceWork<T>& work, std::vector<ElementTangents<T>>& elements) {
  using S = Slope<T>;
  const Model& model = work.system.model;
  for (std::size_t i = 0; i < model.states.size(); ++i) {
    const auto heading = work.system.annotator.within(OwnerKind::state, i);
    const UserState& state = model.states[i];
    elements.push_back(differentiated<T>(
        work, {{}, {first_user_state(model) + static_cast<int>(i)}, {}, {state.derivative.expression}},
        [&](const LawPoint<S>&) {
          return LawResult<S>{{}, {number<S>(work, state.derivative, "rate", state.name)}};
        }));
  }
}

}  // namespace detail
}  // namespace mbgen
