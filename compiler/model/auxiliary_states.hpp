#pragma once
// Auxiliary states of a model.

#include <string>
#include <vector>

#include "compiler/model/model.hpp"

namespace mbgen {

/// Number of auxiliary states of a model: two per tyre (longitudinal and lateral slip deflection, m).
int auxiliary_state_count(const Model& model);

/// Names of the auxiliary states.
std::vector<std::string> auxiliary_state_names(const Model& model);

}  // namespace mbgen
