#pragma once
// All frictions of a model, whatever they act on.

#include "compiler/model/model.hpp"

namespace mbgen {

/// Calls use(friction) for frictions on coordinates, then along springs, then in the ends of rods.
template <class Use>
void each_friction(const Model& model, const Use& use) {
  each_element(model, [&](const auto& element) {
    if constexpr (std::is_base_of_v<FrictionLaw, std::decay_t<decltype(element)>>) use(element);
  });
}

}  // namespace mbgen
