#include "workbench/describe/report.hpp"

#include <algorithm>

#include "compiler/emit/cost_sheet.hpp"
#include "compiler/solver/titles.hpp"
#include "workbench/describe/names.hpp"
#include "workbench/describe/notes.hpp"

namespace mbgen {
namespace {

using Json = nlohmann::ordered_json;

/// Number of bodies merged into another one by a fixed joint, thus without a coordinate.
long count_merged_bodies(const Model& model, const Topology& topology) {
  long merged = 0;
  for (int body = 0; body < static_cast<int>(model.bodies.size()); ++body) {
    const auto is_body = [body](const TreeBody& tree_body) { return tree_body.model_body == body; };
    const bool moves = std::any_of(topology.bodies.begin(), topology.bodies.end(), is_body);
    merged += body != model.ground && !moves ? 1 : 0;
  }
  return merged;
}

Json report_cut_joints(const Topology& topology) {
  Json list = Json::array();
  for (const Loop& loop : topology.loops) {
    if (loop.joint < 0) continue;
    const std::size_t place = list.size();
    list.push_back({{"name", loop.name},
                    {"kind", name_of(loop.kind)},
                    {"equations", loop.equations},
                    {"reason", place < topology.cut_reasons.size() ? topology.cut_reasons[place] : ""}});
  }
  return list;
}

Json report_ranks(const std::vector<RankCount>& ranks) {
  Json list = Json::array();
  for (const RankCount& seen : ranks) list.push_back({{"rank", seen.rank}, {"configurations", seen.configurations}});
  return list;
}

/// The redundancy certificate of a block (docs/method/redundancy.md).
Json report_certificate(const Topology& topology, const LoopBlock& block, const Certificate& certificate) {
  Json singular = Json::array();
  for (const SingularConfiguration& seen : certificate.singular) {
    Json positions = Json::object();
    for (std::size_t c = 0; c < block.joints.size(); ++c) {
      positions[topology.bodies[block.joints[c]].coordinate] = seen.z[c];
    }
    singular.push_back({{"rank", seen.rank}, {"times", seen.times}, {"positions", positions}});
  }
  Json redundant = Json::array();
  for (const RedundantEquation& equation : certificate.redundant) {
    redundant.push_back({{"name", equation.name},
                         {"joint", topology.loops[equation.loop].name},
                         {"meaning", equation.meaning},
                         {"residual", equation.residual < 0 ? Json() : Json(equation.residual)}});
  }
  return {{"closed_configurations", certificate.closed_configurations},
          {"reach", certificate.reach},
          {"ranks", report_ranks(certificate.ranks)},
          {"singular", singular},
          {"smallest_kept", certificate.smallest_kept},
          {"largest_dropped", certificate.largest_dropped},
          {"steps", certificate.steps},
          {"redundant", redundant},
          {"immobile", local_names(topology, block, certificate.immobile)},
          {"degrees_of_freedom", certificate.degrees_of_freedom}};
}

Json report_block(const Topology& topology, const LoopBlock& block, const BlockAnalysis& decided) {
  std::vector<std::string> loops;
  for (const int loop : block.loops) loops.push_back(topology.loops[loop].name);
  return {{"joints", block.joints.size()},
          {"joint_names", coordinate_names(topology, block.joints)},
          {"base", body_name(topology, block.base)},
          {"loops", loops},
          {"equations", block.equations},
          {"rank", decided.rank},
          {"dependent", local_names(topology, block, decided.dependent)},
          {"independent", local_names(topology, block, decided.independent)},
          {"driven", local_names(topology, block, decided.driven)},
          {"redundant", decided.redundant_names},
          {"triangular_block_sizes", decided.triangular_sizes},
          {"worst_pivot_ratio", decided.worst_pivot_ratio},
          {"certificate", report_certificate(topology, block, decided.certificate)}};
}

Json report_program(const Program& program, const Titles& titles) {
  Json sections = Json::array();
  const std::vector<OperationCount> counts = count_operations_by_section(program);
  for (std::size_t s = 0; s < counts.size(); ++s) {
    Json section = {{"section", titles.section(program.sections[s])}};
    section.update(operations_json(counts[s]));
    sections.push_back(section);
  }
  return {{"sections", sections}, {"total", operations_json(count_operations(program))}};
}

}  // namespace

/// Largest path matrix written out; for more bodies only their parents, in `coordinates`.
constexpr int kMostBodiesInPathMatrix = 500;

Json make_report(const Compilation& compilation, const Counts& counts) {
  const Model& model = compilation.model;
  const Topology& topology = compilation.topology;
  const Analysis& analysis = compilation.analysis;
  const Programs programs = counted_programs(compilation);
  const Json cut_joints = report_cut_joints(topology);
  const long moving_bodies = topology.size() + count_merged_bodies(model, topology);
  const auto is_massless = [](const TreeBody& body) { return body.massless; };

  Json report;
  report["name"] = model.name;
  report["bodies"] = moving_bodies + 1;  // and ground
  report["massless_bodies"] = std::count_if(topology.bodies.begin(), topology.bodies.end(), is_massless);
  report["joints"] = moving_bodies + static_cast<long>(cut_joints.size());
  report["tree_joints"] = moving_bodies;  // one per moving body
  report["cut_joints"] = cut_joints.size();
  report["cut_joint_names"] = cut_joints;
  report["rods"] = model.rods.size();
  report["relative_coordinates"] = topology.size();
  report["constraint_equations"] = equation_count(topology);
  report["independent_equations"] = analysis.independent_equations;
  report["degrees_of_freedom"] = analysis.degrees_of_freedom;
  if (rolling_loop(topology)) {
    report["position_freedoms"] = analysis.position_freedoms;
    report["velocity_equations"] = analysis.position_freedoms - analysis.degrees_of_freedom;
  }
  report["driven_coordinates"] = model.motions.size();
  report["closed_configurations"] = analysis.closed_configurations;
  report["ranks"] = report_ranks(analysis.ranks);
  report["loop_blocks"] = Json::array();
  for (std::size_t b = 0; b < topology.blocks.size(); ++b) {
    report["loop_blocks"].push_back(report_block(topology, topology.blocks[b], analysis.blocks[b]));
  }
  report["partitions"] = report_partitions(compilation);
  report["notes"] = diagnostics_json(all_notes(compilation));
  report["coordinates"] = Json::array();
  for (const TreeBody& body : topology.bodies) {
    report["coordinates"].push_back({{"name", body.coordinate},
                                     {"kind", name_of(body.kind)},
                                     {"body", body.name},
                                     {"parent", body_name(topology, body.parent)},
                                     {"massless", body.massless}});
  }
  if (topology.size() <= kMostBodiesInPathMatrix) report["path_matrix"] = path_matrix(topology);
  report["form"] = programs.accelerations.outputs.empty() ? Json(nullptr) : Json(name_of(programs.form));
  report["operations_of_form"] = {{"matrix", counts.operations_of_form[static_cast<int>(Form::matrix)]},
                                  {"recursive", counts.operations_of_form[static_cast<int>(Form::recursive)]}};
  report["savings"] = Json::array();
  for (const Saving& saving : counts.savings)
    report["savings"].push_back({{"treatment", saving.name}, {"without", saving.without}, {"with", saving.with}});
  report["operations"] = Json::object();
  const Titles titles = titles_of(programs.form, model, topology);
  for (const Program* program : all_programs(programs))
    report["operations"][program->name] = report_program(*program, titles);
  return report;
}

}  // namespace mbgen
