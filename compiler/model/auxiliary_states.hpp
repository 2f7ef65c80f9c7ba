#pragma once
// Auxiliary states of a model.

#include <string>
#include <vector>

#include "compiler/model/model.hpp"

namespace mbgen {

/// An auxiliary state as tables and interfaces show it.
struct AuxiliaryState {
  std::string name, unit;
  double size = 1;  ///< usual magnitude, in its unit
};

/// The auxiliary states of a model in their order: two per tyre (longitudinal and lateral slip deflection, m), then one
/// per Maxwell branch of a bushing (extension of its spring, m or rad).
std::vector<AuxiliaryState> auxiliary_states(const Model& model);

/// Number of auxiliary states.
int auxiliary_state_count(const Model& model);

/// Number of the first of them that are slips of tyres. At rest these hold by themselves; the others then have the
/// values at which their rates vanish.
int slip_state_count(const Model& model);

/// Names of the auxiliary states.
std::vector<std::string> auxiliary_state_names(const Model& model);

}  // namespace mbgen
