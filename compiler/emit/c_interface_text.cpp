#include "compiler/emit/c_interface_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "compiler/emit/text.hpp"
#include "compiler/model/inputs.hpp"
#include "mbgen/status.hpp"

namespace mbgen {
namespace {

/// The text with nothing in it that would end or begin a C comment.
std::string apart(const std::string& text) {
  std::string result;
  for (const char c : text) {
    const bool joins = !result.empty() && ((result.back() == '*' && c == '/') || (result.back() == '/' && c == '*'));
    if (joins) result += ' ';
    result += c;
  }
  return result;
}

std::string c_comment_text(const std::string& text) { return apart(comment_text(text)); }

std::vector<std::string> coordinate_names(const Topology& topology) {
  std::vector<std::string> names;
  for (const TreeBody& body : topology.bodies) names.push_back(body.coordinate);
  return names;
}

/// A struct of numbers; C has no empty ones.
std::string c_structure(const std::string& scalar, const std::string& name, const std::vector<NumberMember>& members) {
  std::string text = "typedef struct " + name + " {\n";
  for (const NumberMember& member : members) {
    const std::string unit = member.unit.empty() ? "" : " /* " + c_comment_text(member.unit) + " */";
    text += "  " + scalar + " " + member.name + ";" + unit + "\n";
  }
  if (members.empty()) text += "  " + scalar + " unused_; /* there are none */\n";
  return text + "} " + name + ";";
}

std::string sizes_text(const EmitContext& context) {
  const SolverNames& names = context.names;
  const std::pair<const char*, std::size_t> sizes[] = {
      {"coordinates", names.coordinates.size()},
      {"auxiliary_states", static_cast<std::size_t>(context.layout.auxiliary_states)},
      {"parameters", names.parameters.size()},
      {"inputs", names.inputs.size()},
      {"outputs", names.outputs.size()}};
  std::string text;
  for (const auto& [name, size] : sizes)
    text += fmt::format("  {}number_of_{} = {},\n", guard_of(names.solver), name, size);
  return text.substr(0, text.size() - 2);
}

std::string copies(const std::vector<NumberMember>& members) {
  std::string text;
  for (const NumberMember& member : members) text += fmt::format("  to.{0} = from.{0};\n", member.name);
  return text;
}

std::string constants(const std::string& scalar, const std::string& name, const std::vector<double>& values) {
  return array_text(fmt::format("constexpr {} {}", scalar, name), number_texts(values, scalar),
                    number_text(0, scalar)) +
         "\n";
}

std::string name_functions(const EmitContext& context) {
  struct Table {
    const char *function, *names, *size;
  };
  constexpr Table kTables[] = {{"coordinate_name", "kCoordinateNames", "kCoordinates"},
                               {"coordinate_unit", "kCoordinateUnits", "kCoordinates"},
                               {"auxiliary_state_name", "kAuxiliaryStateNames", "kAuxiliaryStates"},
                               {"parameter_name", "kParameterNames", "kParameters"},
                               {"parameter_unit", "kParameterUnits", "kParameters"},
                               {"input_name", "kInputNames", "kInputs"},
                               {"input_unit", "kInputUnits", "kInputs"},
                               {"output_name", "kOutputNames", "kOutputs"},
                               {"output_unit", "kOutputUnits", "kOutputs"}};
  std::string text;
  for (const Table& table : kTables)
    text += fmt::format("const char* {0}_{1}(int index) {{ return entry({0}::{2}, {0}::{3}, index); }}\n",
                        context.names.solver, table.function, table.names, table.size);
  return text;
}

/// Quoted, for Python: the escapes of C++ that string_literal writes are those of Python, too.
std::string python_list(const std::vector<std::string>& items) {
  std::vector<std::string> literals;
  for (const std::string& item : items) literals.push_back(string_literal(item));
  return fmt::format("[{}]", fmt::join(literals, ", "));
}

std::string python_fields(const std::string& scalar, const std::vector<NumberMember>& members) {
  std::string text;
  for (const NumberMember& member : members)
    text += fmt::format("        ({}, ctypes.c_{}),{}\n", string_literal(member.name), scalar,
                        member.unit.empty() ? "" : "  # " + comment_text(member.unit));
  if (members.empty()) text += fmt::format("        (\"unused_\", ctypes.c_{}),\n", scalar);
  return text;
}

}  // namespace

std::string c_banner_text(const Model& model) { return "/*\n" + apart(banner_text(model, " *")) + "\n */"; }

std::string guard_of(const std::string& solver) {
  std::string guard = solver + "_";
  std::transform(guard.begin(), guard.end(), guard.begin(),
                 [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; });
  return guard;
}

std::string c_header_text(const EmitContext& context) {
  const SolverNames& names = context.names;
  const std::string& solver = names.solver;
  const bool with_derivatives = inputs_have_derivatives(context.model.inputs);
  return fill_template(
      "c_interface.h.in",
      {{"banner", c_banner_text(context.model)},
       {"title", c_comment_text(context.model.name)},
       {"solver", solver},
       {"scalar", context.scalar},
       {"guard", guard_of(solver)},
       {"sizes", sizes_text(context)},
       {"parameter_struct", c_structure(context.scalar, solver + "_parameters", parameter_members(context))},
       {"input_struct", c_structure(context.scalar, solver + "_inputs", input_members(context))},
       {"input_comment", with_derivatives ? ", but for those whose derivative is an input too" : ""},
       {"output_struct", c_structure(context.scalar, solver + "_outputs", output_members(context))},
       {"coordinate_size", size_text(context.layout.coordinates)},
       {"auxiliary_size", size_text(context.layout.auxiliary_states)},
       {"first_notice", std::to_string(static_cast<int>(kFirstNotice))},
       {"integrator", context.model.solver.is_multistep() ? "Adams-Bashforth-Moulton" : "Runge-Kutta"}});
}

std::string c_source_text(const EmitContext& context, const InitialState& initial) {
  const std::string& solver = context.names.solver;
  return fill_template(
      "c_interface.cpp.in",
      {{"banner", banner_text(context.model, "//")},
       {"solver", solver},
       {"scalar", context.scalar},
       {"initial_state", constants(context.scalar, "kInitialZ", initial.z) +
                             constants(context.scalar, "kInitialZd", initial.zd) +
                             constants(context.scalar, "kInitialX", initial.x)},
       {"coordinate_size", size_text(context.layout.coordinates)},
       {"parameters_in", copies(parameter_members(context))},
       {"parameters_out", copies(parameter_members(context))},
       {"inputs_in", copies(input_members(context))},
       {"inputs_out", copies(input_members(context))},
       {"outputs_out", copies(output_members(context))},
       {"parameter_table", array_text(fmt::format("constexpr {} Parameters::*kParameterMembers", context.scalar),
                                      member_places("Parameters", context.names.parameters), "nullptr")},
       {"step", solver + (context.model.solver.is_multistep()
                              ? "::step_abm4(solver->parameters, solver->inputs, solver->state, solver->history, h)"
                              : "::step_rk4(solver->parameters, solver->inputs, solver->state, h)")},
       {"name_functions", name_functions(context)},
       {"version", kMbgenVersion}});
}

std::string python_text(const EmitContext& context) {
  const Model& model = context.model;
  return fill_template("module.py.in", {{"banner", banner_text(model, "#")},
                                        {"title", string_literal(model.name)},
                                        {"solver", context.names.solver},
                                        {"scalar", context.scalar},
                                        {"numpy_type", context.scalar == "float" ? "float32" : "float64"},
                                        {"parameters", python_fields(context.scalar, parameter_members(context))},
                                        {"inputs", python_fields(context.scalar, input_members(context))},
                                        {"outputs", python_fields(context.scalar, output_members(context))},
                                        {"coordinate_names", python_list(coordinate_names(context.topology))},
                                        {"coordinate_size", size_text(context.layout.coordinates)},
                                        {"auxiliary_size", size_text(context.layout.auxiliary_states)}});
}

}  // namespace mbgen
