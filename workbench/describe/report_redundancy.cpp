// The redundancy certificates of the loop blocks as tables for people (docs/method/redundancy.md).

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "workbench/describe/report.hpp"

namespace mbgen {
namespace {

using Json = nlohmann::ordered_json;

/// `rank 2 in 24, 1 in 1 of 25 closed configurations`, of ranks up to `highest`.
std::string ranks_text(const Json& ranks, int configurations, int highest) {
  std::string text;
  for (const auto& seen : ranks) {
    if (seen["rank"].get<int>() > highest) continue;
    text += fmt::format("{}{} in {}", text.empty() ? "rank " : ", ", seen["rank"].get<int>(),
                        seen["configurations"].get<int>());
  }
  return fmt::format("{} of {} closed configurations", text, configurations);
}

std::string freedoms_text(int freedoms) {
  return freedoms == 0 ? "nothing moves" : fmt::format("{} degree{} of freedom", freedoms, freedoms == 1 ? "" : "s");
}

std::string equations_text(const Json& redundant, int steps) {
  std::size_t name_width = 0, meaning_width = 0;
  for (const auto& equation : redundant) {
    name_width = std::max(name_width, equation["name"].get<std::string>().size());
    meaning_width = std::max(meaning_width, equation["meaning"].get<std::string>().size());
  }
  std::string text;
  for (const auto& equation : redundant) {
    const Json& residual = equation["residual"];
    text +=
        fmt::format("    {:<12} {:<{}}  {:<{}}{}\n", "redundant", equation["name"].get<std::string>(), name_width,
                    equation["meaning"].get<std::string>(), meaning_width,
                    residual.is_null() ? "  not watched"
                                       : fmt::format("  within {:.1e} over {} steps", residual.get<double>(), steps));
  }
  return text;
}

/// Ranks in assembly modes not reached from the reference.
std::string other_modes_text(const Json& block) {
  const Json& certificate = block["certificate"];
  std::vector<std::string> ranks;
  for (const auto& seen : certificate["ranks"]) {
    if (seen["rank"] > block["rank"])
      ranks.push_back(fmt::format("rank {} in {} of {} closed configurations", seen["rank"].get<int>(),
                                  seen["configurations"].get<int>(), certificate["closed_configurations"].get<int>()));
  }
  return wrapped("other modes", ranks);
}

std::string block_text(const Json& block, int number) {
  const Json& certificate = block["certificate"];
  std::string text = fmt::format("  {}: {} equations, {}, {}\n", number, block["equations"].get<int>(),
                                 ranks_text(certificate["ranks"], certificate["closed_configurations"], block["rank"]),
                                 freedoms_text(certificate["degrees_of_freedom"]));
  text += fmt::format(
      "    {:<12} up to {:.2g} rad or m from the reference; singular values kept from {:.1e}, dropped to {:.1e}\n",
      "looked at", certificate["reach"].get<double>(), certificate["smallest_kept"].get<double>(),
      certificate["largest_dropped"].get<double>());
  text += other_modes_text(block) + equations_text(certificate["redundant"], certificate["steps"]);
  for (const auto& seen : certificate["singular"]) {
    std::vector<std::string> positions;
    for (const auto& [name, value] : seen["positions"].items()) {
      positions.push_back(fmt::format("{} {:.4g}", name, value.get<double>()));
    }
    if (seen["times"] > 1) positions.push_back(fmt::format("({} times)", seen["times"].get<int>()));
    text += wrapped(fmt::format("rank {} at", seen["rank"].get<int>()), positions);
  }
  return text + wrapped("stands still", certificate["immobile"].get<std::vector<std::string>>());
}

}  // namespace

std::string redundancy_text(const Json& report) {
  if (report["loop_blocks"].empty()) return "";
  std::string text =
      fmt::format("\nRedundancy\n  all blocks: {} equations, {}\n", report["constraint_equations"].get<int>(),
                  ranks_text(report["ranks"], report["closed_configurations"], report["constraint_equations"]));
  int number = 0;
  for (const auto& block : report["loop_blocks"]) text += block_text(block, ++number);
  return text;
}

}  // namespace mbgen
