#include "workbench/report/ground.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "compiler/model/element_access.hpp"
#include "workbench/report/places.hpp"
#include "workbench/report/poses.hpp"
#include "workbench/report/strip.hpp"

namespace mbgen {
namespace {

using Json = nlohmann::ordered_json;
using Kind = ExpressionNode::Kind;

/// Heights, and factors of friction, that all strips of a page have together: 5.3 letters each.
constexpr std::size_t kMostRoadNumbers = 40'000;
constexpr double kFloorBelow = 0.2;  ///< the floor below the lowest place of the strips, in radii of the largest wheel

/// All expressions that say what the road of a tyre is like.
std::vector<int> expressions_of(const Model& model, const Tyre& tyre) {
  std::vector<int> all{tyre.road_height.expression};
  if (tyre.road < 0) return all;
  const auto add = [&](std::initializer_list<std::optional<Quantity>> quantities) {
    for (const std::optional<Quantity>& quantity : quantities)
      if (quantity) all.push_back(quantity->expression);
  };
  const Road& road = model.roads[static_cast<std::size_t>(tyre.road)];
  for (const std::optional<int>& expression : {road.height, road.friction}) all.push_back(expression.value_or(-1));
  add({road.slope_x, road.slope_y});
  for (const RoadFeature& part : road.features)
    add({part.from, part.length, part.right, part.left, part.height, part.wave_length, part.last_wave_length,
         part.phase});
  for (const RoadPatch& part : road.patches) add({part.from, part.length, part.right, part.left, part.friction});
  return all;
}

bool looks_at(const Model& model, const Tyre& tyre, std::initializer_list<Kind> kinds) {
  const std::vector<int> all = expressions_of(model, tyre);
  return std::any_of(all.begin(), all.end(), [&](int expression) { return mentions(model, expression, kinds); });
}

/// Tyres on the same road at the same height.
using Group = std::vector<std::size_t>;
std::vector<Group> groups_of(const Model& model) {
  std::vector<Group> groups;
  const auto fits = [&](const Tyre& a, const Tyre& b) {
    return a.road == b.road && a.road_height.value == b.road_height.value &&
           a.road_height.expression == b.road_height.expression;
  };
  for (std::size_t t = 0; t < model.tyres.size(); ++t) {
    if (model.tyres[t].road < 0) continue;
    const auto group = std::find_if(groups.begin(), groups.end(),
                                    [&](const Group& g) { return fits(model.tyres[g[0]], model.tyres[t]); });
    if (group == groups.end())
      groups.push_back({t});
    else
      group->push_back(t);
  }
  return groups;
}

/// Wheel centres, frame by frame, of all tyres.
std::vector<std::vector<GroundPlace>> wheel_places(const Model& model, const GenericSolver& solver,
                                                   const std::vector<GenericState>& frames) {
  std::vector<std::vector<GroundPlace>> places;
  for (const GenericState& frame : frames) {
    const std::vector<Pose> poses = solver.poses(frame);
    std::vector<GroundPlace>& wheels = places.emplace_back();
    for (const Tyre& tyre : model.tyres) {
      const Vector3 centre = to_global(poses[static_cast<std::size_t>(tyre.centre.body)], place_of(model, tyre.centre));
      wheels.push_back({centre[0], centre[1]});
    }
  }
  return places;
}

/// Roads of a model along some frames.
struct GroundWork {
  const Model& model;
  const GenericSolver& solver;
  const std::vector<GenericState>& frames;
  std::vector<std::vector<GroundPlace>> wheels;
  Json notes = Json::array();
  double lowest = INFINITY;  ///< m, of all strips

  void note(const std::string& text) {
    if (std::find(notes.begin(), notes.end(), text) == notes.end()) notes.push_back(text);
  }

  const Road& road_of(std::size_t tyre) const { return model.roads[static_cast<std::size_t>(model.tyres[tyre].road)]; }

  /// The strip of a group of tyres, as the road is at the first frame.
  Json strip(const Group& group, std::size_t most) {
    const Road& road = road_of(group[0]);
    StripRequest request{{}, 0, road.heading, most};
    for (const std::size_t tyre : group) request.radius = std::max(request.radius, model.tyres[tyre].radius.value);
    for (const std::vector<GroundPlace>& all : wheels) {
      std::vector<GroundPlace>& own = request.wheels.emplace_back();
      for (const std::size_t tyre : group) own.push_back(all[tyre]);
    }
    bool is_whole = true;
    const Strip strip = strip_along(request, [&](const std::vector<GroundPlace>& places) {
      std::vector<RoadBelow> road_below = solver.road_below(frames.front(), group[0], places);
      for (RoadBelow& below : road_below) {
        if (std::isfinite(below.height) && std::isfinite(below.friction)) continue;
        is_whole = false;
        below = {};
      }
      return road_below;
    });
    if (!is_whole)
      note(fmt::format("Road {} has places without a height or friction near the wheels: they are drawn at 0.",
                       road.name));
    return strip_json(road, strip, request.radius);
  }

  Json strip_json(const Road& road, const Strip& strip, double radius) {
    std::vector<float> stations, offsets(strip.offsets.begin(), strip.offsets.end()), heights, friction;
    for (const Station& station : strip.stations)
      for (const double number : {station.x, station.y, station.cosine, station.sine})
        stations.push_back(static_cast<float>(number));
    for (const RoadBelow& below : strip.road) {
      heights.push_back(static_cast<float>(below.height));
      friction.push_back(static_cast<float>(below.friction));
      lowest = std::min(lowest, below.height - kFloorBelow * radius);
    }
    Json json = {{"road", road.name},
                 {"stations", base64(stations)},
                 {"offsets", base64(offsets)},
                 {"heights", base64(heights)},
                 {"friction", nullptr}};
    if (std::any_of(friction.begin(), friction.end(), [](float factor) { return factor != 1; }))
      json["friction"] = base64(friction);
    return json;
  }

  /// The heights below a wheel, each at the time of its frame.
  Json track(std::size_t tyre) const {
    std::vector<float> heights;
    for (std::size_t frame = 0; frame < frames.size(); ++frame)
      heights.push_back(static_cast<float>(solver.road_below(frames[frame], tyre, {wheels[frame][tyre]})[0].height));
    const Attachment& centre = model.tyres[tyre].centre;
    return {{"body", centre.body}, {"at", place_of(model, centre)}, {"heights", base64(heights)}};
  }
};

}  // namespace

Json ground_json(const Model& model, const GenericSolver& solver, const std::vector<GenericState>& frames,
                 bool knows_inputs) {
  GroundWork work{model, solver, frames, {}};
  const auto is_known = [&](std::size_t tyre) {
    return knows_inputs || !looks_at(model, model.tyres[tyre], {Kind::input});
  };
  std::vector<Group> drawn = groups_of(model);
  for (std::size_t t = 0; t < model.tyres.size(); ++t) {
    const Tyre& tyre = model.tyres[t];
    const std::string what = tyre.road < 0 ? "The road of tyre " + tyre.name : "Road " + work.road_of(t).name;
    if (!is_known(t))
      work.note(fmt::format("{} depends on inputs, which a result does not hold: {}.", what,
                            tyre.road < 0 ? "it is drawn with their defaults" : "it is not drawn"));
    else if (looks_at(
                 model, tyre,
                 {Kind::time, Kind::position, Kind::velocity, Kind::state, Kind::length, Kind::rate, Kind::observed}))
      work.note(fmt::format("{} moves: it is drawn as it is at {:g} s.", what, frames.front().t));
  }
  Json json = {{"strips", Json::array()}, {"tracks", Json::array()}, {"floor", nullptr}, {"notes", Json::array()}};
  if (!drawn.empty()) {
    work.wheels = wheel_places(model, solver, frames);
    std::erase_if(drawn, [&](const Group& group) { return !is_known(group[0]); });
    for (const Group& group : drawn) json["strips"].push_back(work.strip(group, kMostRoadNumbers / drawn.size()));
    for (std::size_t t = 0; t < model.tyres.size(); ++t)
      if (is_known(t)) json["tracks"].push_back(work.track(t));
    if (std::isfinite(work.lowest)) json["floor"] = work.lowest;
  }
  json["notes"] = work.notes;
  return json;
}

}  // namespace mbgen
