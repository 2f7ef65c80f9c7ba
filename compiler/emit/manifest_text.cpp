#include <nlohmann/json.hpp>

#include "compiler/emit/cost_sheet.hpp"
#include "compiler/emit/texts.hpp"
#include "compiler/topology/names.hpp"

namespace mbgen {
namespace {

using Json = nlohmann::ordered_json;

/// Adds the operations of the laws that the program leaves to others, for all of their elements.
void add_laws(const EmitContext& context, const ShapedProgram& shaped, Json& json) {
  for (std::size_t k = 0; k < shaped.shape.laws.size(); ++k) {
    const LawShape& law = shaped.shape.laws[k];
    Json section = {{"title", law.function() + ": tyres of one law, " + std::to_string(law.elements) + " in lanes"}};
    const Json counts = operations_json(count_operations(context.written.laws[k].program));
    for (const auto& [kind, count] : counts.items()) {
      section[kind] = count.get<long>() * law.elements;
      json["operations"][kind] = json["operations"][kind].get<long>() + section[kind].get<long>();
    }
    json["sections"].push_back(section);
  }
}

Json program_json(const EmitContext& context, const ShapedProgram& shaped) {
  const Program& program = *shaped.program;
  const std::vector<OperationCount> counts = count_operations_by_section(program);
  Json sections = Json::array();
  for (std::size_t s = 0; s < counts.size(); ++s) {
    if (program.sections[s].step == Step::none) continue;
    Json section = {{"title", shaped.shape.titles.section(program.sections[s])}};
    section.update(operations_json(counts[s]));
    sections.push_back(section);
  }
  Json json = {{"function", shaped.shape.function}};
  if (shaped.schedule.has_loops()) {
    json["loops"] = shaped.schedule.loops();
    json["written_operations"] = shaped.schedule.written();
  } else {
    json["parts"] = shaped.schedule.parts.size();
  }
  json["operations"] = operations_json(count_operations(program));
  json["sections"] = sections;
  add_laws(context, shaped, json);
  return json;
}

Json blocks_json(const EmitContext& context) {
  Json blocks = Json::array();
  for (std::size_t b = 0; b < context.layout.blocks.size(); ++b) {
    const LoopBlock& block = context.topology.blocks[b];
    blocks.push_back({{"name", context.names.loop_blocks[b]},
                      {"loops", loop_names(context.topology, block)},
                      {"coordinates", coordinate_names(context.topology, block.joints)},
                      {"equations", block.equations},
                      {"rank", context.analysis.blocks[b].rank},
                      {"redundant_equations", context.analysis.blocks[b].redundant_names}});
  }
  return blocks;
}

}  // namespace

Json manifest_json(const EmitContext& context, const std::vector<ShapedProgram>& all) {
  const SolverNames& names = context.names;
  Json programs = Json::object();
  for (const ShapedProgram& shaped : all) programs[name_of(shaped.role)] = program_json(context, shaped);
  const Json worst_case = worst_case_json(context, programs);
  Json manifest = {{"mbgen", kMbgenVersion},
                   {"model", context.model.name},
                   {"hash", context.model.hash},
                   {"namespace", names.solver},
                   {"form", name_of(context.programs.form)},
                   {"sizes",
                    {{"coordinates", context.layout.coordinates},
                     {"auxiliary_states", context.layout.auxiliary_states},
                     {"closure_equations", context.layout.equations},
                     {"independent_equations", context.analysis.independent_equations},
                     {"degrees_of_freedom", context.analysis.degrees_of_freedom},
                     {"motions", context.layout.drives}}},
                   {"coordinates", names.coordinates},
                   {"bodies", names.bodies},
                   {"inputs", names.inputs},
                   {"outputs", names.outputs},
                   {"parameters", names.parameters},
                   {"loop_blocks", blocks_json(context)},
                   {"programs", programs},
                   {"worst_case", worst_case}};
  if (context.layout.actuators > 0) manifest["actuators"] = names.actuators;
  if (context.options.scalar != Scalar::doubles) manifest["scalar"] = name_of(context.options.scalar);
  return manifest;
}

std::string manifest_text(const Json& manifest) {
  return manifest.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace mbgen
