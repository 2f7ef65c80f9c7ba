#include <algorithm>
#include <limits>

#include "compiler/emit/context_values.hpp"
#include "compiler/emit/mapped.hpp"
#include "compiler/emit/number_limits.hpp"
#include "compiler/emit/quantity_ranges.hpp"
#include "compiler/emit/text.hpp"
#include "compiler/emit/texts.hpp"
#include "compiler/model/inputs.hpp"
#include "compiler/topology/names.hpp"
#include "mbgen/status.hpp"

namespace mbgen {
namespace {

FrameRows c_members(const std::vector<NumberMember>& members) {
  return mapped(members, [](const NumberMember& member) {
    return FrameValues{{"member", member.name}, {"unit", c_comment_text(member.unit)}};
  });
}

/// Rows of the items that have a range: place, member and range.
template <class Given>
FrameRows range_rows(const std::vector<Given>& all, const std::vector<std::string>& members, Scalar scalar) {
  const double largest =
      scalar == Scalar::floats ? std::numeric_limits<float>::max() : std::numeric_limits<double>::max();
  FrameRows rows;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Presentation& shown = all[i].shown;
    if (!shown.min && !shown.max) continue;
    rows.push_back({{"place", i},
                    {"member", members[i]},
                    {"least", number_text(limit_in(shown.min.value_or(-largest), scalar), scalar)},
                    {"most", number_text(limit_in(shown.max.value_or(largest), scalar), scalar)}});
  }
  return rows;
}

/// Comment of the header on the inputs.
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

/// Quoted list for Python: string_literal writes escapes of C++ that are valid in Python too.
std::string python_list(const std::vector<std::string>& items) {
  return "[" + joined(mapped(items, string_literal), ", ") + "]";
}

}  // namespace

std::string c_header_text(const EmitContext& context) {
  const SolverNames& names = context.names;
  return fill_template(context, "c_interface.h.in",
                       {{"banner", c_banner_text(context.model)},
                        {"title", c_comment_text(context.model.name)},
                        {"guard", guard_of(names.solver)},
                        {"parameters", c_members(parameter_members(context))},
                        {"inputs", c_members(input_members(context))},
                        {"input_comment", input_comment(context)},
                        {"outputs", c_members(output_members(context))},
                        {"has_quantities", has_quantities(context)},
                        {"holds", context.layout.holds > 0 ? std::to_string(context.layout.holds) : ""},
                        {"not_held", kNotHeldName},
                        {"not_held_text", text(kNotHeld)},
                        {"not_held_code", static_cast<int>(kNotHeld)},
                        {"first_notice", static_cast<int>(kFirstNotice)},
                        {"integrator", context.model.solver.is_implicit()    ? "linearly implicit, ROS34PW2"
                                       : context.model.solver.is_multistep() ? "Adams-Bashforth-Moulton"
                                                                             : "Runge-Kutta"}});
}

std::string c_source_text(const EmitContext& context) {
  const bool makes_rates = !input_rows(context.model.inputs).empty(),
             is_multistep = context.model.solver.is_multistep();
  const std::string arguments = std::string(makes_rates ? "inputs" : "solver->inputs") + ", solver->state" +
                                (is_multistep ? ", solver->history" : "");
  const char* inputs_now = makes_rates ? "solver->paths.now(solver->inputs)" : "solver->inputs";
  return fill_template(
      context, "c_interface.cpp.in",
      {{"parameters", name_rows(names_of(parameter_members(context)))},
       {"inputs", name_rows(names_of(input_members(context)))},
       {"outputs", name_rows(names_of(output_members(context)))},
       {"parameter_table",
        array_text(std::string("constexpr ") + name_of(context.options.scalar) + " Parameters::*kParameterMembers",
                   member_places("Parameters", context.names.parameters), "nullptr")},
       {"guard", guard_of(context.names.solver)},
       {"parameter_ranges",
        range_rows(tunable_parameters(context.model), context.names.parameters, context.options.scalar)},
       {"has_quantities", has_quantities(context)},
       {"has_input_quantities", has_input_quantities(context)},
       {"input_ranges", range_rows(context.model.inputs, context.names.inputs, context.options.scalar)},
       {"method", step_function(context.model.solver)},
       {"arguments", arguments},
       {"h", context.options.scalar == Scalar::floats ? "static_cast<float>(h)" : "h"},
       {"inputs_now", inputs_now},
       {"inputs_used", context.layout.grounds > 0 ? "now" : inputs_now}});
}

std::vector<EmittedFile> tangents_c_files(const EmitContext& context) {
  const SolverNames& names = context.names;
  const std::string guard = guard_of(names.solver);
  const auto table = [](const std::string& type, const std::string& name, const std::vector<std::string>& members) {
    return array_text("constexpr Real " + type + "::*" + name, member_places(type, members), "nullptr");
  };
  const FrameRows outputs = name_rows(names_of(output_members(context)));
  const FrameValues header = {{"banner", c_banner_text(context.model)},
                              {"title", c_comment_text(context.model.name)},
                              {"guard", guard},
                              {"output_size", outputs.size()}};
  const FrameValues source = {{"parameters", name_rows(names.parameters)},
                              {"inputs", name_rows(names.inputs)},
                              {"outputs", outputs},
                              {"parameter_table", table("Parameters", "kParameterMembers", names.parameters)},
                              {"input_table", table("Inputs", "kInputMembers", names.inputs)},
                              {"method", step_function(context.model.solver)}};
  return {{names.solver + "_tangents_c.h", fill_template(context, "tangents_c.h.in", header)},
          {names.solver + "_tangents_c.cpp", fill_template(context, "tangents_c.cpp.in", source)},
          {names.solver + "_tangents.py",
           fill_template(context, "tangents.py.in", {{"banner", banner_text(context.model, "#")}})}};
}

std::string python_text(const EmitContext& context) {
  const Model& model = context.model;
  return fill_template(context, "module.py.in",
                       {{"banner", banner_text(model, "#")},
                        {"title", string_literal(model.name)},
                        {"has_quantities", has_quantities(context)},
                        {"numpy_type", context.options.scalar == Scalar::floats ? "float32" : "float64"},
                        {"parameters", member_rows(parameter_members(context))},
                        {"inputs", member_rows(input_members(context))},
                        {"outputs", member_rows(output_members(context))},
                        {"actuator_names", python_list(names_of(context.model.actuators))},
                        {"coordinate_names", python_list(coordinate_names(context.topology))}});
}

}  // namespace mbgen
