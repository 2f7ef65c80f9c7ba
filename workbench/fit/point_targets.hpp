#pragma once
// Single numbers of the model as targets of a fit: outputs at the start, as the loads of standing wheels, modes,
// figures of rigs, metrics of motions and of manoeuvres.

#include <string>
#include <vector>

#include "workbench/fit/fit_motion.hpp"
#include "workbench/search/measure_sources.hpp"

namespace mbgen::fit {

/// Targets as a file of single values; adds their channels. texts: MEASURE=VALUE:SIGMA, measures as read_measure has
/// them, in SI units. Fails: UserError.
MeasuredFile point_targets(const Model& model, const std::vector<std::string>& texts,
                           const std::vector<std::string>& manoeuvres, std::vector<Channel>& channels);

/// The work that gives the targets. Requires: prepare(model). Fails: UserError.
MeasureSet sources_of_targets(const FreeModel& model, const MeasuredFile& file, const std::vector<Channel>& channels,
                              const std::vector<Unknown>& unknowns, const std::vector<std::string>& manoeuvres);

/// The numbers at values of the unknowns.
Outcome point_values(const FreeModel& model, const MeasureSet& set, const std::vector<Unknown>& unknowns,
                     const std::vector<double>& values, const std::function<bool()>& is_stopped);

}  // namespace mbgen::fit
