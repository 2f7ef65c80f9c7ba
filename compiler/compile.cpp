#include "compiler/compile.hpp"

#include <array>
#include <utility>

#include "compiler/passes/passes.hpp"

namespace mbgen {

namespace {

/// The programs that a solver runs, whatever its form.
std::array<Program*, 6> solver_programs(Programs& programs) {
  return {&programs.accelerations,        &programs.closure,     &programs.closure_terms,
          &programs.accelerations_chosen, &programs.multipliers, &programs.outputs};
}

}  // namespace

Programs optimise(Programs programs) {
  for (Program* program : solver_programs(programs)) *program = optimise(std::as_const(*program));
  programs.recursive_accelerations = optimise(std::as_const(programs.recursive_accelerations));
  return programs;
}

void take_form(Programs& programs, std::optional<Form> form) {
  const long matrix = count_operations(programs.accelerations).total();
  const long recursive = count_operations(programs.recursive_accelerations).total();
  programs.operations_of_form[static_cast<int>(Form::matrix)] = matrix;
  programs.operations_of_form[static_cast<int>(Form::recursive)] = recursive;
  programs.form = form.value_or(recursive < matrix ? Form::recursive : Form::matrix);
  if (programs.form == Form::recursive) programs.accelerations = std::move(programs.recursive_accelerations);
  programs.recursive_accelerations = {};
}

void take_out_derived_constants(Programs& programs) {
  programs.derived_constants = take_out_derived(solver_programs(programs), "par", "derived_constants");
}

void count_savings(Compilation& compilation) {
  const auto operations = [](const Program& program) { return count_operations(program).total(); };
  Programs& programs = compilation.programs;
  const long* of_form = programs.operations_of_form;
  std::vector<Saving>& savings = programs.savings;
  savings.push_back(
      {"recursive form", of_form[static_cast<int>(Form::matrix)], of_form[static_cast<int>(Form::recursive)]});
  for (const auto& [name, program] : trace_without(compilation.model, compilation.topology, compilation.analysis))
    savings.push_back({name, operations(optimise(program)), of_form[static_cast<int>(Form::recursive)]});
  const Programs traced = trace(compilation.model, compilation.topology, compilation.analysis);
  const Program& start = programs.form == Form::recursive ? traced.recursive_accelerations : traced.accelerations;
  for (const PassCount& pass : count_passes(start)) savings.push_back({pass.name, pass.before, pass.after});
}

Result<Compilation> compile(Model model, std::optional<Form> form) {
  Result<Topology> topology = build_topology(model);
  if (!topology) return topology.problems();

  Result<Analysis> analysis = analyse(model, *topology);
  if (!analysis) return analysis.problems();

  Programs programs = optimise(trace(model, *topology, *analysis));
  take_form(programs, form);
  take_out_derived_constants(programs);
  return Compilation{std::move(model), std::move(*topology), std::move(*analysis), std::move(programs)};
}

Result<Compilation> compile(const std::string& path, std::optional<Form> form) {
  Result<Model> model = read_model_file(path);
  if (!model) return model.problems();
  return compile(std::move(*model), form);
}

Programs as_emitted(Programs programs) {
  for (Program* program : solver_programs(programs)) *program = contract(std::as_const(*program));
  // The matrix form keeps the order of the paper's steps.
  if (programs.form == Form::recursive) programs.accelerations = shorten_lifetimes(programs.accelerations);
  return programs;
}

std::vector<EmittedFile> emit(const Compilation& compilation, const EmitOptions& options) {
  return emit(as_emitted(compilation.programs), compilation.model, compilation.topology, compilation.analysis, options);
}

Programs whole_programs(const Compilation& c) {
  Programs whole = optimise(trace(c.model, c.topology, c.analysis));
  take_form(whole, c.programs.form);
  return whole;
}

FmuFiles emit_fmu(const Compilation& c, const InitialState& initial, FmiVersion version) {
  return emit_fmu(whole_programs(c), as_emitted(c.programs), c.model, c.topology, c.analysis, initial, version);
}

Result<LinearSystem> linearise(const Compilation& c, const OperatingPoint& point) {
  return linearise(c.model, c.topology, c.analysis, whole_programs(c), point);
}

EmittedFile emit_clocked_driver(const Compilation& c, int lanes) {
  return emit_clocked_driver(as_emitted(c.programs), c.model, c.topology, c.analysis, lanes);
}

}  // namespace mbgen
