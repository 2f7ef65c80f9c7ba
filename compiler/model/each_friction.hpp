#pragma once
// All frictions of a model, whatever they act on.

#include "compiler/model/model.hpp"

namespace mbgen {

/// Calls use(friction) for frictions on coordinates, then along springs, then in the ends of rods.
template <class Use>
void each_friction(const Model& model, const Use& use) {
  for (const JointFriction& friction : model.frictions) use(friction);
  for (const SpringFriction& friction : model.spring_frictions) use(friction);
  for (const RodFriction& friction : model.rod_frictions) use(friction);
}

}  // namespace mbgen
