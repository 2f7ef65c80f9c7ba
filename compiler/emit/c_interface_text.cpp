#include "compiler/emit/c_interface_text.hpp"

#include <algorithm>

#include "compiler/emit/frame.hpp"
#include "compiler/emit/input_text.hpp"
#include "compiler/emit/mapped.hpp"
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

FrameRows c_members(const std::vector<NumberMember>& members) {
  return mapped(members, [](const NumberMember& member) {
    return FrameValues{{"member", member.name}, {"unit", c_comment_text(member.unit)}};
  });
}

/// What the header says of the inputs.
std::string input_comment(const EmitContext& context) {
  const std::vector<Input>& inputs = context.model.inputs;
  if (!inputs_have_derivatives(inputs)) return "/* Inputs. They are constant during a step. */";
  const std::string goes_on =
      "Inputs. Those whose derivative is an input too go on by it, during a step and after it until they are set "
      "again; the others are constant.";
  const std::string made =
      " Of an input whose rates are all left at zero the solver makes them from the values that it is given before "
      "each step: the input follows a smooth curve through these, half a step late for the input and for each of its "
      "rates. After " +
      context.names.solver +
      "_reset, _assemble and _set_state it stands at its value. Rates of which one was other than zero since then are "
      "taken as they are given.";
  return "/*\n" + wrapped_words(input_rows(inputs).empty() ? goes_on : goes_on + made, " * ") + "\n */";
}

/// Quoted, for Python: the escapes of C++ that string_literal writes are those of Python, too.
std::string python_list(const std::vector<std::string>& items) {
  return "[" + joined(mapped(items, string_literal), ", ") + "]";
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
  return fill_template(
      "c_interface.h.in",
      {{"banner", c_banner_text(context.model)},
       {"title", c_comment_text(context.model.name)},
       {"solver", names.solver},
       {"scalar", context.options.scalar},
       {"guard", guard_of(names.solver)},
       {"coordinate_count", names.coordinates.size()},
       {"auxiliary_count", context.layout.auxiliary_states},
       {"parameter_count", names.parameters.size()},
       {"input_count", names.inputs.size()},
       {"output_count", names.outputs.size()},
       {"parameters", c_members(parameter_members(context))},
       {"inputs", c_members(input_members(context))},
       {"input_comment", input_comment(context)},
       {"makes_rates", !input_rows(context.model.inputs).empty()},
       {"outputs", c_members(output_members(context))},
       {"coordinate_size", size_text(context.layout.coordinates)},
       {"auxiliary_size", size_text(context.layout.auxiliary_states)},
       {"first_notice", static_cast<int>(kFirstNotice)},
       {"integrator", context.model.solver.is_multistep() ? "Adams-Bashforth-Moulton" : "Runge-Kutta"}});
}

std::string c_source_text(const EmitContext& context) {
  const bool makes_rates = !input_rows(context.model.inputs).empty(),
             is_multistep = context.model.solver.is_multistep();
  const std::string arguments = std::string(makes_rates ? "inputs" : "solver->inputs") + ", solver->state" +
                                (is_multistep ? ", solver->history" : "");
  return fill_template(
      "c_interface.cpp.in",
      {{"banner", banner_text(context.model, "//")},
       {"solver", context.names.solver},
       {"scalar", context.options.scalar},
       {"coordinate_size", size_text(context.layout.coordinates)},
       {"parameters", name_rows(names_of(parameter_members(context)))},
       {"inputs", name_rows(names_of(input_members(context)))},
       {"outputs", name_rows(names_of(output_members(context)))},
       {"parameter_table", array_text("constexpr " + context.options.scalar + " Parameters::*kParameterMembers",
                                      member_places("Parameters", context.names.parameters), "nullptr")},
       {"balls", context.layout.balls > 0},
       {"advances", inputs_have_derivatives(context.model.inputs)},
       {"makes_rates", makes_rates},
       {"is_multistep", is_multistep},
       {"method", is_multistep ? "step_abm4" : "step_rk4"},
       {"arguments", arguments},
       {"h", context.options.scalar == "float" ? "static_cast<float>(h)" : "h"},
       {"inputs_now", makes_rates ? "solver->paths.now(solver->inputs)" : "solver->inputs"},
       {"version", kMbgenVersion}});
}

std::string python_text(const EmitContext& context) {
  const Model& model = context.model;
  return fill_template("module.py.in",
                       {{"banner", banner_text(model, "#")},
                        {"makes_rates", !input_rows(model.inputs).empty()},
                        {"title", string_literal(model.name)},
                        {"solver", context.names.solver},
                        {"scalar", context.options.scalar},
                        {"numpy_type", context.options.scalar == "float" ? "float32" : "float64"},
                        {"parameters", member_rows(parameter_members(context))},
                        {"inputs", member_rows(input_members(context))},
                        {"outputs", member_rows(output_members(context))},
                        {"coordinate_names", python_list(mapped(context.topology.bodies, &TreeBody::coordinate))},
                        {"coordinate_size", size_text(context.layout.coordinates)},
                        {"auxiliary_size", size_text(context.layout.auxiliary_states)}});
}

}  // namespace mbgen
