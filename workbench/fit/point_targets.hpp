#pragma once
// Single numbers of the model at its start as targets of a fit: outputs, as the loads of standing wheels, and modes.

#include <string>
#include <vector>

#include "workbench/fit/fit_model.hpp"

namespace mbgen::fit {

/// Targets as a file of single values; adds their channels. texts: start:OUTPUT=VALUE:SIGMA,
/// mode:K:frequency=VALUE:SIGMA (Hz, undamped) or mode:K:damping=VALUE:SIGMA (of the critical one), with the
/// oscillations numbered from 1 by increasing frequency, in SI units. Fails: UserError.
MeasuredFile point_targets(const Model& model, const std::vector<std::string>& texts, std::vector<Channel>& channels);

/// The numbers at values of the unknowns.
Outcome point_values(const FitModel& model, const MeasuredFile& file, const std::vector<Channel>& channels,
                     const std::vector<Unknown>& unknowns, const std::vector<double>& values);

}  // namespace mbgen::fit
