#pragma once
// Metrics as text and as JSON of the description of a run.

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "workbench/manoeuvre/metrics.hpp"

namespace mbgen {

/// A line for each value, in degrees instead of radians, then the notes.
std::string metrics_text(const VehicleMetrics& metrics);

/// Adds "metrics", "diagrams" and "metric_notes" to the description of a run, as `mbgen report` reads them. Values are
/// in SI units; curves keep at most 500 points.
void add_metrics(nlohmann::ordered_json& run, const VehicleMetrics& metrics);

}  // namespace mbgen
