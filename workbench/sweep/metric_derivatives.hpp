#pragma once
// Exact derivatives of metrics by a parameter, from the derivatives of the sampled quantities.

#include "workbench/sweep/metric.hpp"

namespace mbgen {

/// The reason why the metrics have no exact derivatives by parameters: they read a coordinate or velocity beside the
/// model's outputs, or a parameter that depends on others; "" where they have them.
std::string why_no_derivatives(const Metrics& metrics, const std::vector<Parameter>& parameters);

/// d metric / d parameter for all metrics, of the metrics as they are computed: sampled, by trapezoids, a largest value
/// at its point. slopes: of the points, in the same order. Requires: why_no_derivatives is "".
std::vector<double> derivatives_by(const Metrics& metrics, const std::string& parameter,
                                   const std::vector<Parameter>& parameters, const MetricPoints& points,
                                   const MetricPoints& slopes);

}  // namespace mbgen
