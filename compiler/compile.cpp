#include "compiler/compile.hpp"

#include <fmt/format.h>

#include <algorithm>
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
  const bool has_matrix = !programs.accelerations.outputs.empty();
  const bool has_recursive = !programs.recursive_accelerations.outputs.empty();
  const bool is_recursive = has_recursive && (recursive < matrix || !has_matrix);
  programs.form = form.value_or(is_recursive ? Form::recursive : Form::matrix);
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
  if (of_form[0] == 0 || of_form[1] == 0) return;
  std::vector<Saving>& savings = programs.savings;
  savings.push_back(
      {"recursive form", of_form[static_cast<int>(Form::matrix)], of_form[static_cast<int>(Form::recursive)]});
  for (const auto& [name, program] : trace_without(compilation.model, compilation.topology, compilation.analysis))
    savings.push_back({name, operations(optimise(program)), of_form[static_cast<int>(Form::recursive)]});
  const Programs traced = trace(compilation.model, compilation.topology, compilation.analysis);
  const Program& start = programs.form == Form::recursive ? traced.recursive_accelerations : traced.accelerations;
  for (const PassCount& pass : count_passes(start)) savings.push_back({pass.name, pass.before, pass.after});
}

Result<Compilation> decide(Model model) {
  Result<Topology> topology = build_topology(model);
  if (!topology) return topology.problems();

  Result<Analysis> analysis = analyse(model, *topology);
  if (!analysis) return analysis.problems();

  return Compilation{std::move(model), std::move(*topology), std::move(*analysis), {}};
}

Result<Compilation> decide(const std::string& path) {
  Result<Model> model = read_model_file(path);
  if (!model) return model.problems();
  return decide(std::move(*model));
}

namespace {

/// Parts of a model that have a title of their own in its programs.
std::size_t titles_of(const Compilation& c) {
  const Model& m = c.model;
  return c.topology.bodies.size() + c.topology.loops.size() + c.topology.blocks.size() + m.bodies.size() +
         m.springs.size() + m.air_springs.size() + m.joint_springs.size() + m.frictions.size() + m.joint_forces.size() +
         m.forces.size() + 2 * m.tyres.size() + m.motions.size() + m.outputs.size();
}

/// The refusal of a model with more parts than a program tells apart.
Diagnostics too_many_parts(const Compilation& c) {
  const std::size_t titles = titles_of(c);
  if (titles <= kMostTitles) return {};
  Where whole_file;
  whole_file.file = c.model.file;
  return {{whole_file,
           fmt::format("the solver of this model is too large to be written: {} bodies, joints, loops, force elements "
                       "and outputs, at most {} are written",
                       titles, kMostTitles),
           "simulate it with --engine generic, which writes nothing, or make the model smaller", ""}};
}

}  // namespace

Diagnostics too_large(const Compilation& c, std::optional<Form> form) {
  if (Diagnostics problems = too_many_parts(c); !problems.empty()) return problems;
  const auto [matrix, recursive] = least_operations(c.topology, c.analysis);
  const double least = !form ? std::min(matrix, recursive) : *form == Form::matrix ? matrix : recursive;
  if (least <= kMostOperations) return {};
  Where whole_file;
  whole_file.file = c.model.file;
  const bool other = form && std::min(matrix, recursive) <= kMostOperations;
  return {
      {whole_file,
       fmt::format("the {} of this model is too large to be written: {} coordinates with {} free directions take at "
                   "least {:.2g} operations, at most {:.2g} are written",
                   form ? fmt::format("{} form", name_of(*form)) : "solver", c.topology.size(),
                   free_coordinates(c.topology, c.analysis).size(), least, kMostOperations),
       other ? fmt::format("--form {} is smaller", name_of(*form == Form::matrix ? Form::recursive : Form::matrix))
             : "simulate it with --engine generic, which writes nothing, or make the model smaller",
       ""}};
}

void add_programs(Compilation& decided, std::optional<Form> form) {
  decided.programs = optimise(trace(decided.model, decided.topology, decided.analysis, form));
  take_form(decided.programs, form);
  take_out_derived_constants(decided.programs);
}

Result<Compilation> compile(Model model, std::optional<Form> form) {
  Result<Compilation> decided = decide(std::move(model));
  if (!decided) return decided;
  if (Diagnostics problems = too_large(*decided, form); !problems.empty()) return problems;
  add_programs(*decided, form);
  return decided;
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
  Programs whole = optimise(trace(c.model, c.topology, c.analysis, c.programs.form));
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
