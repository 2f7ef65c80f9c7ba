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

/// Undriven coordinates of a block with a flag, and its independent ones.
struct HeldOfBlock {
  std::vector<int> held, independent;
};

std::vector<HeldOfBlock> held_of_blocks(const Topology& topology, const Analysis& analysis, const Flags& flags) {
  const std::vector<int> free = free_coordinates(topology, analysis);
  std::vector<HeldOfBlock> blocks;
  for (const LoopBlock& block : topology.blocks) {
    HeldOfBlock& of = blocks.emplace_back();
    for (const int i : block.joints) {
      if (flags[static_cast<std::size_t>(i)] != 0 && !analysis.driven[i]) of.held.push_back(i);
      if (std::ranges::count(free, i) > 0) of.independent.push_back(i);
    }
  }
  return blocks;
}

bool are_too_many(const std::vector<HeldOfBlock>& blocks) {
  return std::ranges::any_of(blocks, [](const HeldOfBlock& of) { return of.held.size() > of.independent.size(); });
}

}  // namespace

std::optional<std::vector<unsigned char>> held_at_start(const Topology& topology, const Analysis& analysis,
                                                        const std::vector<InitialValue>& given) {
  Flags flags = flags_of(topology, given, false);
  const std::vector<HeldOfBlock> all = held_of_blocks(topology, analysis, flags);
  std::vector<HeldOfBlock> blocks = all;
  if (are_too_many(all)) {
    flags = flags_of(topology, given, true);
    blocks = held_of_blocks(topology, analysis, flags);
    if (are_too_many(blocks)) return {};
  }
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    const HeldOfBlock& of = blocks[b];
    if (of.held.size() == of.independent.size()) continue;
    const auto is_independent = [&](int i) { return std::ranges::count(of.independent, i) > 0; };
    const bool has_guesses = all[b].held.size() > of.held.size();
    if (has_guesses || !std::ranges::all_of(of.held, is_independent)) return {};
    for (const int i : of.independent) flags[static_cast<std::size_t>(i)] = 1;
  }
  return flags;
}

bool has_start_with_derivatives(const Model& model, const Topology& topology, const Analysis& analysis) {
  const auto is_held = [&](const std::vector<InitialValue>& given) {
    return held_at_start(topology, analysis, given).has_value();
  };
  return !model.initial.equilibrium && is_held(model.initial.positions) && is_held(model.initial.velocities);
}

}  // namespace mbgen
