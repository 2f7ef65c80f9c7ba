#pragma once
// Auxiliary states of a model.

#include <string>
#include <vector>

#include "compiler/model/model.hpp"

namespace mbgen {

/// Number of auxiliary states of a model: two per tyre (longitudinal and lateral slip deflection, m), then one per
/// friction with a bristle, on coordinates (its deflection, rad or m) and along springs (m).
int auxiliary_state_count(const Model& model);

/// Names of the auxiliary states.
std::vector<std::string> auxiliary_state_names(const Model& model);

/// Their units.
std::vector<std::string> auxiliary_state_units(const Model& model);

/// The first state of the bristles.
inline int first_bristle(const Model& model) { return 2 * static_cast<int>(model.tyres.size()); }

}  // namespace mbgen
