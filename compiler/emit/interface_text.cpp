#include <fmt/format.h>

#include "compiler/emit/context_values.hpp"
#include "compiler/emit/mapped.hpp"
#include "compiler/emit/quantity_ranges.hpp"
#include "compiler/emit/text.hpp"
#include "compiler/emit/texts.hpp"
#include "compiler/model/auxiliary_states.hpp"
#include "compiler/model/holds.hpp"
#include "compiler/model/inputs.hpp"
#include "compiler/topology/names.hpp"

namespace mbgen {
namespace {

/// `struct Coordinate { enum Index : int { a, b }; };`: scoped like an enum class, and still an index.
std::string enumeration(const std::string& name, const std::vector<std::string>& members) {
  return "struct " + name + " {\n" + braced_list("  enum Index : int ", members, ";") + "\n};";
}

/// Arrays of names and units.
FrameRows tables(const EmitContext& context) {
  const Model& model = context.model;
  const std::vector<Parameter> parameters = tunable_parameters(model);
  const auto& bodies = context.topology.bodies;
  const auto block_name = [&](const LoopBlock& block) { return joined(loop_names(context.topology, block), ", "); };
  std::vector<std::pair<const char*, std::vector<std::string>>> all = {
      {"kCoordinateNames", coordinate_names(context.topology)},
      {"kCoordinateUnits", mapped(bodies, [](const TreeBody& body) { return std::string(unit_of(body.kind)); })},
      {"kAuxiliaryStateNames", auxiliary_state_names(model)},
      {"kBodyNames", names_of(model.bodies)},
      {"kInputNames", names_of(model.inputs)},
      {"kInputUnits", mapped(model.inputs, &Input::unit)},
      {"kOutputNames", names_of(model.outputs)},
      {"kOutputUnits", mapped(model.outputs, &Output::unit)},
      {"kParameterNames", names_of(parameters)},
      {"kParameterUnits", mapped(parameters, &Parameter::unit)},
      {"kLoopBlockNames", mapped(context.topology.blocks, block_name)}};
  if (context.layout.holds > 0) all.emplace_back("kHoldNames", hold_names(model));
  if (context.layout.actuators > 0) {
    all.emplace_back("kActuatorNames", names_of(model.actuators));
    all.emplace_back("kActuatorDirections", actuated_directions(model, context.topology, context.analysis));
  }
  return mapped(all, [](const auto& named) {
    std::vector<std::string> literals = mapped(named.second, string_literal);
    if (literals.empty()) literals.push_back("\"\"");
    return FrameValues{{"table", named.first}, {"texts", wrapped_list(literals, 4)}};
  });
}

/// Members of a struct with their defaults.
FrameRows default_rows(const std::vector<NumberMember>& members) {
  return mapped(members, [](const NumberMember& member) {
    return FrameValues{{"member", member.name}, {"value", member.value}, {"unit", comment_text(member.unit)}};
  });
}

/// The items of kInputRows; empty if no rates can be computed.
std::string input_rows_text(const Model& model, const SolverNames& names) {
  std::vector<std::string> rows;
  for (const std::vector<int>& row : input_rows(model.inputs)) {
    const auto member = [&](int input) { return "&Inputs::" + names.inputs[static_cast<std::size_t>(input)]; };
    rows.push_back(fmt::format("    {{{}, {{{}}}{}}}", row.size(), joined(mapped(row, member), ", "),
                               is_made_rate(model.inputs, row.back()) ? ", true" : ""));
  }
  return inputs_have_derivatives(model.inputs) ? joined(rows, ",\n") : "";
}

}  // namespace

std::string interface_text(const EmitContext& context) {
  const SolverNames& names = context.names;
  FrameValues values = {{"title", comment_text(context.model.name)},
                        {"model_literal", string_literal(context.model.name)},
                        {"hash_literal", string_literal(context.model.hash)},
                        {"body_count", names.bodies.size()},
                        {"loop_block_count", names.loop_blocks.size()},
                        {"coordinates", enumeration("Coordinate", names.coordinates)},
                        {"bodies", enumeration("Body", names.bodies)},
                        {"inputs", enumeration("Input", names.inputs)},
                        {"outputs", enumeration("Output", names.outputs)},
                        {"parameters", enumeration("Parameter", names.parameters)},
                        {"loop_blocks", enumeration("LoopBlock", names.loop_blocks)},
                        {"actuator_list", enumeration("Actuator", names.actuators)},
                        {"tables", tables(context)},
                        {"parameter_members", default_rows(parameter_members(context))},
                        {"input_members", default_rows(input_members(context))},
                        {"output_members", member_rows(output_members(context))},
                        {"has_quantities", has_quantities(context)},
                        {"starts", starts_with_derivatives(context)},
                        {"input_rows", input_rows_text(context.model, names)}};
  values.merge(tuned_values(context.programs, true));
  return fill_template(context, "solver.hpp.in", values);
}

}  // namespace mbgen
