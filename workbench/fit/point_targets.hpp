#pragma once
// Single numbers of the model as targets of a fit: outputs at the start, as the loads of standing wheels, modes,
// figures of rigs, metrics of motions and of manoeuvres.

#include <string>
#include <vector>

#include "workbench/fit/fit_data.hpp"

namespace mbgen::fit {

/// Targets as a file of single values; adds their channels. texts: MEASURE=VALUE:SIGMA, measures as read_measure has
/// them, in SI units. Fails: UserError.
MeasuredFile point_targets(const Model& model, const std::vector<std::string>& texts,
                           const std::vector<std::string>& manoeuvres, std::vector<Channel>& channels);

}  // namespace mbgen::fit
