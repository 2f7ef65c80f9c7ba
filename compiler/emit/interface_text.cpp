#include "compiler/emit/interface_text.hpp"

#include <fmt/format.h>

#include "compiler/emit/frame.hpp"
#include "compiler/emit/input_text.hpp"
#include "compiler/emit/mapped.hpp"
#include "compiler/emit/text.hpp"
#include "compiler/model/inputs.hpp"

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
  std::vector<std::string> block_names;
  for (std::size_t b = 0; b < context.topology.blocks.size(); ++b)
    block_names.push_back(block_title(context.topology, static_cast<int>(b)));
  const std::pair<const char*, std::vector<std::string>> all[] = {
      {"kCoordinateNames", mapped(bodies, &TreeBody::coordinate)},
      {"kCoordinateUnits", mapped(bodies, [](const TreeBody& body) { return std::string(unit_of(body.kind)); })},
      {"kAuxiliaryStateNames", auxiliary_state_names(model)},
      {"kBodyNames", names_of(model.bodies)},
      {"kInputNames", names_of(model.inputs)},
      {"kInputUnits", mapped(model.inputs, &Input::unit)},
      {"kOutputNames", names_of(model.outputs)},
      {"kOutputUnits", mapped(model.outputs, &Output::unit)},
      {"kParameterNames", names_of(parameters)},
      {"kParameterUnits", mapped(parameters, &Parameter::unit)},
      {"kLoopBlockNames", block_names}};
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

/// The file name without its directories: the same text wherever the model lies.
std::string base_name(const std::string& path) {
  const std::size_t slash = path.find_last_of("/\\");
  return slash == std::string::npos ? path : path.substr(slash + 1);
}

}  // namespace

std::vector<NumberMember> parameter_members(const EmitContext& context) {
  std::vector<NumberMember> members;
  for (const Parameter& parameter : tunable_parameters(context.model))
    members.push_back({context.names.parameters[members.size()], number_text(parameter.value, context.options.scalar),
                       parameter.unit});
  return members;
}

std::vector<NumberMember> input_members(const EmitContext& context) {
  std::vector<NumberMember> members;
  for (const Input& input : context.model.inputs)
    members.push_back(
        {context.names.inputs[members.size()], number_text(input.default_value, context.options.scalar), input.unit});
  return members;
}

std::vector<NumberMember> output_members(const EmitContext& context) {
  std::vector<NumberMember> members;
  for (const Output& output : context.model.outputs)
    members.push_back({context.names.outputs[members.size()], "", output.unit});
  members.insert(members.end(), {{"kinetic_energy", "", "J"},
                                 {"potential_energy", "", "J, of gravity"},
                                 {"applied_power", "", "W, of all applied forces but gravity"}});
  return members;
}

FrameRows name_rows(const std::vector<std::string>& names) {
  return mapped(names, [](const std::string& name) { return FrameValues{{"member", name}}; });
}

FrameRows member_rows(const std::vector<NumberMember>& members) {
  return mapped(members, [](const NumberMember& member) {
    return FrameValues{{"member", member.name}, {"unit", comment_text(member.unit)}};
  });
}

std::string banner_text(const Model& model, const std::string& mark) {
  return mark + " " + comment_text(model.name) + ", content hash " + model.hash + "\n" + mark +
         " Made by `mbgen generate " + comment_text(base_name(model.file)) + "`, mbgen " + kMbgenVersion +
         ". Change the model, not this file.";
}

FrameValues tuned_values(const Programs& programs, bool constructs) {
  const int count = derived_constant_count(programs);
  std::string named;
  for (int k = 0; const std::string& name : derived_constant_names(programs)) {
    if (!name.empty()) named += fmt::format("{} [{}] {}", named.empty() ? " Among them:" : ",", k, name);
    ++k;
  }
  const std::string comment = fmt::format(
      "Tunable parameters with the {} constants that follow from them. Functions take plain Parameters as well, and "
      "then "
      "work these out each time: keep one of these, and assign Parameters to it where they change, at the boundary of "
      "a "
      "step.{}{}",
      count, named, named.empty() ? "" : ".");
  return {{"derived", count > 0 ? std::to_string(count) : ""},
          {"constructs", constructs},
          {"tuned_comment", wrapped_words(comment, "/// ")}};
}

std::string interface_text(const EmitContext& context) {
  const SolverNames& names = context.names;
  FrameValues values = {{"banner", banner_text(context.model, "//")},
                        {"title", comment_text(context.model.name)},
                        {"solver", names.solver},
                        {"model_literal", string_literal(context.model.name)},
                        {"hash_literal", string_literal(context.model.hash)},
                        {"coordinate_count", names.coordinates.size()},
                        {"auxiliary_count", context.layout.auxiliary_states},
                        {"body_count", names.bodies.size()},
                        {"input_count", names.inputs.size()},
                        {"output_count", names.outputs.size()},
                        {"parameter_count", names.parameters.size()},
                        {"loop_block_count", names.loop_blocks.size()},
                        {"equation_count", context.layout.equations},
                        {"motion_count", context.layout.drives},
                        {"coordinates", enumeration("Coordinate", names.coordinates)},
                        {"bodies", enumeration("Body", names.bodies)},
                        {"inputs", enumeration("Input", names.inputs)},
                        {"outputs", enumeration("Output", names.outputs)},
                        {"parameters", enumeration("Parameter", names.parameters)},
                        {"loop_blocks", enumeration("LoopBlock", names.loop_blocks)},
                        {"tables", tables(context)},
                        {"parameter_members", default_rows(parameter_members(context))},
                        {"input_members", default_rows(input_members(context))},
                        {"output_members", member_rows(output_members(context))},
                        {"advances", inputs_have_derivatives(context.model.inputs)},
                        {"input_rows", input_rows_text(context.model, names)},
                        {"initial", context.options.initial.has_value()},
                        {"scalar", context.options.scalar},
                        {"balls", context.layout.balls > 0 ? std::to_string(context.layout.balls) : ""},
                        {"auxiliary_size", size_text(context.layout.auxiliary_states)},
                        {"multiplier_size", size_text(context.layout.equations)},
                        {"drive_size", size_text(context.layout.drives)}};
  values.merge(tuned_values(context.programs, true));
  return fill_template("solver.hpp.in", values);
}

}  // namespace mbgen
