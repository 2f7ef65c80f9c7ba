#include "compiler/emit/interface_text.hpp"

#include <fmt/format.h>

#include "compiler/emit/frame.hpp"
#include "compiler/emit/input_text.hpp"
#include "compiler/emit/text.hpp"
#include "compiler/model/inputs.hpp"

namespace mbgen {
namespace {

/// `struct Coordinate { enum Index : int { a, b }; };`: scoped like an enum class, and still an index.
std::string enumeration(const std::string& name, const std::vector<std::string>& members) {
  return "struct " + name + " {\n" + braced_list("  enum Index : int ", members, ";") + "\n};";
}

std::string string_table(const std::string& name, const std::vector<std::string>& texts) {
  std::vector<std::string> literals;
  for (const std::string& text : texts) literals.push_back(string_literal(text));
  if (literals.empty()) literals.push_back("\"\"");
  return braced_list("inline constexpr const char* const " + name + "[] = ", literals, ";\n");
}

std::vector<std::string> units_of(const std::vector<NumberMember>& members) {
  std::vector<std::string> units;
  for (const NumberMember& member : members) units.push_back(member.unit);
  return units;
}

std::string tables(const EmitContext& context) {
  const Model& model = context.model;
  std::vector<std::string> coordinate_names, coordinate_units, block_names, output_units;
  for (const TreeBody& body : context.topology.bodies) {
    coordinate_names.push_back(body.coordinate);
    coordinate_units.push_back(unit_of(body.kind));
  }
  for (const Output& output : model.outputs) output_units.push_back(output.unit);
  for (std::size_t b = 0; b < context.topology.blocks.size(); ++b)
    block_names.push_back(block_title(context.topology, static_cast<int>(b)));
  std::string text =
      string_table("kCoordinateNames", coordinate_names) + string_table("kCoordinateUnits", coordinate_units) +
      string_table("kAuxiliaryStateNames", auxiliary_state_names(model)) +
      string_table("kBodyNames", names_of(model.bodies)) + string_table("kInputNames", names_of(model.inputs)) +
      string_table("kInputUnits", units_of(input_members(context))) +
      string_table("kOutputNames", names_of(model.outputs)) + string_table("kOutputUnits", output_units) +
      string_table("kParameterNames", tunable_names(model)) +
      string_table("kParameterUnits", units_of(parameter_members(context))) +
      string_table("kLoopBlockNames", block_names);
  text.pop_back();
  return text;
}

std::string member(const NumberMember& number, const std::string& scalar) {
  const std::string value = number.value.empty() ? "" : " = " + number.value;
  const std::string declaration = "  " + scalar + " " + number.name + value + ";";
  return declaration + (number.unit.empty() ? "" : "  ///< " + comment_text(number.unit)) + "\n";
}

std::string structure(const std::string& name, const std::vector<NumberMember>& members, const std::string& scalar) {
  std::string text = "struct " + name + " {\n";
  for (const NumberMember& number : members) text += member(number, scalar);
  return text + "};";
}

/// The file name without its directories: the same text wherever the model lies.
std::string base_name(const std::string& path) {
  const std::size_t slash = path.find_last_of("/\\");
  return slash == std::string::npos ? path : path.substr(slash + 1);
}

}  // namespace

std::vector<NumberMember> parameter_members(const EmitContext& context) {
  std::vector<NumberMember> members;
  for (const Parameter& p : context.model.parameters)
    if (p.tunable)
      members.push_back({context.names.parameters[members.size()], number_text(p.value, context.scalar), p.unit});
  return members;
}

std::vector<NumberMember> input_members(const EmitContext& context) {
  std::vector<NumberMember> members;
  for (const Input& input : context.model.inputs)
    members.push_back(
        {context.names.inputs[members.size()], number_text(input.default_value, context.scalar), input.unit});
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
  return frame_rows(names, [](const std::string& name) { return FrameValues{{"member", name}}; });
}

FrameRows member_rows(const std::vector<NumberMember>& members) {
  return frame_rows(members, [](const NumberMember& member) {
    return FrameValues{{"member", member.name}, {"unit", comment_text(member.unit)}};
  });
}

std::string banner_text(const Model& model, const std::string& mark) {
  return mark + " " + comment_text(model.name) + ", content hash " + model.hash + "\n" + mark +
         " Made by `mbgen generate " + comment_text(base_name(model.file)) + "`, mbgen " + kMbgenVersion +
         ". Change the model, not this file.";
}

std::string tuned_type_text(const Programs& programs, const std::string& scalar) {
  const int count = derived_constant_count(programs);
  if (count == 0)
    return "/// What functions take: no constants follow from the parameters.\nusing Tuned = Parameters;\n";
  std::string named;
  for (int k = 0; const std::string& name : derived_constant_names(programs)) {
    if (!name.empty()) named += fmt::format("{} [{}] {}", named.empty() ? " Among them:" : ",", k, name);
    ++k;
  }
  const std::string comment = wrapped_words(
      fmt::format("Tunable parameters with the {} constants that follow from them. Functions take plain Parameters as "
                  "well, and then work these out each time: keep one of these, and assign Parameters to it where they "
                  "change, at the boundary of a step.{}{}",
                  count, named, named.empty() ? "" : "."),
      "/// ");
  return fmt::format(
      "{}\nstruct Tuned : Parameters {{\n  {} derived[{}];\n  Tuned() noexcept : Tuned(Parameters{{}}) {{}}\n"
      "  Tuned(const Parameters& parameters) noexcept;\n}};\n",
      comment, scalar, count);
}

std::string tuned_constructor_text(const Programs& programs) {
  if (derived_constant_count(programs) == 0) return "";
  return "Tuned::Tuned(const Parameters& parameters) noexcept : Parameters(parameters) {\n"
         "  compute_derived_constants(parameters, *this);\n}\n\n";
}

std::string interface_text(const EmitContext& context) {
  const SolverNames& names = context.names;
  return fill_template("solver.hpp.in",
                       {{"banner", banner_text(context.model, "//")},
                        {"title", comment_text(context.model.name)},
                        {"solver", names.solver},
                        {"model_literal", string_literal(context.model.name)},
                        {"hash_literal", string_literal(context.model.hash)},
                        {"coordinate_count", std::to_string(names.coordinates.size())},
                        {"auxiliary_count", std::to_string(context.layout.auxiliary_states)},
                        {"body_count", std::to_string(names.bodies.size())},
                        {"input_count", std::to_string(names.inputs.size())},
                        {"output_count", std::to_string(names.outputs.size())},
                        {"parameter_count", std::to_string(names.parameters.size())},
                        {"loop_block_count", std::to_string(names.loop_blocks.size())},
                        {"equation_count", std::to_string(context.layout.equations)},
                        {"motion_count", std::to_string(context.layout.drives)},
                        {"coordinates", enumeration("Coordinate", names.coordinates)},
                        {"bodies", enumeration("Body", names.bodies)},
                        {"inputs", enumeration("Input", names.inputs)},
                        {"outputs", enumeration("Output", names.outputs)},
                        {"parameters", enumeration("Parameter", names.parameters)},
                        {"loop_blocks", enumeration("LoopBlock", names.loop_blocks)},
                        {"tables", tables(context)},
                        {"parameter_struct", structure("Parameters", parameter_members(context), context.scalar)},
                        {"tuned_type", tuned_type_text(context.programs, context.scalar)},
                        {"input_struct", structure("Inputs", input_members(context), context.scalar)},
                        {"advances", inputs_have_derivatives(context.model.inputs) ? "yes" : ""},
                        {"input_rows", input_rows_text(context.model, names)},
                        {"initial", context.initial ? "yes" : ""},
                        {"output_struct", structure("Outputs", output_members(context), context.scalar)},
                        {"scalar", context.scalar},
                        {"auxiliary_size", size_text(context.layout.auxiliary_states)},
                        {"multiplier_size", size_text(context.layout.equations)},
                        {"drive_size", size_text(context.layout.drives)}});
}

}  // namespace mbgen
