#include "workbench/manoeuvre/manoeuvre_metrics.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "workbench/manoeuvre/metrics_fits.hpp"

namespace mbgen {
namespace {

constexpr double kRounding = 1e-6;  // s

/// Points of the series from an instant on.
VehicleSeries from(VehicleSeries series, double begin) {
  const auto first = std::lower_bound(series.t.begin(), series.t.end(), begin) - series.t.begin();
  const auto cut = [first](std::vector<double>& values) { values.erase(values.begin(), values.begin() + first); };
  for (std::vector<double> VehicleSeries::*values :
       {&VehicleSeries::t, &VehicleSeries::x, &VehicleSeries::y, &VehicleSeries::heading, &VehicleSeries::speed,
        &VehicleSeries::lateral_speed, &VehicleSeries::longitudinal_acceleration, &VehicleSeries::lateral_acceleration,
        &VehicleSeries::vertical_acceleration, &VehicleSeries::yaw_rate, &VehicleSeries::roll, &VehicleSeries::pitch,
        &VehicleSeries::steer})
    cut(series.*values);
  for (std::vector<double>& loads : series.loads) cut(loads);
  series.towed = {};
  return series;
}

struct Measures {
  const Plan& plan;
  const VehicleFacts& facts;
  const Vehicle& vehicle;
  const PlaneMotion& start;
  const VehicleSeries& series;

  VehicleMetrics operator()(const EventManoeuvre&) const { return {}; }
  VehicleMetrics operator()(const CircleManoeuvre& circle) const {
    SteadyCircle asked{.kind = static_cast<SteadyCircle::Kind>(circle.method),
                       .wheelbase = facts.wheelbase,
                       .radius = circle.radius.value_or(0),
                       .steering_ratio = vehicle.steer_ratio,
                       .tracks = facts.tracks};
    VehicleMetrics metrics = steady_circle_metrics(from(series, plan.begin), asked);
    const double most = manoeuvre::largest(series.lateral_acceleration);
    const bool is_whole = !circle.duration && series.t.back() >= plan.duration - kRounding;
    if (circle.method == CircleManoeuvre::Method::steer && !circle.last_speed && is_whole &&
        most < circle.largest_lateral_acceleration)
      metrics.notes.push_back(
          fmt::format("the circle ends at {:.4g} m/s, with {:.3g} m/s^2 of the {:g} m/s^2 that would end it: give "
                      "\"last_speed\" for more",
                      series.speed.back(), most, circle.largest_lateral_acceleration));
    return metrics;
  }
  VehicleMetrics operator()(const StepManoeuvre&) const { return step_steer_metrics(series, {}); }
  VehicleMetrics operator()(const SweepManoeuvre& sweep) const {
    return sine_sweep_metrics(series, {.lowest = sweep.first_frequency, .highest = sweep.last_frequency});
  }
  VehicleMetrics operator()(const LaneManoeuvre& lanes) const {
    const double half = lanes.width.value_or(vehicle.width.value_or(0)) / 2;
    // The contour is the contour of the first unit: towed units are not checked against the lanes.
    const double rear = vehicle.towed.body < 0 ? facts.rear : facts.wheelbase - facts.front;
    return lane_change_metrics(series, {.sections = plan.sections,
                                        .x = start.x,
                                        .y = start.y,
                                        .heading = start.heading,
                                        .front = std::max(0.0, facts.front),
                                        .rear = std::max(0.0, rear),
                                        .to_left = half,
                                        .to_right = half});
  }
  VehicleMetrics operator()(const WeaveManoeuvre& weave) const {
    const double end = plan.begin + weave.cycles / weave.frequency;
    return weave_metrics(from(series, plan.begin), {.frequency = weave.frequency, .end = end});
  }
  VehicleMetrics operator()(const DwellManoeuvre& dwell) const {
    return dwell_metrics(series, {.begin = dwell.at, .frequency = dwell.frequency, .dwell = dwell.dwell});
  }
  VehicleMetrics operator()(const BrakingManoeuvre& braking) const { return braking_metrics(series, {braking.at}); }
  VehicleMetrics operator()(const TrackManoeuvre&) const { return track_metrics(series); }
  VehicleMetrics operator()(const StartManoeuvre& start) const { return start_metrics(series, {start.at}); }
  VehicleMetrics operator()(const RideManoeuvre&) const { return ride_metrics(series, {plan.begin}); }
};

}  // namespace

VehicleMetrics metrics_of(const Manoeuvre& manoeuvre, const Plan& plan, const VehicleFacts& facts,
                          const Vehicle& vehicle, const PlaneMotion& start, const VehicleSeries& series) {
  const double end = series.t.empty() ? 0 : series.t.back();
  if (end <= plan.begin)
    return {.notes = {fmt::format("no numbers: the metrics begin at {:.4g} s, and the motion ends at {:.4g} s",
                                  plan.begin, end)}};
  VehicleMetrics metrics = std::visit(Measures{plan, facts, vehicle, start, series}, manoeuvre);
  const bool turns = !std::holds_alternative<BrakingManoeuvre>(manoeuvre) &&
                     !std::holds_alternative<RideManoeuvre>(manoeuvre) &&
                     !std::holds_alternative<StartManoeuvre>(manoeuvre);
  if (vehicle.towed.body < 0 || !turns) return metrics;
  const auto* circle = std::get_if<CircleManoeuvre>(&manoeuvre);
  VehicleMetrics towing =
      towing_metrics(series, {.front = facts.front,
                              .towed_rear = facts.towed_rear,
                              .is_circle = circle && circle->method == CircleManoeuvre::Method::radius,
                              .begin = plan.begin});
  const auto append = [](auto& all, auto& more) { all.insert(all.end(), more.begin(), more.end()); };
  append(metrics.values, towing.values);
  append(metrics.diagrams, towing.diagrams);
  append(metrics.notes, towing.notes);
  return metrics;
}

}  // namespace mbgen
