#pragma once
// Selection of the metrics of the standards for a manoeuvre.

#include "workbench/manoeuvre/metrics.hpp"
#include "workbench/manoeuvre/plan.hpp"

namespace mbgen {

/// Metrics of a completed manoeuvre; none for events. start: the first position.
VehicleMetrics metrics_of(const Manoeuvre& manoeuvre, const Plan& plan, const VehicleFacts& facts,
                          const Vehicle& vehicle, const PlaneMotion& start, const VehicleSeries& series);

}  // namespace mbgen
