#include "compiler/compile.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <stdexcept>
#include <utility>

#include "compiler/analysis/choice_at.hpp"
#include "compiler/analysis/implicit_operations.hpp"
#include "compiler/choose/cheapest_recursion.hpp"
#include "compiler/choose/counted_partitions.hpp"
#include "compiler/passes/passes.hpp"
#include "compiler/reader/read_model.hpp"
#include "compiler/trace/trace.hpp"

namespace mbgen {
namespace {

/// Tells a watcher of each stage and of the time since the one before.
class Stages {
 public:
  explicit Stages(const StageWatch& watch) : watch_(watch) {}

  /// Result: false when the watcher has seen enough.
  bool ended(std::string_view name, const Compilation& so_far) {
    if (!watch_) return true;
    const auto now = std::chrono::steady_clock::now();
    const std::chrono::duration<double, std::milli> took = now - start_;
    const bool go_on = watch_({name, so_far, took.count()});
    start_ = std::chrono::steady_clock::now();
    return go_on;
  }

 private:
  const StageWatch& watch_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace

std::vector<std::string> stage_names() {
  std::vector<std::string> names = {"model", "topology", "analysis", "program"};
  for (const WholePass& pass : whole_passes()) names.emplace_back(pass.name);
  for (const WrittenPass& pass : written_passes()) names.emplace_back(pass.name);
  return names;
}

Result<Compilation> decide(Model model, const StageWatch& watch) {
  Stages stages(watch);
  Compilation decided{std::move(model)};
  if (!stages.ended("model", decided)) return decided;

  Result<Topology> topology = build_topology(decided.model);
  if (!topology) return grouped(topology.problems());
  decided.topology = std::move(*topology);
  if (!stages.ended("topology", decided)) return decided;

  Result<Analysis> analysis = analyse(decided.model, decided.topology);
  if (!analysis) return grouped(analysis.problems());
  decided.analysis = std::move(*analysis);
  stages.ended("analysis", decided);
  return decided;
}

Result<Compilation> decide(const std::string& path) {
  Result<Model> model = read_model_file(path);
  if (!model) return model.problems();
  return decide(std::move(*model));
}

Diagnostics too_large(const Compilation& c, std::optional<Form> form) {
  const auto [matrix, recursive] = least_operations(c.topology, c.analysis);
  const double least = !form ? std::min(matrix, recursive) : *form == Form::matrix ? matrix : recursive;
  const double implicit =
      least <= kMostOperations ? implicit_operations(c.model, c.topology, c.analysis, kMostOperations) : 0;
  if (std::max(least, implicit) <= kMostOperations) return {};
  const bool of_steps = implicit > kMostOperations;
  const bool other = form && !of_steps && std::min(matrix, recursive) <= kMostOperations;
  Where whole_file;
  whole_file.file = c.model.file;
  return {
      {whole_file,
       fmt::format("the {} of this model {} too large to be written: {} coordinates with {} free directions take at "
                   "least {:.2g} operations, at most {:.2g} are written",
                   of_steps ? "equations of implicit steps"
                   : form   ? fmt::format("{} form", name_of(*form))
                            : "solver",
                   of_steps ? "are" : "is", c.topology.size(), free_coordinates(c.topology, c.analysis).size(),
                   std::max(least, implicit), kMostOperations),
       other ? fmt::format("--form {} is smaller", name_of(other_form(*form)))
             : "simulate it with --engine generic, which writes nothing, or make the model smaller",
       ""}};
}

Result<Compilation> decide_to_write(Model model, std::optional<Form> form) {
  Result<Compilation> decided = decide(std::move(model));
  if (!decided) return decided;
  if (Diagnostics problems = too_large(*decided, form); !problems.empty()) return problems;
  return decided;
}

Form written_form(const Compilation& c, std::optional<Form> asked) {
  return asked.value_or(form_of(c.topology, c.analysis));
}

void add_programs(Compilation& c, const CompileOptions& options) {
  if (options.decided) options.decided(c);
  Stages stages(options.watch);
  const Form form = written_form(c, options.form);
  if (form == Form::recursive) choose_by_counting(c.model, c.topology, c.analysis);
  c.spelling = options.spelling;
  if (options.spelling == Spelling::reading) {
    c.emitted = written_for_reading(programs_for_reading(c.model, c.topology, c.analysis, form));
    stages.ended("program", c);
    return;
  }
  c.whole = traced_programs(c.model, c.topology, c.analysis, form);
  if (options.for_text_alone && c.whole.around_laws) c.whole.programs.accelerations = {};
  if (!stages.ended("program", c)) return;

  const AlikeInputs alike = alike_inputs(c.model, c.topology, c.whole);
  for (const WholePass& pass : whole_passes()) {
    c.whole = pass.run(std::move(c.whole), alike);
    if (!stages.ended(pass.name, c)) return;
  }

  c.emitted = written(c.whole);
  for (const WrittenPass& pass : written_passes()) {
    c.emitted = verified(pass.run(std::move(c.emitted)));
    if (!stages.ended(pass.name, c)) return;
  }
}

Programs counted_programs(const Compilation& c) { return with_derived_constants(c.whole.programs); }

Result<Compilation> compile(Model model, const CompileOptions& options) {
  bool goes_on = true;
  const StageWatch watch = [&](const Stage& stage) { return goes_on = !options.watch || options.watch(stage); };
  Result<Compilation> compilation = decide(std::move(model), watch);
  if (!compilation || !goes_on) return compilation;
  if (Diagnostics problems = too_large(*compilation, options.form); !problems.empty()) return problems;
  add_programs(*compilation, options);
  return compilation;
}

Result<Compilation> compile(const std::string& path, const CompileOptions& options) {
  Result<Model> model = read_model_file(path);
  if (!model) return model.problems();
  return compile(std::move(*model), options);
}

std::vector<EmittedFile> emit(const Compilation& c, const EmitOptions& options) {
  EmitOptions chosen = options;
  chosen.spelling = c.spelling;
  return emit(c.emitted, c.model, c.topology, c.analysis, chosen);
}

namespace {

/// A model without its default values.
Model without_defaults(Model model) {
  model.hash.clear();
  for (Parameter& parameter : model.parameters)
    if (parameter.tunable) parameter.value = 0;
  for (Input& input : model.inputs) input.default_value = 0;
  return model;
}

}  // namespace

std::vector<EmittedFile> emit_for_loading(const Compilation& c, const LoadedForm& form) {
  const Model model = without_defaults(c.model);
  EmitOptions options{.lanes = form.lanes, .spelling = c.spelling, .sources_alone = true};
  if (form.regular_only) options.regular_only_from = kLeftOutValues;
  std::vector<EmittedFile> files = emit(c.emitted, model, c.topology, c.analysis, options);
  files.push_back(form.clocked ? emit_clocked_driver(c.emitted, model, c.topology, c.analysis, form.lanes)
                               : emit_driver(model, form.lanes, has_inverse_dynamics(model, c.topology, c.analysis)));
  return files;
}

std::vector<EmittedFile> emit_tangents_for_loading(const Compilation& c) {
  return emit_tangents(c.emitted, without_defaults(c.model), c.topology, c.analysis);
}

namespace {

/// The whole programs without spellings for a text.
WholePrograms whole_programs(const Model& model, const Topology& topology, const Analysis& analysis, Form form) {
  WholePrograms whole = traced_programs(model, topology, analysis, form);
  whole.around_laws.reset();
  return optimise(std::move(whole));
}

/// The whole programs. Requires: they were not left out for a text alone.
const Programs& whole_programs(const Compilation& c) {
  if (c.whole.around_laws && c.whole.programs.accelerations.outputs.empty())
    throw std::logic_error("no whole programs: made for a text alone");
  return c.whole.programs;
}

/// The whole programs as they are differentiated: a bristle whose limit is 0 is no spring there.
Programs programs_for_slopes(const Compilation& c) {
  Model model = c.model;
  bool has_bristle = false;
  const auto mark = [&](auto& frictions) {
    for (FrictionLaw& friction : frictions) {
      friction.is_for_slopes = true;
      has_bristle = has_bristle || friction.has_bristle();
    }
  };
  mark(model.frictions);
  mark(model.spring_frictions);
  return has_bristle ? whole_programs(model, c.topology, c.analysis, c.form()).programs : whole_programs(c);
}

/// The same model by other decisions, and its whole programs alone.
Compilation with_analysis(const Compilation& c, Analysis analysis) {
  Compilation anew{c.model, c.topology, std::move(analysis)};
  anew.whole = whole_programs(anew.model, anew.topology, anew.analysis, c.form());
  return anew;
}

}  // namespace

FmuFiles emit_fmu(const Compilation& c, const InitialState& initial, FmiVersion version) {
  return emit_fmu(programs_for_slopes(c), c.emitted, c.model, c.topology, c.analysis, initial, version);
}

std::vector<EmittedFile> emit_casadi(const Compilation& c, const InitialState& initial) {
  return emit_casadi(whole_programs(c), programs_for_slopes(c), c.emitted, c.model, c.topology, c.analysis, initial);
}

std::vector<EmittedFile> emit_adjoint(const Compilation& c, const EmitOptions& options) {
  return emit_adjoint(c.emitted, c.model, c.topology, c.analysis, options);
}

std::optional<Compilation> chosen_at(const Compilation& c, const std::vector<double>& z) {
  std::optional<Analysis> analysis = chosen_at(c.model, c.topology, c.analysis, z);
  if (!analysis) return {};
  Compilation anew = with_analysis(c, std::move(*analysis));
  if (c.directional) add_directional(anew);
  return anew;
}

void add_directional(Compilation& c) {
  c.directional = std::make_shared<const DirectionalPrograms>(
      directional_programs(c.model, c.topology, c.analysis, whole_programs(c)));
}

std::optional<Compilation> with_states(const Compilation& c, const std::vector<double>& z,
                                       const std::vector<int>& coordinates) {
  std::optional<Analysis> analysis = with_independent(c.model, c.topology, c.analysis, z, coordinates);
  if (!analysis) return {};
  Compilation anew = with_analysis(c, std::move(*analysis));
  anew.emitted = c.emitted;
  return anew;
}

Result<LinearSystem> linearise(const Compilation& c, const OperatingPoint& point) {
  if (c.directional) return linearise(c.model, c.topology, c.analysis, *c.directional, point);
  return linearise(c.model, c.topology, c.analysis,
                   directional_programs(c.model, c.topology, c.analysis, whole_programs(c)), point);
}

Result<LinearSystem> linearise_by_any_choice(const Compilation& c, const OperatingPoint& point) {
  Result<LinearSystem> system = linearise(c, point);
  if (system) return system;
  const std::optional<Compilation> anew = chosen_at(c, point.z);
  return anew ? linearise(*anew, point) : system;
}

}  // namespace mbgen
