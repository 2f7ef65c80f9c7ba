#include "compiler/cli/engine.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "compiler/cli/user_error.hpp"

namespace mbgen::cli {
namespace {

template <CartesianMethod method>
Engine make_judge(const Compilation& compilation, const EngineChoice& choice) {
  return make_cartesian_engine(compilation, choice, method);
}

enum class Coordinates { relative, cartesian };

struct Maker {
  const char* name;
  Coordinates coordinates;
  Engine (*make)(const Compilation&, const EngineChoice&);
};

constexpr Maker kMakers[] = {{"generated", Coordinates::relative, make_generated_engine},
                             {"generic", Coordinates::relative, make_generic_engine},
                             {"augmented", Coordinates::cartesian, make_judge<CartesianMethod::augmented>},
                             {"range-space", Coordinates::cartesian, make_judge<CartesianMethod::range_space>},
                             {"null-space", Coordinates::cartesian, make_judge<CartesianMethod::null_space>},
                             {"maggi", Coordinates::cartesian, make_judge<CartesianMethod::maggi>}};

std::vector<std::string> names_where(const std::function<bool(const Maker&)>& condition) {
  std::vector<std::string> names;
  for (const Maker& maker : kMakers)
    if (condition(maker)) names.push_back(maker.name);
  return names;
}

std::string loop_names(const Topology& topology, const LoopBlock& block) {
  std::vector<std::string> names;
  for (const int loop : block.loops) names.push_back(topology.loops[loop].name);
  return fmt::format("{}", fmt::join(names, ", "));
}

}  // namespace

const std::vector<std::string>& engine_names() {
  static const std::vector<std::string> names = names_where([](const Maker&) { return true; });
  return names;
}

const std::vector<std::string>& relative_engine_names() {
  static const std::vector<std::string> names =
      names_where([](const Maker& maker) { return maker.coordinates == Coordinates::relative; });
  return names;
}

bool is_cartesian(const std::string& name) {
  const auto named = [&](const Maker& maker) { return maker.name == name; };
  const auto maker = std::find_if(std::begin(kMakers), std::end(kMakers), named);
  return maker != std::end(kMakers) && maker->coordinates == Coordinates::cartesian;
}

Engine make_engine(const Compilation& compilation, const EngineChoice& choice) {
  const auto maker = std::find_if(std::begin(kMakers), std::end(kMakers),
                                  [&](const Maker& candidate) { return candidate.name == choice.name; });
  if (maker == std::end(kMakers)) {
    throw UserError(
        fmt::format("--engine: no engine \"{}\"; there are: {}\n", choice.name, fmt::join(engine_names(), ", ")));
  }
  return maker->make(compilation, choice);
}

double largest_absolute(const std::vector<double>& values) {
  double largest = 0;
  for (const double value : values) {
    if (!(std::abs(value) <= largest)) largest = std::abs(value);  // NaN is larger than every number
  }
  return largest;
}

std::string describe(const Topology& topology, Status status) {
  std::string name;
  const bool of_block = names_block(status.code);
  if (of_block && status.index >= 0 && status.index < static_cast<int>(topology.blocks.size())) {
    name = loop_names(topology, topology.blocks[status.index]);
  } else if (!of_block && status.index >= 0 && status.index < topology.size()) {
    name = topology.bodies[status.index].coordinate;
  }
  return name.empty() ? text(status.code) : fmt::format("{}: {}", text(status.code), name);
}

}  // namespace mbgen::cli
