// Lane change, ISO 3888-1 and ISO 3888-2.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "workbench/manoeuvre/metrics_fits.hpp"

namespace mbgen {
namespace {

using namespace manoeuvre;

/// The pose of the vehicle in the frame of the track.
struct PlanePose {
  double x = 0, y = 0, heading = 0;
};

PlanePose pose_at(const VehicleSeries& s, const LaneChange& lanes, std::size_t i) {
  const double dx = s.x[i] - lanes.x, dy = s.y[i] - lanes.y;
  const double c = std::cos(lanes.heading), k = std::sin(lanes.heading);
  return {c * dx + k * dy, -k * dx + c * dy, s.heading[i] - lanes.heading};
}

/// Distance of the body beyond a limit of a section, negative inside: the largest over the body's corners within the
/// section and the section's ends beside the body.
double excess_of(const LaneSection& section, const PlanePose& pose, const LaneChange& lanes) {
  double most = -std::numeric_limits<double>::infinity();
  const double c = std::cos(pose.heading), k = std::sin(pose.heading);
  for (const double along : {lanes.front, -lanes.rear}) {
    for (const double side : {lanes.to_left, -lanes.to_right}) {
      const double x = pose.x + c * along - k * side, y = pose.y + k * along + c * side;
      if (x >= section.from && x <= section.to) most = std::max({most, y - section.left, section.right - y});
    }
  }
  for (const double x : {section.from, section.to}) {
    const auto local = [&](double y) {
      return std::pair(c * (x - pose.x) + k * (y - pose.y), -k * (x - pose.x) + c * (y - pose.y));
    };
    const auto [along_left, left] = local(section.left);
    const auto [along_right, right] = local(section.right);
    if (along_left >= -lanes.rear && along_left <= lanes.front) most = std::max(most, lanes.to_left - left);
    if (along_right >= -lanes.rear && along_right <= lanes.front) most = std::max(most, right + lanes.to_right);
  }
  return most;
}

std::string fault_of_lanes(const VehicleSeries& s, const LaneChange& lanes) {
  const std::string fault = fault_of(s, {{"x", &s.x},
                                         {"y", &s.y},
                                         {"heading", &s.heading},
                                         {"speed", &s.speed},
                                         {"lateral speed", &s.lateral_speed},
                                         {"lateral acceleration", &s.lateral_acceleration},
                                         {"yaw rate", &s.yaw_rate},
                                         {"roll angle", &s.roll}});
  if (!fault.empty()) return fault;
  if (lanes.sections.empty()) return "the track has no sections";
  for (const LaneSection& section : lanes.sections) {
    if (!(section.from < section.to) || !(section.right < section.left))
      return fmt::format("a section of the track from {:.4g} to {:.4g} m, with limits at {:.4g} and {:.4g} m, is empty",
                         section.from, section.to, section.left, section.right);
  }
  return "";
}

/// Time and speed at which the reference point passes an x of the track.
struct Passage {
  double time = 0, speed = 0;
};

std::optional<Passage> passage(const VehicleSeries& s, const std::vector<PlanePose>& poses, double x) {
  for (std::size_t i = 1; i < poses.size(); ++i) {
    if (!(poses[i - 1].x < x && poses[i].x >= x)) continue;
    const double share = (x - poses[i - 1].x) / (poses[i].x - poses[i - 1].x);
    const auto speed = [&](std::size_t k) { return std::hypot(s.speed[k], s.lateral_speed[k]); };
    return Passage{s.t[i - 1] + share * (s.t[i] - s.t[i - 1]), speed(i - 1) + share * (speed(i) - speed(i - 1))};
  }
  return std::nullopt;
}

void add_speeds(VehicleMetrics& metrics, const VehicleSeries& s, const std::vector<PlanePose>& poses,
                const LaneChange& lanes) {
  const double first = lanes.sections.front().from, last = lanes.sections.back().to;
  const std::optional<Passage> entry = passage(s, poses, first), exit = passage(s, poses, last);
  if (entry) {
    add(metrics, "entry_speed", entry->speed, "m/s", "where the reference point enters the first section (ISO 3888)");
  } else {
    metrics.notes.push_back(fmt::format("entry_speed: the vehicle does not pass the track's begin at {:.4g} m", first));
  }
  if (exit) {
    add(metrics, "exit_speed", exit->speed, "m/s", "where the reference point leaves the last section (ISO 3888)");
  } else {
    metrics.notes.push_back(fmt::format("exit_speed: the vehicle does not pass the track's end at {:.4g} m", last));
  }
  if (entry && exit)
    add(metrics, "mean_speed", (last - first) / (exit->time - entry->time), "m/s",
        "length of the track over the time between its ends");
}

void add_excess(VehicleMetrics& metrics, const VehicleSeries& s, const std::vector<PlanePose>& poses,
                const LaneChange& lanes) {
  double most = -std::numeric_limits<double>::infinity(), at = 0;
  std::size_t where = 0;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    for (std::size_t k = 0; k < lanes.sections.size(); ++k) {
      const double excess = excess_of(lanes.sections[k], poses[i], lanes);
      if (excess > most) most = excess, at = s.t[i], where = k;
    }
  }
  if (!std::isfinite(most)) return metrics.notes.push_back("lane_excess: the body is within no section of the track");
  add(metrics, "lane_excess", most, "m",
      "how far the body comes beyond a limit of its lane; below zero: how far it keeps away (ISO 3888)");
  if (most > 0)
    metrics.notes.push_back(
        fmt::format("the body leaves its lane by {:.3g} m in section {} at {:.4g} s", most, where + 1, at));
}

void add_diagram(VehicleMetrics& metrics, const std::vector<PlanePose>& poses, const LaneChange& lanes) {
  DiagramCurve path{"reference point", {}, {}}, left{"left limits", {}, {}}, right{"right limits", {}, {}};
  for (const PlanePose& pose : poses) path.x.push_back(pose.x), path.y.push_back(pose.y);
  const double gap = std::nan("");
  for (const LaneSection& section : lanes.sections) {
    for (auto [curve, y] : {std::pair(&left, section.left), {&right, section.right}}) {
      curve->x.insert(curve->x.end(), {section.from, section.to, section.to});
      curve->y.insert(curve->y.end(), {y, y, gap});
    }
  }
  metrics.diagrams.push_back({"Path", {"x", "m"}, {"y", "m"}, {path, left, right}});
}

}  // namespace

VehicleMetrics lane_change_metrics(const VehicleSeries& s, const LaneChange& lanes) {
  if (const std::string fault = fault_of_lanes(s, lanes); !fault.empty()) return refused("lane change", fault);
  VehicleMetrics metrics;
  std::vector<PlanePose> poses;
  for (std::size_t i = 0; i < s.t.size(); ++i) poses.push_back(pose_at(s, lanes, i));
  add_speeds(metrics, s, poses, lanes);
  add_excess(metrics, s, poses, lanes);
  add(metrics, "largest_lateral_acceleration", largest(s.lateral_acceleration), "m/s^2", "either side");
  add(metrics, "largest_yaw_rate", largest(s.yaw_rate), "rad/s", "either side");
  add(metrics, "largest_roll", largest(s.roll), "rad", "either side");
  add_diagram(metrics, poses, lanes);
  return metrics;
}

}  // namespace mbgen
