#pragma once
// Curves of a rig as targets of a fit.

#include <string>
#include <vector>

#include "workbench/fit/fit_motion.hpp"
#include "workbench/search/rig.hpp"

namespace mbgen::fit {

/// Reads points of a rig's curve: the file's name tells axle and curve. reports: of axles that were read before. Units
/// of the channels become those of the rig. Fails: UserError with file and line, as read_run; for an axle, curve or
/// column that the rig lacks.
MeasuredFile read_rig(const MeasuredTable& table, const FreeModel& model, RigReports& reports,
                      std::vector<Channel>& channels, bool is_held_out, std::vector<std::string>& notes);

/// The columns of the rig's curve at values of the unknowns.
Outcome rig_curve(const FreeModel& model, const MeasuredFile& file, const std::vector<Channel>& channels,
                  const std::vector<Unknown>& unknowns, const std::vector<double>& values);

}  // namespace mbgen::fit
