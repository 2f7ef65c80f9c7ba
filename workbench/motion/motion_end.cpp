#include "workbench/motion/motion_end.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "workbench/describe/names.hpp"
#include "workbench/start/equilibrium_causes.hpp"

namespace mbgen {
namespace {

/// Hint where loops that a motion drives cannot follow it; empty for other ends.
std::string hint_of_reach(const Compilation& compilation, Status status) {
  if (status.code != Code::loop_not_closed && status.code != Code::loop_singular) return {};
  const auto block = static_cast<std::size_t>(status.index);
  if (status.index < 0 || block >= compilation.analysis.blocks.size()) return {};
  const std::vector<std::string> driven =
      local_names(compilation.topology, compilation.topology.blocks[block], compilation.analysis.blocks[block].driven);
  if (driven.empty()) return {};
  return fmt::format("the lengths in these loops let {} go no farther: change a length, or its motion",
                     fmt::join(driven, ", "));
}

}  // namespace

std::string end_text(const Compilation& compilation, const JudgedMotion& motion) {
  const bool of_control = motion.control && !motion.control->failure.empty();
  return fmt::format("stopped after t = {:.10g} s: {}{}", motion.summary.end_time,
                     describe(compilation, motion.summary.status),
                     of_control ? fmt::format(" ({})", motion.control->failure) : "");
}

std::vector<std::string> hints_of_end(const Compilation& compilation, const JudgedMotion& motion) {
  const SimulationSummary& summary = motion.summary;
  std::vector<std::string> hints;
  std::string cause =
      motion.verdict.failure.empty() ? hint_of_reach(compilation, summary.status) : motion.verdict.failure;
  if (!cause.empty()) hints.push_back(std::move(cause));
  if (summary.status.code != Code::not_a_number) return hints;
  for (std::string& ends : coinciding_ends(compilation, summary.last)) hints.push_back(std::move(ends));
  return hints;
}

}  // namespace mbgen
