#pragma once
// All frictions of a model, of every kind.

#include "compiler/model/model.hpp"

namespace mbgen {

/// Calls use(friction) for frictions on coordinates, then along springs, then in rod ends.
template <class Use>
void each_friction(const Model& model, const Use& use) {
  each_element(model, [&](const auto& element) {
    if constexpr (std::is_base_of_v<FrictionLaw, std::decay_t<decltype(element)>>) use(element);
  });
}

}  // namespace mbgen
