// The driver of a compiled solver.

#include "compiler/emit/context_values.hpp"
#include "compiler/emit/emit.hpp"
#include "compiler/emit/law_text.hpp"
#include "compiler/emit/mapped.hpp"
#include "compiler/emit/shapes.hpp"
#include "compiler/emit/text.hpp"
#include "compiler/emit/texts.hpp"
#include "compiler/model/inputs.hpp"

namespace mbgen {
namespace {

/// A row for each name, with its place.
FrameRows numbered_rows(const std::vector<std::string>& names) {
  FrameRows rows;
  for (const std::string& name : names) rows.push_back({{"member", name}, {"place", rows.size()}});
  return rows;
}

/// clocked: the program that receives the end of each step, "" for a driver without. laws: whether it has shared laws;
/// inverse: whether the solver has inverse dynamics. suffix: of the solver's name, "_tangents" for the one with
/// derivatives.
EmittedFile driver(const Model& model, int lanes, const std::string& clocked, bool laws, bool inverse,
                   const std::string& suffix = "") {
  SolverNames names = model_names(model);
  names.solver += suffix;
  const std::vector<double> parameters = mapped(tunable_parameters(model), &Parameter::value);
  const std::vector<double> inputs = mapped(model.inputs, &Input::default_value);
  return {names.solver + "_driver.cpp",
          fill_template("driver.cpp.in",
                        {{"banner", banner_text(model, "//")},
                         {"solver", names.solver},
                         {"default_parameters",
                          array_text("constexpr double kDefaultParameters", number_texts(parameters), "0.0")},
                         {"default_inputs", array_text("constexpr double kDefaultInputs", number_texts(inputs), "0.0")},
                         {"parameters", numbered_rows(names.parameters)},
                         {"inputs", numbered_rows(names.inputs)},
                         {"outputs", numbered_rows(names.outputs)},
                         {"samples", !model.sampled.empty()},
                         {"advances", inputs_have_derivatives(model.inputs)},
                         {"lanes", lanes > 0 ? std::to_string(lanes) : ""},
                         {"is_implicit", model.solver.is_implicit()},
                         {"laws", laws},
                         {"inverse", inverse},
                         {"tangents", !suffix.empty()},
                         {"number", suffix.empty() ? "double" : names.solver + "::Real"},
                         {"clocked", clocked}})};
}

}  // namespace

EmittedFile emit_driver(const Model& model, int lanes, bool inverse) {
  return driver(model, lanes, "", false, inverse);
}

EmittedFile emit_tangent_driver(const Model& model, bool inverse) {
  return driver(model, 0, "", false, inverse, kTangentSuffix);
}

EmittedFile emit_clocked_driver(const WrittenPrograms& programs, const Model& model, const Topology& topology,
                                const Analysis& analysis, int lanes) {
  const EmitContext context(programs, model, topology, analysis, {});
  const ShapedProgram clocked = clocked_accelerations(context);
  const std::string laws = law_texts(context, clocked.shape.scalar, nullptr);
  return driver(model, lanes, laws + program_text(*clocked.program, clocked.schedule, clocked.shape), !laws.empty(),
                context.layout.actuators > 0);
}

}  // namespace mbgen
