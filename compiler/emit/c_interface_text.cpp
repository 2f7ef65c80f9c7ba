#include "compiler/emit/c_interface_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "compiler/emit/frame.hpp"
#include "compiler/emit/input_text.hpp"
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

/// What the interfaces say and do about rates of inputs.
struct RatesText {
  std::string comment;                ///< of the inputs, in C
  std::string declaration, function;  ///< of set_rates_given, empty where no rates can be made, as are the next
  std::string member, restart;        ///< of the struct that a solver is
  std::string now;                    ///< the inputs at the time of the state
  std::string step;                   ///< body of the step
};

RatesText rates_text(const EmitContext& context) {
  const std::string& solver = context.names.solver;
  const std::string inputs = "solver->inputs",
                    step = solver + (context.model.solver.is_multistep()
                                         ? "::step_abm4(solver->parameters, {}, solver->state, solver->history, h)"
                                         : "::step_rk4(solver->parameters, {}, solver->state, h)");
  const auto step_with = [&](const std::string& name) { return fmt::format(fmt::runtime(step), name); };
  if (!inputs_have_derivatives(context.model.inputs)) {
    return {"/* Inputs. They are constant during a step. */", "", "", "", "", inputs,
            "  return to_c(" + step_with(inputs) + ");\n"};
  }
  const std::string h = context.scalar == "float" ? "static_cast<float>(h)" : "h";
  const std::string advance = "solver->inputs = " + solver + "::advance_inputs(solver->inputs, " + h + ");\n";
  const std::string goes_on =
      "Inputs. Those whose derivative is an input too go on by it, during a step and after it until they are set "
      "again; "
      "the others are constant.";
  if (input_rows(context.model.inputs).empty()) {
    return {"/*\n" + wrapped_words(goes_on, " * ") + "\n */",
            "",
            "",
            "",
            "",
            inputs,
            "  const mbgen::Status status = " + step_with(inputs) + ";\n  if (status.ok()) " + advance +
                "  return to_c(status);\n"};
  }
  const std::string made =
      " Of an input whose rates are all left at zero the solver makes them from the values that it is given before "
      "each "
      "step: the input follows a smooth curve through these, half a step late for the input and for each of its rates. "
      "After " +
      solver +
      "_reset, _assemble and _set_state it stands at its value. Rates of which one was other than "
      "zero since then are taken as they are given.";
  const std::string api = guard_of(solver) + "API ",
                    name = "void " + solver + "_set_rates_given(" + solver + "_solver* solver, int given)";
  return {.comment = "/*\n" + wrapped_words(goes_on + made, " * ") + "\n */",
          .declaration =
              "/* With 1 the rates of inputs are taken as they are given, also where all of them are zero; 0 is the "
              "default. */\n" +
              api + name + ";\n",
          .function = "\n" + name + " { solver->paths.rates_given = given != 0; }\n",
          .member = "  " + solver + "::InputPaths paths;  ///< of inputs whose rates are not given\n",
          .restart = "  solver->paths.restart();\n",
          .now = "solver->paths.now(solver->inputs)",
          .step = (context.model.solver.is_multistep()
                       ? "  if (solver->paths.moves(solver->inputs)) solver->history = {};\n"
                       : std::string()) +
                  "  " + solver +
                  "::InputPaths paths = solver->paths;\n"
                  "  const Inputs inputs = paths.of_step(solver->inputs, h);\n"
                  "  const mbgen::Status status = " +
                  step_with("inputs") +
                  ";\n"
                  "  if (status.ok()) {\n    solver->paths = paths;\n    " +
                  advance + "  }\n  return to_c(status);\n"};
}

/// Quoted, for Python: the escapes of C++ that string_literal writes are those of Python, too.
std::string python_list(const std::vector<std::string>& items) {
  std::vector<std::string> literals;
  for (const std::string& item : items) literals.push_back(string_literal(item));
  return fmt::format("[{}]", fmt::join(literals, ", "));
}

constexpr const char* kPythonRatesDeclared = "        (\"set_rates_given\", None, [pointer, number]),\n";
constexpr const char* kPythonRatesGiven = R"(
    def set_rates_given(self, given=True):
        """Whether rates of inputs are taken as they are given, also where all of them are zero."""
        self._call("set_rates_given", self._solver, int(given))
)";

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
  const RatesText rates = rates_text(context);
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
       {"input_comment", rates.comment},
       {"rates_given", rates.declaration},
       {"output_struct", c_structure(context.scalar, solver + "_outputs", output_members(context))},
       {"coordinate_size", size_text(context.layout.coordinates)},
       {"auxiliary_size", size_text(context.layout.auxiliary_states)},
       {"first_notice", std::to_string(static_cast<int>(kFirstNotice))},
       {"integrator", context.model.solver.is_multistep() ? "Adams-Bashforth-Moulton" : "Runge-Kutta"}});
}

std::string c_source_text(const EmitContext& context) {
  const std::string& solver = context.names.solver;
  const RatesText rates = rates_text(context);
  return fill_template(
      "c_interface.cpp.in",
      {{"banner", banner_text(context.model, "//")},
       {"solver", solver},
       {"scalar", context.scalar},
       {"coordinate_size", size_text(context.layout.coordinates)},
       {"parameters_in", copies(parameter_members(context))},
       {"parameters_out", copies(parameter_members(context))},
       {"inputs_in", copies(input_members(context))},
       {"inputs_out", copies(input_members(context))},
       {"outputs_out", copies(output_members(context))},
       {"parameter_table", array_text(fmt::format("constexpr {} Parameters::*kParameterMembers", context.scalar),
                                      member_places("Parameters", context.names.parameters), "nullptr")},
       {"step", rates.step},
       {"paths_member", rates.member},
       {"paths_restart", rates.restart},
       {"inputs_now", rates.now},
       {"rates_given", rates.function},
       {"name_functions", name_functions(context)},
       {"version", kMbgenVersion}});
}

std::string python_text(const EmitContext& context) {
  const Model& model = context.model;
  const bool makes_rates = !input_rows(model.inputs).empty();
  return fill_template("module.py.in", {{"banner", banner_text(model, "#")},
                                        {"declare_rates", makes_rates ? kPythonRatesDeclared : ""},
                                        {"rates_given", makes_rates ? kPythonRatesGiven : ""},
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
