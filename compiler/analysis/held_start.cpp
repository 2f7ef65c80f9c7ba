#include "compiler/analysis/held_start.hpp"

#include <algorithm>

#include "compiler/analysis/analysis.hpp"

namespace mbgen {
namespace {

using Flags = std::vector<unsigned char>;

Flags flags_of(const Topology& topology, const std::vector<InitialValue>& given, bool locked_only) {
  Flags flags(topology.bodies.size(), 0);
  for (const InitialValue& value : given) {
    const int i = tree_coordinate(topology, value.coordinate);
    if (i >= 0 && (value.locked || !locked_only)) flags[static_cast<std::size_t>(i)] = 1;
  }
  return flags;
}

/// Whether more undriven coordinates of a loop block are held than it leaves free.
bool are_too_many(const Topology& topology, const Analysis& analysis, const Flags& held) {
  const std::vector<int> free = free_coordinates(topology, analysis);
  return std::ranges::any_of(topology.blocks, [&](const LoopBlock& block) {
    const auto is_held = [&](int i) { return held[static_cast<std::size_t>(i)] != 0 && !analysis.driven[i]; };
    const auto in_block = [&](int i) { return std::ranges::count(block.joints, i) > 0; };
    return std::ranges::count_if(block.joints, is_held) > std::ranges::count_if(free, in_block);
  });
}

}  // namespace

std::optional<std::vector<unsigned char>> held_at_start(const Topology& topology, const Analysis& analysis,
                                                        const std::vector<InitialValue>& given) {
  const Flags all = flags_of(topology, given, false);
  if (!are_too_many(topology, analysis, all)) return all;
  const Flags locked = flags_of(topology, given, true);
  const auto locks = static_cast<std::size_t>(std::ranges::count(locked, 1));
  const bool determine = locks >= free_coordinates(topology, analysis).size();
  if (!determine || are_too_many(topology, analysis, locked)) return {};
  return locked;
}

bool has_start_with_derivatives(const Model& model, const Topology& topology, const Analysis& analysis) {
  const auto is_held = [&](const std::vector<InitialValue>& given) {
    return held_at_start(topology, analysis, given).has_value();
  };
  return !model.initial.equilibrium && is_held(model.initial.positions) && is_held(model.initial.velocities);
}

}  // namespace mbgen
