// Event indicators of an FMU.

#include <algorithm>

#include "compiler/fmu/variables.hpp"
#include "compiler/topology/names.hpp"

namespace mbgen {

void add_indicators(const EmitContext& context, FmuLayout& fmu) {
  for (const int place : fmu.chosen) {
    const int block = fmu.block_of[fmu.independent[place]];
    if (block >= 0 && std::ranges::find(fmu.indicator_blocks, block) == fmu.indicator_blocks.end())
      fmu.indicator_blocks.push_back(block);
  }
  std::ranges::sort(fmu.indicator_blocks);
  const auto add = [&](int block, const std::string& name, const char* description) {
    fmu.variables.push_back({{Array::pivot, block}, "margin." + name, "1", description});
  };
  for (const int block : fmu.indicator_blocks) {
    const std::string loop = loop_names(context.topology, context.topology.blocks[block])[0];
    add(block, loop,
        "event indicator: how far the states of this loop are from dead points; where it is less than 0 an event "
        "chooses others");
  }
  if (context.topology.balls.empty() || !fmu.has_states) return;
  fmu.indicator_blocks.push_back(-1);
  add(-1, "charts",
      "event indicator: 1 where the angles of all balls are far from their poles, else -1: an event takes others");
}

}  // namespace mbgen
