#include <fmt/format.h>
#include <fmt/ranges.h>

#include <map>
#include <vector>

#include "compiler/emit/cost_sheet.hpp"
#include "workbench/describe/report.hpp"

namespace mbgen {
namespace {

using Json = nlohmann::ordered_json;

std::string counts_text(const Json& report) {
  std::string text = fmt::format("{}\n", report["name"].get<std::string>());
  const std::vector<std::pair<const char*, const char*>> rows = {
      {"bodies", "bodies, with ground"},
      {"massless_bodies", "massless bodies"},
      {"joints", "joints of one freedom, or cut"},
      {"tree_joints", "  in the tree"},
      {"cut_joints", "  cut"},
      {"rods", "rods"},
      {"relative_coordinates", "relative coordinates"},
      {"constraint_equations", "constraint equations"},
      {"independent_equations", "independent equations"},
      {"velocity_equations", "  of velocities alone"},
      {"position_freedoms", "freedoms of positions"},
      {"degrees_of_freedom", "degrees of freedom"},
      {"driven_coordinates", "  of these driven by motions"}};
  for (const auto& [key, title] : rows)
    if (report.contains(key)) text += fmt::format("  {:<32}{:>6}\n", title, report[key].get<long>());
  return text;
}

std::string tree_text(const Json& report) {
  std::map<std::string, int> depth_of = {{"ground", 0}};
  std::string text = "\nTree (body: coordinate, kind)\n  ground\n";
  for (const auto& coordinate : report["coordinates"]) {
    const std::string body = coordinate["body"];
    const int depth = depth_of[coordinate["parent"]] + 1;
    depth_of[body] = depth;
    text += fmt::format("  {:>{}}{}: {}, {}, on {}{}\n", "", 2 * depth, body, coordinate["name"].get<std::string>(),
                        coordinate["kind"].get<std::string>(), coordinate["parent"].get<std::string>(),
                        coordinate["massless"] ? ", massless" : "");
  }
  return text;
}

std::string loops_text(const Json& report) {
  std::string text;
  if (!report["cut_joint_names"].empty()) text += "\nCut joints\n";
  for (const auto& joint : report["cut_joint_names"]) {
    text +=
        fmt::format("  {}: {}, {} equations, {}\n", joint["name"].get<std::string>(), joint["kind"].get<std::string>(),
                    joint["equations"].get<int>(), joint["reason"].get<std::string>());
  }
  if (!report["loop_blocks"].empty()) text += "\nLoop blocks\n";
  int number = 0;
  for (const auto& block : report["loop_blocks"]) {
    text +=
        fmt::format("  {}: {} joints on {}, {} equations of rank {}, diagonal blocks {}\n", ++number,
                    block["joints"].get<int>(), block["base"].get<std::string>(), block["equations"].get<int>(),
                    block["rank"].get<int>(), fmt::join(block["triangular_block_sizes"].get<std::vector<int>>(), " "));
    for (const char* part : {"loops", "dependent", "independent", "driven", "redundant"}) {
      text += wrapped(part, block[part].get<std::vector<std::string>>());
    }
  }
  return text;
}

std::string path_matrix_text(const Json& report) {
  if (!report.contains("path_matrix")) return "";
  std::string text = "\nPath matrix, from the leaves to the root\n";
  for (const auto& row : report["path_matrix"]) {
    text += "  ";
    for (const auto& entry : row) text += entry.get<int>() != 0 ? '1' : '.';
    text += "\n";
  }
  return text;
}

std::string operations_text(const Json& report) {
  if (report["form"].is_null()) return "";
  const auto count = [&](const char* form, const char* unit) {
    const long operations = report["operations_of_form"][form].get<long>();
    return operations > 0 ? fmt::format("{}{} {}", operations, unit, form) : fmt::format("many more {}", form);
  };
  std::string text = fmt::format("\nForm of the accelerations: {} ({}, {})\n", report["form"].get<std::string>(),
                                 count("matrix", " operations"), count("recursive", ""));
  for (const auto& saving : report["savings"])
    text += fmt::format("  {:<40}{:>8} operations without it, {:>8} with\n", saving["treatment"].get<std::string>(),
                        saving["without"].get<long>(), saving["with"].get<long>());
  for (const auto& [name, program] : report["operations"].items()) {
    text += operations_table("Operations of " + name, program["sections"], program["total"], "section");
  }
  return text;
}

std::string notes_text(const Json& report) {
  if (report["notes"].empty()) return "";
  std::string text = "\nNotes\n";
  for (const auto& note : report["notes"])
    text += fmt::format("  {}:{}: {}\n", note["file"].get<std::string>(), note["line"].get<int>(),
                        note["message"].get<std::string>());
  return text;
}

}  // namespace

std::string wrapped(const std::string& title, const std::vector<std::string>& words) {
  constexpr std::size_t kReportWidth = 110;
  std::string text, line = fmt::format("    {:<12}", title);
  for (const std::string& word : words) {
    if (line.size() + 1 + word.size() > kReportWidth) {
      text += line + "\n";
      line.assign(16, ' ');
    }
    line += " " + word;
  }
  return words.empty() ? "" : text + line + "\n";
}

std::string report_text(const Json& report) {
  return counts_text(report) + tree_text(report) + loops_text(report) + redundancy_text(report) +
         partitions_text(report) + notes_text(report) + path_matrix_text(report) + operations_text(report);
}

}  // namespace mbgen
