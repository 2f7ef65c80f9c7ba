#pragma once
// Which actuators move which free directions, and the order in which their forces are found.

#include "compiler/analysis/configuration.hpp"
#include "compiler/analysis/findings.hpp"

namespace mbgen {

/// Sets Analysis::actuation and, where actuators leave free directions without a force, Analysis::unactuated. Pivots
/// are good over all closed configurations in which actuators move every direction. names: coordinates of the free
/// directions.
void set_actuation(NumericSystem& numbers, const std::vector<Configuration>& configurations,
                   const std::vector<int>& names, Analysis& analysis);

}  // namespace mbgen
