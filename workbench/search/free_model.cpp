#include "workbench/search/free_model.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "compiler/reader/read_model.hpp"
#include "compiler/text/user_error.hpp"
#include "workbench/host/assignments.hpp"
#include "workbench/host/message.hpp"
#include "workbench/start/initial_state.hpp"

namespace mbgen {
namespace {

std::vector<VariedParameter> varied_by(const FreeModel& model, const std::vector<Unknown>& unknowns,
                                       const std::vector<double>& values) {
  std::vector<VariedParameter> varied = model.set;
  for (std::size_t u = 0; u < unknowns.size(); ++u)
    if (unknowns[u].kind == Unknown::Kind::parameter) varied.push_back({unknowns[u].name, values[u], model.is_tuned});
  return varied;
}

/// Lets the free parameters be tunable, or finds out why they cannot.
void choose_tuning(FreeModel& model, const std::vector<Unknown>& unknowns, const std::vector<double>& starts) {
  Result<Model> tuned = read_varied_model(model.arguments.path, varied_by(model, unknowns, starts));
  if (tuned) {
    model.model = std::move(*tuned);
    model.model.solver.integrator = model.choice.integrator;
    return;
  }
  const Diagnostic& first = tuned.problems().front();
  model.is_tuned = false;
  model.why_not_tuned =
      fmt::format("{}:{}:{}: {}", first.where.file, first.where.line, first.where.column, first.message);
  model.model = expect(read_varied_model(model.arguments.path, varied_by(model, unknowns, starts)));
  model.model.solver.integrator = model.choice.integrator;
  if (model.choice.name != "generated") return;
  if (model.arguments.has_engine)
    throw UserError(fmt::format(
        "--engine generated: one solver cannot serve all values: {}\n  hint: leave out --engine: the model is then "
        "analysed for each value and runs on the generic engine\n",
        model.why_not_tuned));
  model.choice.name = "generic";
}

/// Loads the solver with derivatives, unless the start has none.
void choose_derivatives(FreeModel& model, const std::vector<Unknown>& unknowns, const std::vector<double>& starts) {
  model.tangents = load_tangents(model.compilation, model.choice);
  try {
    const Compilation compilation = compilation_at(model, unknowns, starts);
    std::vector<double> inputs;
    for (const Input& input : compilation.model.inputs) inputs.push_back(input.default_value);
    TangentEngine moving = engine_of(model, unknowns, compilation, true);
    start_motion(compilation, initial_start(compilation, inputs).state, moving);
  } catch (const UserError& error) {
    model.tangents = nullptr;
    model.why_differences = first_line(error.what());
  }
}

}  // namespace

FreeModel read_free_model(const ModelArguments& arguments) {
  FreeModel model{.arguments = arguments};
  model.model = expect(read_model_file(arguments.path));
  model.set = set_parameters(model.model, arguments.set);
  model.model = expect(read_varied_model(arguments.path, model.set));
  SimulationArguments simulation = arguments.simulation;
  const SimulationSettings settings = settings_of(simulation, model.model.solver);
  follow_step(settings, model.set, model.model);
  require_whole_periods(settings, model.model);
  model.choice = chosen_engine(arguments.engine);
  require_engine(model.choice.name);
  model.choice.integrator = model.model.solver.integrator =
      integrator_of(simulation.integrator, model.model.solver.integrator, model.choice.name);
  return model;
}

void prepare(FreeModel& model, const std::vector<Unknown>& unknowns, const Uses& uses) {
  std::vector<double> starts;
  for (const Unknown& unknown : unknowns) {
    starts.push_back(unknown.start);
    for (const VariedParameter& given : model.set)
      if (unknown.kind == Unknown::Kind::parameter && given.name == unknown.name)
        throw UserError(fmt::format("--set {0}: --free finds the value of \"{0}\"\n", given.name));
  }
  if (!uses.motions && !model.arguments.has_engine) model.choice.name = "generic";
  choose_tuning(model, unknowns, starts);
  if (!model.is_tuned) return;
  const bool is_generated = model.choice.name == "generated";
  model.compilation = expect(is_generated ? decide_to_write(model.model) : decide(model.model));
  if (uses.modes) add_programs(model.compilation);
  if (!is_generated) return;
  model.table = load_solver(model.compilation, model.choice);
  if (uses.motions) choose_derivatives(model, unknowns, starts);
}

Compilation compilation_at(const FreeModel& model, const std::vector<Unknown>& unknowns,
                           const std::vector<double>& values) {
  Model at = expect(read_varied_model(model.arguments.path, varied_by(model, unknowns, values)));
  at.solver.integrator = model.choice.integrator;
  if (!model.is_tuned) return expect(decide(std::move(at)));
  return {std::move(at), model.compilation.topology, model.compilation.analysis, {}};
}

TangentEngine engine_of(const FreeModel& model, const std::vector<Unknown>& unknowns, const Compilation& compilation,
                        bool with_derivatives) {
  std::vector<std::string> names;
  for (const Unknown& unknown : unknowns)
    if (unknown.kind == Unknown::Kind::parameter) names.push_back(unknown.name);
  return make_moving_engine({model.table, with_derivatives ? model.tangents : nullptr}, compilation, model.choice,
                            names);
}

}  // namespace mbgen
