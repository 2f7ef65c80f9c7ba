// Ride over a road: weighted vibration by ISO 2631-1, dynamic loads of tyres.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "workbench/manoeuvre/metrics.hpp"
#include "workbench/manoeuvre/metrics_fits.hpp"
#include "workbench/signals/weighting.hpp"

namespace mbgen {
namespace {

using namespace manoeuvre;

constexpr double kShortestRide = 5;  ///< s: two periods of the weighting's lowest frequency
constexpr double kMostCrest = 9;  ///< ISO 2631-1, clause 6.2: above it the weighted mean square alone is not sufficient

void add_vibration(VehicleMetrics& metrics, const VehicleSeries& s, Span span) {
  const Values part(s.vertical_acceleration.begin() + static_cast<std::ptrdiff_t>(span.begin),
                    s.vertical_acceleration.end());
  const Span all{0, part.size()};
  add(metrics, "vertical_acceleration_rms", spread(part, all, 0), "m/s^2", "root of the mean square at the place");
  if (1 / step_of(s) < least_rate(Weighting::k) * (1 - 1e-9)) {
    metrics.notes.push_back(fmt::format("weighted_acceleration_rms: {:.4g} points in a second, the weighting needs {}",
                                        1 / step_of(s), least_rate(Weighting::k)));
    return;
  }
  const Values felt = weighted(part, step_of(s), Weighting::k);
  const double rms = spread(felt, all, 0);
  add(metrics, "weighted_acceleration_rms", rms, "m/s^2", "vertical, weighted by W_k (ISO 2631-1)");
  if (!(rms > 0)) return;
  const double crest = largest(felt) / rms;
  add(metrics, "crest_factor", crest, "1", "largest weighted acceleration over its root mean square (ISO 2631-1)");
  if (crest > kMostCrest)
    metrics.notes.push_back(
        fmt::format("crest_factor: {:.3g}, above {}: single shocks, of which the weighted root mean "
                    "square says too little (ISO 2631-1)",
                    crest, kMostCrest));
}

void add_loads(VehicleMetrics& metrics, const VehicleSeries& s, Span span) {
  for (std::size_t w = 0; w < s.wheels.size(); ++w) {
    const std::string& tyre = s.wheels[w].tyre;
    const double middle = mean(s.loads[w], span);
    if (!(middle > 0)) {
      metrics.notes.push_back(fmt::format("dynamic_load_coefficient_{}: the tyre carries no load", tyre));
      continue;
    }
    add(metrics, "dynamic_load_coefficient_" + tyre, spread(s.loads[w], span, middle) / middle, "1",
        "root mean square of the load about its mean, over the mean");
  }
}

}  // namespace

double vertical_weighting(double frequency) { return std::abs(weighting_factor(Weighting::k, frequency)); }

VehicleMetrics ride_metrics(const VehicleSeries& s, const Ride& ride) {
  std::string fault = fault_of(s, {{"vertical acceleration", &s.vertical_acceleration}, {"speed", &s.speed}});
  if (fault.empty()) fault = fault_of_loads(s);
  const Span span{first_point(s, ride.begin), s.t.size()};
  if (fault.empty()) {
    const double duration = s.t.back() - std::max(ride.begin, s.t.front());
    if (duration < kShortestRide)
      fault = fmt::format("the series goes on for {:.4g} s from {:.4g} s; the weighting needs {:.4g} s",
                          std::max(duration, 0.0), ride.begin, kShortestRide);
  }
  if (!fault.empty()) return refused("ride", fault);
  VehicleMetrics metrics;
  add(metrics, "speed", mean(s.speed, span), "m/s", "mean");
  add_vibration(metrics, s, span);
  add_loads(metrics, s, span);
  return metrics;
}

}  // namespace mbgen
