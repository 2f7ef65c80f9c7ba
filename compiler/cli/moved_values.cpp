// What the report says of start values that gave way to the closures.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "compiler/cli/initial_state.hpp"

namespace mbgen::cli {
namespace {

using Json = nlohmann::ordered_json;

/// Values with a few digits each describe no closed position exactly; smaller moves are no news (rad, m or per second).
constexpr double kNews = 1e-3;

std::string line(const Compilation& compilation, const MovedValue& value) {
  const TreeBody& body = compilation.topology.bodies[value.coordinate];
  return fmt::format("  {} of {} from {:.6g} to {:.6g} {}{} ({:+.3g})  {}:{}:{}\n",
                     value.is_velocity ? "velocity" : "position", body.coordinate, value.asked, value.found,
                     unit_of(body.kind), value.is_velocity ? "/s" : "", value.found - value.asked, value.where.file,
                     value.where.line, value.where.column);
}

}  // namespace

std::string moved_text(const Compilation& compilation, const std::vector<MovedValue>& moved) {
  const bool news = std::any_of(moved.begin(), moved.end(), [](const MovedValue& value) {
    return std::abs(value.found - value.asked) > kNews * std::max(1.0, std::abs(value.asked));
  });
  if (!news) return "";
  std::string text = "note: the initial values do not fit together; nearest to them the loops close with\n";
  for (const MovedValue& value : moved) text += line(compilation, value);
  return text;
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
  fmt::print(stderr, "{}", moved_text(compilation, start.moved));
  return std::move(start.state);
}

}  // namespace mbgen::cli
