#include "workbench/motion/road_watch.hpp"

#include <fmt/format.h>

#include <cmath>

#include "compiler/formats/crg_road.hpp"
#include "compiler/model/vectors.hpp"

namespace mbgen {
namespace {

/// Global place of a tyre's centre.
Vector3 centre_of(const Model& model, const Tyre& tyre, const std::vector<Pose>& poses) {
  const auto body = static_cast<std::size_t>(tyre.centre.body), point = static_cast<std::size_t>(tyre.centre.point);
  const Vector3Quantity& arm = model.bodies[body].points[point].position;
  return to_global(poses[body], {arm[0].value, arm[1].value, arm[2].value});
}

/// A global place in u and v of a road.
CrgPlace on_road(const Road& road, const RoadGrid& grid, const Vector3& place) {
  const double c = std::cos(road.heading), s = std::sin(road.heading);
  const double dx = place[0] - road.origin[0], dy = place[1] - road.origin[1];
  return road_place(*grid.road, {c * dx + s * dy, c * dy - s * dx});
}

/// Radius around a wheel within which its contact evaluates the road, m.
double reach_of(const Tyre& tyre) {
  return tyre.envelope ? (tyre.envelope->base / 2 + tyre.envelope->length) * tyre.radius.value : 0;
}

}  // namespace

RoadWatch::RoadWatch(const Compilation& compilation, const GenericState& start) : compilation_(compilation) {
  for (const Tyre& tyre : compilation.model.tyres) {
    if (tyre.road < 0) continue;
    for (const RoadGrid& grid : compilation.model.roads[static_cast<std::size_t>(tyre.road)].grids)
      if (grid.ends == RoadBorder::refuse || grid.sides == RoadBorder::refuse) wheels_.push_back({&tyre, &grid});
  }
  if (!wheels_.empty()) solver_.emplace(compilation.model, compilation.topology, compilation.analysis);
  add(start);
}

void RoadWatch::add(const GenericState& state) {
  if (wheels_.empty()) return;
  const std::vector<Pose> poses = solver_->poses(state);
  for (Wheel& wheel : wheels_) {
    const Vector3 place = centre_of(compilation_.model, *wheel.tyre, poses);
    wheel.before = samples_ == 0 ? place : wheel.last;
    wheel.last = place;
  }
  ++samples_;
}

std::string RoadWatch::departure() const {
  for (const Wheel& wheel : wheels_) {
    const Road& road = compilation_.model.roads[static_cast<std::size_t>(wheel.tyre->road)];
    const CrgRoad& grid = *wheel.grid->road;
    const double reach = reach_of(*wheel.tyre);
    Vector3 ahead{};
    for (std::size_t k = 0; k < 3; ++k) ahead[k] = 3 * wheel.last[k] - 2 * wheel.before[k];
    for (const CrgPlace& at : {on_road(road, *wheel.grid, wheel.last), on_road(road, *wheel.grid, ahead)}) {
      const char* border = nullptr;
      if (wheel.grid->ends == RoadBorder::refuse)
        border = at.u - reach < grid.start ? "its start" : at.u + reach > grid.end() ? "its end" : nullptr;
      const bool is_wide = border == nullptr && wheel.grid->sides == RoadBorder::refuse;
      if (is_wide)
        border = at.v - reach < grid.v.front()  ? "its right side"
                 : at.v + reach > grid.v.back() ? "its left side"
                                                : nullptr;
      if (border)
        return fmt::format(
            "tyre \"{}\" leaves the road \"{}\" beyond {} (u = {:.6g} m, v = {:.6g} m), where that has no height: "
            "{} is \"refuse\"",
            wheel.tyre->name, road.name, border, at.u, at.v, is_wide ? "beyond_sides" : "beyond_ends");
    }
  }
  return {};
}

void RoadWatch::judge(const SimulationSummary& summary, StepVerdict& verdict) const {
  if (summary.status.ok()) return;
  if (std::string beyond = departure(); !beyond.empty()) verdict.failure = std::move(beyond);
}

}  // namespace mbgen
