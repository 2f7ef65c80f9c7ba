#pragma once
// Places at which a solver sees whether ropes hold on to their way.

#include <string>
#include <vector>

#include "compiler/model/model.hpp"

namespace mbgen {

/// Names of the places, rope by rope: its legs, "hoist from drum.O to load.O", which may have no way; its pulleys,
/// "hoist at load.O", off which it may lift; its spans, which may be wound up.
std::vector<std::string> rope_place_names(const Model& model);

}  // namespace mbgen
