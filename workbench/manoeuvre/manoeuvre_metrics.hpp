#pragma once
// Which metrics of the standards belong to a manoeuvre.

#include "workbench/manoeuvre/metrics.hpp"
#include "workbench/manoeuvre/plan.hpp"

namespace mbgen {

/// Metrics of a manoeuvre that was driven; none of events. start: the place where it began.
VehicleMetrics metrics_of(const Manoeuvre& manoeuvre, const Plan& plan, const VehicleFacts& facts,
                          const Vehicle& vehicle, const PlaneMotion& start, const VehicleSeries& series);

}  // namespace mbgen
