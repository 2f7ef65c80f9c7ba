#pragma once
// Ground that a host tells under wheels.

#include <vector>

#include "compiler/model/model.hpp"

namespace mbgen {

/// Indices of the tyres that stand on a road of a host, one a road.
std::vector<int> tyres_on_host(const Model& model);

}  // namespace mbgen
