#pragma once
// Which actuators move which free directions, and the order in which their forces are found.

#include "compiler/analysis/configuration.hpp"
#include "compiler/analysis/findings.hpp"

namespace mbgen {

/// Sets Analysis::directions, Analysis::actuation and, where actuators leave directions without a force,
/// Analysis::unactuated. Pivots are good over all closed configurations in which actuators move every direction.
void set_actuation(NumericSystem& numbers, const std::vector<Configuration>& configurations, Analysis& analysis);

}  // namespace mbgen
