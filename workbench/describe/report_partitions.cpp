// The candidates for the partitions of the loop blocks as data and as tables for people (docs/method/recursive.md).

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "compiler/formulation/recursion/recursion_units.hpp"
#include "workbench/describe/names.hpp"
#include "workbench/describe/report.hpp"

namespace mbgen {
namespace {

using Json = nlohmann::ordered_json;

/// Free directions of a block: coordinates, for a ball joint the components of its angular velocity.
std::vector<std::string> direction_names(const Topology& topology, const RecursionUnit& unit,
                                         const std::vector<int>& columns) {
  std::vector<std::string> names;
  for (const int column : columns) {
    const int joint = unit.joints[column];
    names.push_back(topology.bodies[joint].coordinate);
    for (const JointStep& step : unit.steps)
      for (std::size_t c = 0; step.quasi() && c < step.joints.size(); ++c)
        if (step.joints[c] == joint)
          names.back() = fmt::format("{}.omega_{}", topology.bodies[step.body()].name, "xyz"[c]);
  }
  return names;
}

std::string reason(const BlockAnalysis& block) {
  if (block.chosen_like >= 0) return fmt::format("as loop block {}, of the same structure", block.chosen_like + 1);
  const PartitionCandidate& chosen = block.candidates[block.chosen];
  if (chosen.traced == 0)
    return block.candidates.size() == 1 ? "nothing else holds as well" : "least by its estimate, not counted";
  const bool is_least = std::none_of(block.candidates.begin(), block.candidates.end(), [&](const auto& other) {
    return other.traced > 0 && other.traced < chosen.traced;
  });
  if (is_least) return "fewest operations";
  return chosen.symmetric ? "symmetric, and within 1 % of the fewest operations" : "fewest operations after the passes";
}

Json number_or_null(long number) { return number > 0 ? Json(number) : Json(nullptr); }

Json report_candidates(const Topology& topology, const RecursionUnit& unit, const BlockAnalysis& block) {
  Json candidates = Json::array();
  for (std::size_t c = 0; c < block.candidates.size(); ++c) {
    const PartitionCandidate& candidate = block.candidates[c];
    candidates.push_back({{"independent", direction_names(topology, unit, candidate.independent)},
                          {"score", candidate.score},
                          {"worst_pivot_ratio", candidate.worst_pivot_ratio},
                          {"estimate", candidate.estimate},
                          {"traced", number_or_null(candidate.traced)},
                          {"after_passes", number_or_null(candidate.operations)},
                          {"symmetric", candidate.symmetric},
                          {"chosen", static_cast<int>(c) == block.chosen}});
  }
  return {{"block", unit.block + 1}, {"reason", reason(block)}, {"candidates", candidates}};
}

std::string count_text(const Json& count) { return count.is_null() ? "" : std::to_string(count.get<long>()); }

}  // namespace

Json report_partitions(const Compilation& compilation) {
  Json list = Json::array();
  const Topology& topology = compilation.topology;
  for (const RecursionUnit& unit : plan_recursion(compilation.model, topology, compilation.analysis.driven).units)
    if (unit.block >= 0 && !compilation.analysis.blocks[unit.block].candidates.empty())
      list.push_back(report_candidates(topology, unit, compilation.analysis.blocks[unit.block]));
  std::sort(list.begin(), list.end(), [](const Json& a, const Json& b) { return a["block"] < b["block"]; });
  return list;
}

std::string partitions_text(const Json& report) {
  if (report["partitions"].empty()) return "";
  std::string text = "\nPartitions of the loop blocks\n";
  for (const Json& block : report["partitions"]) {
    text += fmt::format("  {}: {}\n", block["block"].get<int>(), block["reason"].get<std::string>());
    text += fmt::format("    {:>8}{:>8}{:>13}{:>7}{:>7}  {}\n", "estimate", "traced", "after passes", "score", "pivot",
                        "independent");
    for (const Json& c : block["candidates"])
      text += fmt::format("  {} {:>8.0f}{:>8}{:>13}{:>7.2f}{:>7.2f}  {}{}\n", c["chosen"].get<bool>() ? "*" : " ",
                          c["estimate"].get<double>(), count_text(c["traced"]), count_text(c["after_passes"]),
                          c["score"].get<double>(), c["worst_pivot_ratio"].get<double>(),
                          fmt::join(c["independent"].get<std::vector<std::string>>(), " "),
                          c["symmetric"].get<bool>() ? " (symmetric)" : "");
  }
  return text;
}

}  // namespace mbgen
