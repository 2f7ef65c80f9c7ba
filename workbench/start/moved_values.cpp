// Report of initial values that the closures changed.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "workbench/describe/notes.hpp"
#include "workbench/start/initial_state.hpp"

namespace mbgen {
namespace {

using Json = nlohmann::ordered_json;

/// Values with a few digits are never exactly closed; smaller changes are not reported (rad, m or per second).
constexpr double kNews = 1e-3;

bool is_news(const MovedValue& value) {
  return std::abs(value.found - value.asked) > kNews * std::max(1.0, std::abs(value.asked));
}

Diagnostic note_of(const Compilation& compilation, const MovedValue& value) {
  const TreeBody& body = compilation.topology.bodies[value.coordinate];
  return {value.where,
          fmt::format(
              "initial {} of {} is moved from {:.6g} to {:.6g} {}{} ({:+.3g}): with the others the loops do not close",
              value.is_velocity ? "velocity" : "position", body.coordinate, value.asked, value.found,
              unit_of(body.kind), value.is_velocity ? "/s" : "", value.found - value.asked),
          "", ""};
}

}  // namespace

Diagnostics moved_notes(const Compilation& compilation, const std::vector<MovedValue>& moved) {
  Diagnostics notes;
  if (std::none_of(moved.begin(), moved.end(), is_news)) return notes;
  for (const MovedValue& value : moved) notes.push_back(note_of(compilation, value));
  return notes;
}

Diagnostics start_notes(const Compilation& compilation, const Start& start) {
  Diagnostics notes = moved_notes(compilation, start.moved);
  for (Diagnostic& note : sliding_notes(compilation, start.state)) notes.push_back(std::move(note));
  for (Diagnostic& note : far_rest_notes(compilation, start.state)) notes.push_back(std::move(note));
  return notes;
}

Json moved_json(const Compilation& compilation, const std::vector<MovedValue>& moved) {
  Json list = Json::array();
  for (const MovedValue& value : moved) {
    list.push_back({{"coordinate", compilation.topology.bodies[value.coordinate].coordinate},
                    {"quantity", value.is_velocity ? "velocity" : "position"},
                    {"asked", value.asked},
                    {"found", value.found}});
  }
  return list;
}

GenericState noted_initial_state(const Compilation& compilation, const std::vector<double>& inputs) {
  Start start = initial_start(compilation, inputs);
  print_notes(start_notes(compilation, start));
  return std::move(start.state);
}

}  // namespace mbgen
