#include "compiler/emit/context_values.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "compiler/analysis/held_start.hpp"
#include "compiler/emit/mapped.hpp"
#include "compiler/emit/shapes.hpp"
#include "compiler/emit/text.hpp"
#include "compiler/model/auxiliary_states.hpp"
#include "compiler/model/inputs.hpp"
#include "compiler/model/tyres.hpp"

namespace mbgen {
namespace {

/// File name without its directories: the same text for any location of the model.
std::string base_name(const std::string& path) {
  const std::size_t slash = path.find_last_of("/\\");
  return slash == std::string::npos ? path : path.substr(slash + 1);
}

/// The text without anything that would end or begin a C comment.
std::string apart(const std::string& text) {
  std::string result;
  for (const char c : text) {
    const bool joins = !result.empty() && ((result.back() == '*' && c == '/') || (result.back() == '/' && c == '*'));
    if (joins) result += ' ';
    result += c;
  }
  return result;
}

/// Periods of the sampled values, s.
std::vector<std::string> period_items(const Model& model) {
  return mapped(model.sampled, [](const SampledValue& value) { return number_text(value.period); });
}

/// The first input of each wheel on ground of the host.
std::vector<std::string> ground_inputs(const Model& model) {
  return mapped(tyres_on_host(model),
                [&](int tyre) { return std::to_string(model.roads[model.tyres[tyre].road].host_input); });
}

/// Values for the names that every frame may use.
FrameValues context_values(const EmitContext& context) {
  const SolverNames& names = context.names;
  const SolverLayout& layout = context.layout;
  const int derived = derived_constant_count(context.programs);
  return {{"banner", banner_text(context.model, "//")},
          {"solver", names.solver},
          {"has_samples", context.model.samples != nullptr},
          {"version", kMbgenVersion},
          {"scalar", name_of(context.options.scalar)},
          {"tangents", context.options.scalar == Scalar::tangents},
          {"with_tangents", context.options.tangents},
          {"with_adjoint", context.options.adjoint},
          {"directions", kDirections},
          {"lanes", context.options.lanes > 0 ? std::to_string(context.options.lanes) : ""},
          {"initial", context.options.initial.has_value()},
          {"advances", inputs_have_derivatives(context.model.inputs)},
          {"makes_rates", !input_rows(context.model.inputs).empty()},
          {"is_multistep", context.model.solver.is_multistep()},
          {"is_implicit", context.model.solver.is_implicit()},
          {"outputs_take_multipliers", takes_multipliers(context.programs.outputs)},
          {"samples_take_reactions", takes_reactions(context.model)},
          {"samples_take_rates", takes(context.programs.sampled, Array::zdd)},
          {"samples_take_multipliers", takes_multipliers(context.programs.sampled)},
          {"derived", derived > 0 ? std::to_string(derived) : ""},
          {"has_closure", layout.has_closure},
          {"meets_crossings", layout.chooses_again && !layout.blocks.empty() && !context.regular_only},
          {"regular_only", context.regular_only},
          {"passage_entries", std::max(1, layout.projection_entries)},
          {"balls", layout.balls > 0 ? std::to_string(layout.balls) : ""},
          {"samples", layout.sampled > 0 ? std::to_string(layout.sampled) : ""},
          {"grounds", layout.grounds > 0 ? std::to_string(layout.grounds) : ""},
          {"ground_inputs", array_text("  static constexpr int kFirstInput", ground_inputs(context.model), "0")},
          {"actuators", layout.actuators > 0 ? std::to_string(layout.actuators) : ""},
          {"completes", layout.maps_actuators},
          {"pivots_actuators", layout.pivots_actuators},
          {"held_count", layout.held},
          {"first_held", layout.auxiliary_states - layout.held},
          {"period_table", array_text("  static constexpr double kPeriods", period_items(context.model), "0")},
          {"coordinate_count", layout.coordinates},
          {"auxiliary_count", layout.auxiliary_states},
          {"parameter_count", layout.parameters},
          {"input_count", layout.inputs},
          {"output_count", layout.outputs},
          {"equation_count", layout.equations},
          {"motion_count", layout.drives},
          {"block_count", layout.blocks.size()},
          {"coordinate_size", size_text(layout.coordinates)},
          {"auxiliary_size", size_text(layout.auxiliary_states)},
          {"parameter_size", size_text(layout.parameters)},
          {"input_size", size_text(layout.inputs)},
          {"multiplier_size", size_text(layout.equations)},
          {"drive_size", size_text(layout.drives)},
          {"block_size", size_text(static_cast<int>(layout.blocks.size()))}};
}

}  // namespace

std::string fill_template(const EmitContext& context, const std::string& name, const FrameValues& values) {
  return fill_template(name, values, context_values(context));
}

std::string banner_text(const Model& model, const std::string& mark, const std::string& options) {
  return mark + " " + comment_text(model.name) + ", content hash " + model.hash + "\n" + mark +
         " Made by `mbgen generate " + comment_text(base_name(model.file)) + options + "`, mbgen " + kMbgenVersion +
         ". Change the model, not this file.";
}

std::string c_banner_text(const Model& model) { return "/*\n" + apart(banner_text(model, " *")) + "\n */"; }

std::string c_comment_text(const std::string& text) { return apart(comment_text(text)); }

std::string guard_of(const std::string& solver) {
  std::string guard = solver + "_";
  for (char& c : guard)
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  return guard;
}

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

bool starts_with_derivatives(const EmitContext& context) {
  return context.options.scalar == Scalar::tangents && context.options.initial.has_value() &&
         has_start_with_derivatives(context.model, context.topology, context.analysis);
}

std::string step_function(const SolverSettings& settings) {
  return settings.is_implicit() ? "step_rosenbrock" : settings.is_multistep() ? "step_abm4" : "step_rk4";
}

FrameRows name_rows(const std::vector<std::string>& names) {
  return mapped(names, [](const std::string& name) { return FrameValues{{"member", name}}; });
}

FrameRows member_rows(const std::vector<NumberMember>& members) {
  return mapped(members, [](const NumberMember& member) {
    return FrameValues{{"member", member.name}, {"unit", comment_text(member.unit)}};
  });
}

FrameValues tuned_values(const Programs& programs, bool constructs) {
  const int count = derived_constant_count(programs);
  std::string named;
  for (int k = 0; const std::string& name : derived_constant_names(programs)) {
    if (!name.empty()) named += fmt::format("{} [{}] {}", named.empty() ? " Among them:" : ",", k, name);
    ++k;
  }
  const std::string comment = fmt::format(
      "Tunable parameters with the {} from them. Functions take plain Parameters as well, and "
      "then work these out each time: keep one of these, and assign Parameters to it where they change, at the "
      "boundary of a step.{}{}",
      count == 1 ? "constant that follows" : fmt::format("{} constants that follow", count), named,
      named.empty() ? "" : ".");
  return {{"constructs", constructs}, {"tuned_comment", wrapped_words(comment, "/// ")}};
}

}  // namespace mbgen
