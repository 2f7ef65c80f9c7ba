#pragma once
// Curves of a rig as targets of a fit.

#include <string>
#include <vector>

#include "workbench/fit/fit_data.hpp"
#include "workbench/search/rig.hpp"

namespace mbgen::fit {

/// Reads points of a rig's curve: the file's name tells axle and curve. reports: of axles that were read before. Units
/// of the channels become those of the rig. Fails: UserError with file and line, as read_run; for an axle, curve or
/// column that the rig lacks.
MeasuredFile read_rig(const MeasuredTable& table, const FreeModel& model, RigReports& reports,
                      std::vector<Channel>& channels, bool is_held_out, std::vector<std::string>& notes);

/// A channel of a rig's curve, or a single number, as a measure.
Measure measure_of(const MeasuredFile& file, const MeasuredChannel& measured, const Channel& channel);

}  // namespace mbgen::fit
