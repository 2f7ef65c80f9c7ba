#include "workbench/report/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "compiler/text/characters.hpp"
#include "compiler/topology/names.hpp"
#include "workbench/drawing/drawing.hpp"
#include "workbench/report/ground.hpp"
#include "workbench/report/modes.hpp"
#include "workbench/report/motion.hpp"
#include "workbench/report/page.hpp"
#include "workbench/report/scene.hpp"

namespace mbgen {
namespace {

using Json = nlohmann::ordered_json;

/// JSON escaped for a script element: it cannot contain the element's end tag.
std::string script_text(const Json& json) {
  std::string text;
  for (const char letter : json.dump(-1, ' ', false, Json::error_handler_t::replace)) {
    if (letter == '<') {
      text += "\\u003c";
    } else {
      text += letter;
    }
  }
  return text;
}

Json blocks_json(const Topology& topology, const Analysis& analysis) {
  Json blocks = Json::array();
  for (std::size_t b = 0; b < topology.blocks.size(); ++b) {
    const LoopBlock& block = topology.blocks[b];
    const BlockAnalysis& decided = analysis.blocks[b];
    blocks.push_back({{"base", body_name(topology, block.base)},
                      {"coordinates", block.joints.size()},
                      {"equations", block.equations},
                      {"rank", decided.rank},
                      {"loops", loop_names(topology, block)},
                      {"independent", local_names(topology, block, decided.independent)},
                      {"redundant", decided.redundant_names}});
  }
  return blocks;
}

/// Elements that show something by their section, all springs together.
Json element_counts(const Model& model) {
  Json counts = Json::object();
  each_kind([&](auto kind) {
    if (kind.quantities.size() == 0) return;
    const std::string_view section = kind.section;
    const std::string name(section.ends_with("springs") ? "springs" : section);
    counts[name] = counts.value(name, std::size_t{0}) + kind.list(model).size();
  });
  return counts;
}

/// The same for people: [["springs and dampers", 4]], kinds of which there are none left out.
Json element_rows(const Json& counts) {
  Json rows = Json::array();
  each_kind([&](auto kind) {
    const std::string_view section = kind.section;
    const bool is_spring = section == "springs";
    const auto count = counts.find(section);
    if (count == counts.end() || *count == 0) return;
    rows.push_back({is_spring ? "springs and dampers" : fmt::format("{}s", kind.words), *count});
  });
  return rows;
}

Json model_json(const Model& model, const Topology& topology, const Analysis& analysis) {
  Json json = {{"name", model.name},
               {"file", model.file},
               {"hash", model.hash},
               {"bodies", model.bodies.size()},
               {"joints", model.joints.size()},
               {"rods", model.rods.size()}};
  const Json counts = element_counts(model);
  json.update(counts);
  json["elements"] = element_rows(counts);
  json.update({{"coordinates", topology.size()},
               {"equations", equation_count(topology)},
               {"independent_equations", analysis.independent_equations},
               {"degrees_of_freedom", analysis.degrees_of_freedom},
               {"position_freedoms", analysis.position_freedoms},
               {"driven", model.motions.size()},
               {"blocks", blocks_json(topology, analysis)}});
  return json;
}

std::string_view page_file(std::string_view path) {
  const std::vector<PageFile>& files = report_page_files();
  const auto found = std::find_if(files.begin(), files.end(), [&](const PageFile& file) { return file.path == path; });
  return found == files.end() ? std::string_view() : found->text;
}

/// The frame with its fields {{title}}, {{style}}, {{data}} and {{script}} filled, once each and in this order.
std::string filled(std::string_view frame, const std::array<std::pair<std::string_view, std::string_view>, 4>& texts) {
  std::string page;
  for (const auto& [name, text] : texts) {
    const std::string mark = "{{" + std::string(name) + "}}";
    const std::size_t place = std::min(frame.find(mark), frame.size());
    page += frame.substr(0, place);
    page += text;
    frame.remove_prefix(std::min(place + mark.size(), frame.size()));
  }
  page += frame;
  return page;
}

/// Adds the roads of a model, if any, and notes.
void add_ground(Json ground, Json& data) {
  if (!ground["notes"].empty()) data["notes"] = ground["notes"];
  ground.erase("notes");
  if (!ground["tracks"].empty()) data["scene"]["ground"] = std::move(ground);
}

Json numbers_or_null(const std::vector<double>& values) {
  Json list = Json::array();
  for (const double value : values) list.push_back(std::isfinite(value) ? Json(value) : Json(nullptr));
  return list;
}

Json diagrams_json(const std::vector<PageDiagram>& diagrams) {
  Json list = Json::array();
  for (const PageDiagram& diagram : diagrams) {
    Json curves = Json::array();
    for (const PageDiagram::Line& line : diagram.curves)
      curves.push_back({{"name", line.name}, {"x", numbers_or_null(line.x)}, {"y", numbers_or_null(line.y)}});
    list.push_back({{"title", diagram.title},
                    {"x", {{"name", diagram.x.name}, {"unit", diagram.x.unit}}},
                    {"y", {{"name", diagram.y.name}, {"unit", diagram.y.unit}}},
                    {"logarithmic", diagram.logarithmic},
                    {"asIs", true},
                    {"curves", std::move(curves)}});
  }
  return list;
}

std::string page_of(const Model& model, const Json& data) {
  return filled(page_file("index.html"), {{{"title", xml_text(model.name)},
                                           {"style", page_file("report.css")},
                                           {"data", script_text(data)},
                                           {"script", page_file("report.js")}}});
}

}  // namespace

bool has_report_page() { return !report_page_files().empty(); }

Result<std::string> report_html(const ReportSource& source, const std::string& file, const std::string& label,
                                const std::vector<OtherResult>& others) {
  const Result<std::vector<GenericState>> frames = motion_frames(source, file, 1 + others.size());
  if (!frames) return frames.problems();
  const GenericSolver solver(source.model, source.topology, source.analysis);
  const Json run = Json::parse(source.results.run, nullptr, false);
  Json data = {{"format", 1}, {"result", file}, {"model", model_json(source.model, source.topology, source.analysis)}};
  data["run"] = run.is_object() ? run : Json(nullptr);
  data["scene"] = scene_json(source.model);
  data["animations"] = Json::array({motion_json(solver, *frames)});  // clang++ takes braces alone for a copy
  add_ground(ground_json(source.model, solver, *frames, false), data);
  data["table"] = table_json(source, others);
  if (!others.empty()) data["label"] = label;
  for (const OtherResult& other : others) {
    const Result<std::vector<GenericState>> poses = motion_frames(other.source, other.file, 1 + others.size());
    if (!poses) return poses.problems();
    const GenericSolver of_other(other.source.model, other.source.topology, other.source.analysis);
    const Json described = Json::parse(other.source.results.run, nullptr, false);
    data["others"].push_back({{"label", other.label},
                              {"run", described.is_object() ? described : Json(nullptr)},
                              {"scene", scene_json(other.source.model)},
                              {"animation", motion_json(of_other, *poses)}});
  }
  data["topology"] = topology_svg(source.model, source.topology, source.analysis);
  return page_of(source.model, data);
}

std::string modes_html(const ModesSource& source) {
  Json data = {{"format", 1}, {"model", model_json(source.model, source.topology, source.analysis)}};
  data["scene"] = scene_json(source.model);
  // The camera looks at the followed body, at its position in the frame.
  data["scene"]["centre"] = carried(source, data["scene"]["follow"], data["scene"]["centre"]);
  data.update(modes_json(source));
  if (!source.responses.empty()) data["responses"] = diagrams_json(source.responses);
  add_ground(ground_at_point(source), data);
  data["topology"] = topology_svg(source.model, source.topology, source.analysis);
  return page_of(source.model, data);
}

}  // namespace mbgen
