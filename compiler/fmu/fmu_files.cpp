// The files of a Functional Mock-up Unit.

#include <fmt/format.h>

#include <limits>

#include "compiler/emit/context_values.hpp"
#include "compiler/emit/emit.hpp"
#include "compiler/emit/mapped.hpp"
#include "compiler/emit/quantity_ranges.hpp"
#include "compiler/emit/text.hpp"
#include "compiler/emit/texts.hpp"
#include "compiler/fmu/texts.hpp"
#include "compiler/model/inputs.hpp"
#include "compiler/model/model.hpp"

namespace mbgen {
namespace {

std::string integers(const std::string& name, const std::vector<int>& values) {
  const auto text = [](int value) { return std::to_string(value); };
  return array_text("  static constexpr int " + name, mapped(values, text), "-1");
}

std::string numbers(const std::string& name, const std::vector<double>& values) {
  return array_text("  static constexpr double " + name, number_texts(values), "0.0") + "\n";
}

/// A table of pointers to the members of a struct.
std::string members(const std::string& structure, const std::string& name, const std::vector<NumberMember>& list) {
  return array_text("  static constexpr double " + structure + "::*" + name, member_places(structure, names_of(list)),
                    "nullptr") +
         "\n";
}

std::string start_text(const Model& model, const InitialState& initial) {
  std::vector<double> values, rates;
  for (const StartParameter& one : initial.parameters) {
    values.push_back(model.parameters[static_cast<std::size_t>(one.parameter)].value);
    rates.insert(rates.end(), one.zd.begin(), one.zd.end());
  }
  return numbers("kStartParameter", values) + numbers("kStartRate", rates);
}

/// Ranges of what can be set.
std::vector<std::string> ranges(const FmuLayout& fmu) {
  constexpr double kMost = std::numeric_limits<double>::max();
  std::vector<std::string> items;
  for (std::size_t i = 0; i < fmu.variables.size(); ++i) {
    const FmuVariable& variable = fmu.variables[i];
    const Presentation& shown = variable.shown;
    const bool is_set =
        variable.causality == FmuVariable::Causality::parameter || variable.causality == FmuVariable::Causality::input;
    if (!is_set || (!shown.min && !shown.max)) continue;
    items.push_back(fmt::format("{{{}, {}, {}}}", i, number_text(shown.min.value_or(-kMost)),
                                number_text(shown.max.value_or(kMost))));
  }
  return items;
}

/// Of the continuous states: positions, velocities, auxiliary states.
std::vector<double> nominals(const FmuLayout& fmu) {
  return mapped(fmu.derivatives, [&](const FmuUnknown& derivative) {
    const int state = fmu.variables[static_cast<std::size_t>(derivative.variable)].derivative_of;
    return fmu.variables[static_cast<std::size_t>(state)].shown.nominal.value_or(1);
  });
}

std::string names_text(const FmuLayout& fmu) {
  const auto quoted = [](const FmuVariable& variable) { return '"' + variable.name + '"'; };
  return array_text("  static constexpr const char* kNames", mapped(fmu.variables, quoted), "");
}

std::string model_text(const EmitContext& context, const FmuLayout& fmu, const InitialState& initial) {
  const SolverLayout& layout = context.layout;
  return fill_template(
      context, "fmu_model.hpp.in",
      {{"token", fmu_token(context.model)},
       {"has_quantities", has_quantities(context)},
       {"no_states", !fmu.has_states},
       {"step_size", number_text(context.model.solver.step)},
       {"largest_turn", number_text(largest_turn(context.model.solver.integrator))},
       {"output_count", output_members(context).size()},
       {"has_closure", fmt::format("{}", layout.has_closure)},
       {"takes_multipliers", fmt::format("{}", takes_multipliers(context.programs.outputs))},
       {"velocity_count", fmu.independent.size()},
       {"velocities", integers("kVelocities", fmu.independent)},
       {"chosen_count", fmu.chosen.size()},
       {"chosen", integers("kChosen", fmu.chosen)},
       {"block_of", integers("kBlockOf", fmu.block_of)},
       {"input_paths", input_rows(context.model.inputs).empty() ? "mbgen::fmu::GivenInputs<Inputs>"
                                                                : context.names.solver + "::InputPaths"},
       {"nominals", numbers("kNominal", nominals(fmu))},
       {"input_derivatives", integers("kInputDerivative", mapped(context.model.inputs, &Input::derivative))},
       {"indicator_count", fmu.indicator_blocks.size()},
       {"indicators", integers("kIndicatorBlock", fmu.indicator_blocks)},
       {"undriven_count", fmu.undriven.size()},
       {"undriven", integers("kUndriven", fmu.undriven)},
       {"start_parameter_count", initial.parameters.size()},
       {"start_parameters", start_text(context.model, initial)},
       {"members", members("Parameters", "kParameterMember", parameter_members(context)) +
                       members("Inputs", "kInputMember", input_members(context)) +
                       members("Outputs", "kOutputMember", output_members(context))},
       {"range_count", ranges(fmu).size()},
       {"ranges", array_text("  static constexpr mbgen::fmu::Range kRange", ranges(fmu), "{}")},
       {"names", names_text(fmu)},
       {"step", step_function(context.model.solver) + (context.model.solver.is_multistep()
                                                           ? "(parameters, inputs, state, history, h)"
                                                           : "(parameters, inputs, state, h)")},
       {"advanced", inputs_have_derivatives(context.model.inputs)
                        ? fmt::format("{}::advance_inputs(inputs, h)", context.names.solver)
                        : "inputs"}});
}

std::string entry_points(const EmitContext& context, FmiVersion version) {
  return fill_template(context, version == FmiVersion::two ? "fmi2.cpp.in" : "fmi3.cpp.in");
}

/// A file of templates/ as it is.
EmittedFile embedded(const std::string& name) { return {name, std::string(template_text(name))}; }

std::vector<EmittedFile> standard_headers(FmiVersion version) {
  if (version == FmiVersion::two)
    return {embedded("fmi2TypesPlatform.h"), embedded("fmi2FunctionTypes.h"), embedded("fmi2Functions.h")};
  return {embedded("fmi3PlatformTypes.h"), embedded("fmi3FunctionTypes.h"), embedded("fmi3Functions.h")};
}

}  // namespace

FmuFiles emit_fmu(const Programs& programs, const WrittenPrograms& emitted, const Model& model,
                  const Topology& topology, const Analysis& analysis, const InitialState& initial, FmiVersion version) {
  const EmitContext context(emitted, model, topology, analysis, {.initial = initial});
  const std::string& solver = context.names.solver;
  const FmuLayout fmu = fmu_layout(context, programs, initial, version);
  const std::string functions = version == FmiVersion::two ? "_fmi2.cpp" : "_fmi3.cpp";

  std::vector<EmittedFile> sources = {{solver + ".hpp", interface_text(context)},
                                      solver_file(context, shaped_programs(context), true),
                                      {solver + "_directional.hpp", directional_header_text(context)},
                                      {solver + "_directional.cpp", directional_source_text(context, programs)},
                                      {solver + "_fmu.hpp", model_text(context, fmu, initial)},
                                      {solver + functions, entry_points(context, version)}};
  FmuFiles files;
  files.identifier = solver;
  files.sources = {solver + ".cpp", solver + "_directional.cpp", solver + functions};
  files.large = solver + "_directional.cpp";
  add_samples(context, sources);
  add_quantities(context, sources);
  add_runtime_headers(sources);
  sources.push_back({"buildDescription.xml", build_description(context, version, files.sources)});
  for (EmittedFile& file : sources)
    files.packed.push_back({"sources/" + file.path, std::move(file.text), file.rare_parts});
  files.packed.push_back({"modelDescription.xml", model_description(context, fmu, version, files.sources)});
  files.packed.push_back({"documentation/index.html", documentation(context, fmu, version)});
  if (version == FmiVersion::three)
    files.packed.push_back({"terminalsAndIcons/terminalsAndIcons.xml", terminals_and_icons(fmu)});
  files.headers = standard_headers(version);
  return files;
}

}  // namespace mbgen
