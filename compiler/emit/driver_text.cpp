#include "compiler/emit/driver_text.hpp"

#include "compiler/emit/frame.hpp"
#include "compiler/emit/interface_text.hpp"
#include "compiler/emit/program_text.hpp"
#include "compiler/emit/text.hpp"
#include "compiler/emit/titles.hpp"

namespace mbgen {
namespace {

/// One assignment a line: `  parameters.k = values[0];`.
std::string assignments(const std::string& structure, const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i) {
    text += "  " + structure + "." + names[i] + " = values[" + std::to_string(i) + "];\n";
  }
  return text;
}

/// step_clock: text of the function step_ticks, "" for a driver without.
EmittedFile driver(const Model& model, int lanes, const std::string& step_clock) {
  const SolverNames names = model_names(model);
  std::vector<double> parameters, inputs;
  for (const Parameter& parameter : model.parameters) {
    if (parameter.tunable) parameters.push_back(parameter.value);
  }
  for (const Input& input : model.inputs) inputs.push_back(input.default_value);
  std::string outputs_to;
  for (std::size_t i = 0; i < names.outputs.size(); ++i) {
    outputs_to += "  y[" + std::to_string(i) + "] = values." + names.outputs[i] + ";\n";
  }
  const std::string batch = lanes > 0 ? fill_template("batch_driver.cpp.in", {{"solver", names.solver}}) : "";
  return {
      names.solver + "_driver.cpp",
      fill_template(
          "driver.cpp.in",
          {{"banner", banner_text(model, "//")},
           {"solver", names.solver},
           {"default_parameters", array_text("constexpr double kDefaultParameters", number_texts(parameters), "0.0")},
           {"default_inputs", array_text("constexpr double kDefaultInputs", number_texts(inputs), "0.0")},
           {"parameters_from", assignments("parameters", names.parameters)},
           {"inputs_from", assignments("inputs", names.inputs)},
           {"outputs_to", outputs_to},
           {"interface", lanes > 0 ? "_batch" : ""},
           {"batch", batch},
           {"batch_entries", lanes > 0
                                 ? std::to_string(lanes) + ",\n    batch_accelerations,\n    time_batch_accelerations"
                                 : "0,\n    nullptr,\n    nullptr"},
           {"step_clock", step_clock},
           {"step_ticks", step_clock.empty() ? "nullptr" : "step_ticks"}})};
}

}  // namespace

EmittedFile emit_driver(const Model& model, int lanes) { return driver(model, lanes, ""); }

EmittedFile emit_clocked_driver(const Programs& programs, const Model& model, const Topology& topology,
                                const Analysis& analysis, int lanes) {
  const SolverNames names = solver_names(model, topology);
  const ShapedProgram clocked = clocked_accelerations(programs, solver_layout(model, topology, analysis), names,
                                                      titles_of(programs.form, model, topology));
  const std::string program = program_text(*clocked.program, clocked.schedule, clocked.shape);
  return driver(model, lanes, fill_template("step_clock.cpp.in", {{"solver", names.solver}, {"program", program}}));
}

}  // namespace mbgen
