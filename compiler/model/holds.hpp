#pragma once
// Places at which a solver sees whether elements hold on to their way.

#include <string>
#include <vector>

#include "compiler/model/model.hpp"

namespace mbgen {

/// Names of the places, element by element: see `holds` of the kinds.
std::vector<std::string> hold_names(const Model& model);

}  // namespace mbgen
