#include "workbench/manoeuvre/metrics_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

namespace mbgen {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kMostPoints = 500;  ///< of a curve, sufficient for a diagram

/// A value for people, in degrees instead of radians.
std::string shown(const VehicleMetric& metric) {
  constexpr double kDegrees = 180 / std::numbers::pi;
  double value = metric.value;
  std::string unit = metric.unit == "1" ? "" : metric.unit;
  if (unit.starts_with("rad")) {
    value *= kDegrees, unit.replace(0, 3, "deg");
  } else if (unit.ends_with("/rad")) {
    value /= kDegrees, unit.replace(unit.size() - 3, 3, "deg");
  }
  return fmt::format("{:>12.5g}{}{}", value, unit.empty() ? "" : " ", unit);
}

Json numbers(const std::vector<double>& values) {
  const std::size_t every = (values.size() + kMostPoints - 1) / kMostPoints;
  Json list = Json::array();
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (i % std::max<std::size_t>(every, 1) != 0 && i + 1 != values.size()) continue;
    // Six digits are sufficient for a diagram.
    list.push_back(std::isfinite(values[i]) ? Json(std::stod(fmt::format("{:.6g}", values[i]))) : Json(nullptr));
  }
  return list;
}

Json heading(const Heading& of) { return {{"name", of.name}, {"unit", of.unit}}; }

}  // namespace

std::string metrics_text(const VehicleMetrics& metrics) {
  std::string text;
  for (const VehicleMetric& metric : metrics.values) text += fmt::format("  {:<36}{}\n", metric.name, shown(metric));
  for (const std::string& note : metrics.notes) text += fmt::format("note: {}\n", note);
  return text;
}

void add_metrics(Json& run, const VehicleMetrics& metrics) {
  Json values = Json::array(), diagrams = Json::array();
  for (const VehicleMetric& metric : metrics.values)
    values.push_back(
        {{"name", metric.name}, {"value", metric.value}, {"unit", metric.unit}, {"meaning", metric.meaning}});
  for (const Diagram& diagram : metrics.diagrams) {
    Json curves = Json::array();
    for (const DiagramCurve& curve : diagram.curves)
      curves.push_back({{"name", curve.name}, {"x", numbers(curve.x)}, {"y", numbers(curve.y)}});
    diagrams.push_back(
        {{"title", diagram.title}, {"x", heading(diagram.x)}, {"y", heading(diagram.y)}, {"curves", curves}});
  }
  run["metrics"] = values;
  run["diagrams"] = diagrams;
  run["metric_notes"] = metrics.notes;
}

}  // namespace mbgen
