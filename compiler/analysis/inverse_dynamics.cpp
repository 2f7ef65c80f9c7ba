#include <fmt/format.h>
#include <fmt/ranges.h>

#include "compiler/analysis/analysis.hpp"

namespace mbgen {

bool has_inverse_dynamics(const Model& model, const Topology& topology, const Analysis& analysis) {
  return !model.actuators.empty() && analysis.unactuated.empty() &&
         analysis.actuation.pivots.size() == actuated_coordinates(topology, analysis).size();
}

Diagnostics unactuated_directions(const Model& model, const Topology& topology, const Analysis& analysis) {
  if (analysis.unactuated.empty()) return {};
  constexpr std::size_t kShown = 8;
  std::vector<std::string> names;
  for (const int i : analysis.unactuated)
    if (names.size() < kShown) names.push_back(topology.bodies[i].coordinate);
  const std::size_t count = analysis.unactuated.size();
  const std::string more = count > kShown ? fmt::format(" and {} more", count - kShown) : "";
  return {{model.actuators[0].where,
           fmt::format("actuators do not move every free direction: {}{} {} left, so that inverse dynamics has no "
                       "solution and is left out",
                       fmt::join(names, ", "), more, count == 1 ? "is" : "are"),
           fmt::format("give {} an actuator or a motion, or let the actuators act elsewhere", names[0]),
           {}}};
}

std::vector<std::string> actuated_directions(const Model& model, const Topology& topology, const Analysis& analysis) {
  const std::vector<int> directions = actuated_coordinates(topology, analysis);
  std::vector<std::string> names(directions.size());
  for (const Pivot& pivot : analysis.actuation.pivots)
    names[pivot.equation] =
        model.actuators[pivot.coordinate].name + " on " + topology.bodies[directions[pivot.equation]].coordinate;
  return names;
}

}  // namespace mbgen
