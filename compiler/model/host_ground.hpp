#pragma once
// Ground under wheels given by a host program.

#include <vector>

#include "compiler/model/model.hpp"

namespace mbgen {

/// Indices of the tyres on roads given by a host, one per road.
std::vector<int> tyres_on_host(const Model& model);

}  // namespace mbgen
