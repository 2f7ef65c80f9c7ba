#include "compiler/emit/interface_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "compiler/emit/input_text.hpp"
#include "compiler/emit/text.hpp"
#include "compiler/emit/tuned_text.hpp"

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

std::string size_constants(const EmitContext& context) {
  const SolverNames& names = context.names;
  const std::pair<const char*, std::size_t> sizes[] = {
      {"kCoordinates", names.coordinates.size()},
      {"kAuxiliaryStates", static_cast<std::size_t>(context.layout.auxiliary_states)},
      {"kBodies", names.bodies.size()},
      {"kInputs", names.inputs.size()},
      {"kOutputs", names.outputs.size()},
      {"kParameters", names.parameters.size()},
      {"kLoopBlocks", names.loop_blocks.size()},
      {"kClosureEquations", static_cast<std::size_t>(context.layout.equations)},
      {"kMotions", static_cast<std::size_t>(context.layout.drives)}};
  std::string text;
  for (const auto& [name, size] : sizes) {
    text += fmt::format("constexpr int {} = {};\n", name, size);
  }
  text.pop_back();
  return text;
}

std::string tables(const EmitContext& context) {
  const Model& model = context.model;
  std::vector<std::string> coordinate_names, coordinate_units, input_units, output_units, parameter_units, block_names;
  for (const TreeBody& body : context.topology.bodies) {
    coordinate_names.push_back(body.coordinate);
    coordinate_units.push_back(unit_of(body.kind));
  }
  for (const Input& input : model.inputs) input_units.push_back(input.unit);
  for (const Output& output : model.outputs) output_units.push_back(output.unit);
  for (const Parameter& parameter : model.parameters) {
    if (parameter.tunable) parameter_units.push_back(parameter.unit);
  }
  for (std::size_t b = 0; b < context.topology.blocks.size(); ++b) {
    block_names.push_back(block_title(context.topology, static_cast<int>(b)));
  }
  std::string text =
      string_table("kCoordinateNames", coordinate_names) + string_table("kCoordinateUnits", coordinate_units) +
      string_table("kAuxiliaryStateNames", auxiliary_state_names(model)) +
      string_table("kBodyNames", names_of(model.bodies)) + string_table("kInputNames", names_of(model.inputs)) +
      string_table("kInputUnits", input_units) + string_table("kOutputNames", names_of(model.outputs)) +
      string_table("kOutputUnits", output_units) + string_table("kParameterNames", tunable_names(model)) +
      string_table("kParameterUnits", parameter_units) + string_table("kLoopBlockNames", block_names);
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

std::string initial_declaration(const EmitContext& context) {
  if (!context.initial) return "";
  return wrapped_words(start_comment(), "/// ") + "\nState initial_state() noexcept;\n\n";
}

/// The file name without its directories: the same text wherever the model lies.
std::string base_name(const std::string& path) {
  const std::size_t slash = path.find_last_of("/\\");
  return slash == std::string::npos ? path : path.substr(slash + 1);
}

std::string cmake_flags(CompilerFamily family) {
  return wrapped_words(fmt::format("{}", fmt::join(solver_compile_flags(family), " ")), "      ");
}

/// What g++ is told on x86-64 alone.
std::string x86_flags(int lanes) {
  if (lanes == 0) return "";
  return fmt::format(
      "  if(CMAKE_SYSTEM_PROCESSOR MATCHES \"x86_64|AMD64\")\n    list(APPEND solver_flags {})\n  endif()\n",
      fmt::join(lane_flags_of_gnu_on_x86(), " "));
}

}  // namespace

std::vector<NumberMember> parameter_members(const EmitContext& context) {
  std::vector<NumberMember> members;
  for (const Parameter& parameter : context.model.parameters) {
    if (!parameter.tunable) continue;
    members.push_back(
        {context.names.parameters[members.size()], number_text(parameter.value, context.scalar), parameter.unit});
  }
  return members;
}

std::vector<NumberMember> input_members(const EmitContext& context) {
  std::vector<NumberMember> members;
  for (const Input& input : context.model.inputs) {
    members.push_back(
        {context.names.inputs[members.size()], number_text(input.default_value, context.scalar), input.unit});
  }
  return members;
}

std::vector<NumberMember> output_members(const EmitContext& context) {
  std::vector<NumberMember> members;
  for (const Output& output : context.model.outputs) {
    members.push_back({context.names.outputs[members.size()], "", output.unit});
  }
  members.insert(members.end(), {{"kinetic_energy", "", "J"},
                                 {"potential_energy", "", "J, of gravity"},
                                 {"applied_power", "", "W, of all applied forces but gravity"}});
  return members;
}

std::string state_comment(const EmitContext& context) {
  return context.initial ? "/// Everything that changes in time. Start from `State state = initial_state();`."
                         : "/// Everything that changes in time. Start from `State state{};` and assemble it.";
}

std::string start_comment() {
  return "The state that the model starts from: its \"initial\" with loops closed and velocities consistent, worked "
         "out by "
         "mbgen at the default parameters and inputs. At others assemble it; a static equilibrium is then not looked "
         "for "
         "again.";
}

std::string banner_text(const Model& model, const std::string& mark) {
  return mark + " " + comment_text(model.name) + ", content hash " + model.hash + "\n" + mark +
         " Made by `mbgen generate " + comment_text(base_name(model.file)) + "`, mbgen " + kMbgenVersion +
         ". Change the model, not this file.";
}

std::string interface_text(const EmitContext& context) {
  const SolverNames& names = context.names;
  const InputText inputs = input_text(context.model, names, context.scalar);
  return fill_template("solver.hpp.in",
                       {{"banner", banner_text(context.model, "//")},
                        {"title", comment_text(context.model.name)},
                        {"solver", names.solver},
                        {"model_literal", string_literal(context.model.name)},
                        {"hash_literal", string_literal(context.model.hash)},
                        {"sizes", size_constants(context)},
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
                        {"input_comment", inputs.comment},
                        {"advance_declaration", inputs.declaration},
                        {"input_include", inputs.include},
                        {"input_rows", inputs.rows},
                        {"dynamics_comment", inputs.dynamics_comment},
                        {"step_start", inputs.member},
                        {"state_comment", state_comment(context)},
                        {"initial_state", initial_declaration(context)},
                        {"output_struct", structure("Outputs", output_members(context), context.scalar)},
                        {"scalar", context.scalar},
                        {"auxiliary_size", size_text(context.layout.auxiliary_states)},
                        {"multiplier_size", size_text(context.layout.equations)},
                        {"drive_size", size_text(context.layout.drives)}});
}

std::string build_text(const EmitContext& context) {
  const std::string& solver = context.names.solver;
  const std::string sources = solver + ".cpp" + (context.lanes > 0 ? " " + solver + "_batch.cpp" : "") +
                              (context.c_interface ? " " + solver + "_c.cpp" : "");
  const std::string shared = context.c_interface ? fill_template("shared.cmake.in", {{"solver", solver}}) : "";
  return fill_template("CMakeLists.txt.in", {{"banner", banner_text(context.model, "#")},
                                             {"solver", solver},
                                             {"sources", sources},
                                             {"gnu_flags", cmake_flags(CompilerFamily::gnu)},
                                             {"x86_flags", x86_flags(context.lanes)},
                                             {"clang_flags", cmake_flags(CompilerFamily::clang)},
                                             {"shared", shared}});
}

}  // namespace mbgen
