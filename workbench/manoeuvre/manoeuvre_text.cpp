// Result of a manoeuvre as text and as JSON.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "compiler/text/json_text.hpp"
#include "workbench/manoeuvre/manoeuvre_metrics.hpp"
#include "workbench/manoeuvre/manoeuvre_run.hpp"
#include "workbench/manoeuvre/metrics_text.hpp"

namespace mbgen {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kSpeedMissed = 0.05;  // of the speed at the start

/// Both limits of each section, from its beginning to its end, in the world: lists of [x, y], m.
Json lanes_json(const std::vector<LaneSection>& sections, const PlaneMotion& start) {
  const double c = std::cos(start.heading), s = std::sin(start.heading);
  const auto place = [&](double x, double y) {
    return Json::array({start.x + c * x - s * y, start.y + s * x + c * y});
  };
  Json lanes = Json::array();
  for (const LaneSection& section : sections)
    lanes.push_back({{"left", Json::array({place(section.from, section.left), place(section.to, section.left)})},
                     {"right", Json::array({place(section.from, section.right), place(section.to, section.right)})}});
  return lanes;
}

/// The course of the driver as a list of [x, y], m, from the start to `end`, m.
Json course_json(const Path& path, double end) {
  constexpr int kMostPoints = 400;
  constexpr double kBetween = 1;  // m
  const int count = std::clamp(static_cast<int>(end / kBetween), 1, kMostPoints);
  Json points = Json::array();
  for (int i = 0; i <= count; ++i) {
    const PathPoint point = path.at(end * i / count);
    points.push_back(Json::array({point.x, point.y}));
  }
  return points;
}

}  // namespace

double ManoeuvreRun::widest_offset() const {
  return std::holds_alternative<CircleManoeuvre>(manoeuvre_) ? kCircleLeft : kLaneLeft;
}

void ManoeuvreRun::judge(StepVerdict& verdict) const {
  for (std::size_t i = 0; i < lifted_.size(); ++i)
    if (lifted_[i] >= 0)
      verdict.warnings.push_back(
          fmt::format("tyre \"{}\" leaves the road, first at t = {:.6g} s", series_.wheels[i].tyre, lifted_[i]));
  if (!steering_fault_.empty()) verdict.warnings.push_back(steering_fault_);
  for (std::string& warning : watch_.warnings(widest_offset())) verdict.warnings.push_back(std::move(warning));
  const bool is_circle = std::holds_alternative<CircleManoeuvre>(manoeuvre_);
  if (is_circle && largest_offset_ > kCircleLeft)
    verdict.warnings.push_back(
        fmt::format("the driver leaves the circle by up to {:.3g} m: \"driver\": {{ \"understeer\": ... }} lets him "
                    "know the vehicle",
                    largest_offset_));
  const std::optional<double>& speed = base_of(manoeuvre_).speed;
  if (speed && largest_speed_error_ > kSpeedMissed * *speed)
    verdict.warnings.push_back(
        fmt::format("the speed differs from the wanted one by up to {:.3g} m/s", largest_speed_error_));
}

VehicleMetrics ManoeuvreRun::metrics() const {
  VehicleMetrics metrics = metrics_of(manoeuvre_, plan_, facts_, vehicle_, start_, series_);
  double before = 0;
  for (std::size_t lap = 0; lap < laps_.size(); ++lap) {
    metrics.values.push_back(
        {fmt::format("lap_time_{}", lap + 1), laps_[lap] - before, "s", "from the start line to itself"});
    before = laps_[lap];
  }
  return metrics;
}

std::vector<VehicleMetric> ManoeuvreRun::numbers() const {
  std::vector<VehicleMetric> list;
  if (base_of(manoeuvre_).driver.learns) {
    list.push_back({"learned_understeer", base_of(manoeuvre_).driver.understeer, "rad s^2/m", "of the vehicle"});
    list.push_back({"learned_steer_ratio", vehicle_.steer_ratio, "1", "of the vehicle"});
  }
  if (plan_.has_driver) list.push_back({"largest_offset", largest_offset_, "m", "from the course"});
  if (plan_.torques.front().holds_speed) list.push_back({"largest_speed_error", largest_speed_error_, "m/s", ""});
  const VehicleMetrics of_standard = metrics();
  list.insert(list.end(), of_standard.values.begin(), of_standard.values.end());
  return list;
}

ManoeuvreWords ManoeuvreRun::words() const {
  const VehicleMetrics metrics = this->metrics();
  ManoeuvreWords words;
  words.lines = fmt::format("  manoeuvre                 {} ({}){}\n", type_of(manoeuvre_), file_,
                            ended_.empty() ? "" : ", ended when " + ended_);
  Json manoeuvre = {{"file", file_}, {"type", type_of(manoeuvre_)}, {"ended", ended_.empty() ? Json() : Json(ended_)}};
  if (const DriverSettings& driver = base_of(manoeuvre_).driver; driver.learns) {
    words.lines += fmt::format("    driver learned          understeer {:.4g} rad s^2/m, steer_ratio {:g}\n",
                               driver.understeer, vehicle_.steer_ratio);
    manoeuvre["learned"] = {{"understeer", driver.understeer}, {"steer_ratio", vehicle_.steer_ratio}};
  }
  if (plan_.has_driver) {
    words.lines += fmt::format("    course followed within  {:.4g} m\n", largest_offset_);
    manoeuvre["largest_offset"] = largest_offset_;
    if (place_.way > 0) manoeuvre["course"] = course_json(path_, place_.way);
    if (!plan_.sections.empty()) manoeuvre["lanes"] = lanes_json(plan_.sections, start_);
  }
  if (plan_.torques.front().holds_speed) {
    words.lines += fmt::format("    speed held within       {:.4g} m/s\n", largest_speed_error_);
    manoeuvre["largest_speed_error"] = largest_speed_error_;
  }
  Json lifted = Json::object();
  for (std::size_t i = 0; i < lifted_.size(); ++i)
    if (lifted_[i] >= 0) lifted[series_.wheels[i].tyre] = lifted_[i];
  manoeuvre["wheels_without_load_since"] = lifted;
  Json run = {{"manoeuvre", manoeuvre}};
  if (!std::holds_alternative<EventManoeuvre>(manoeuvre_) || vehicle_.towed.body >= 0) add_metrics(run, metrics);
  words.lines += metrics_text(metrics);
  words.members = json_text(run);
  return words;
}

}  // namespace mbgen
