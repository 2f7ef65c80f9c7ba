// mbgen generate: the specialised solver, as files.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <filesystem>
#include <future>
#include <iterator>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "compiler/analysis/held_start.hpp"
#include "compiler/compile.hpp"
#include "compiler/model/tyres.hpp"
#include "compiler/text/json_text.hpp"
#include "compiler/text/user_error.hpp"
#include "workbench/cli/commands.hpp"
#include "workbench/cli/compiled.hpp"
#include "workbench/cli/options.hpp"
#include "workbench/cost/measured_cost.hpp"
#include "workbench/describe/dump.hpp"
#include "workbench/engines/engine_arguments.hpp"
#include "workbench/host/assignments.hpp"
#include "workbench/host/depfile.hpp"
#include "workbench/host/files.hpp"
#include "workbench/start/initial_state.hpp"

namespace mbgen::cli {
namespace {

struct GenerateOptions {
  std::string model, form, directory, name, depfile, dump;
  std::vector<std::string> set, sensitivities, states;
  EmitOptions emit;
  bool c_interface = false, casadi = false, adjoint = false, reading = false, measure = false, json = false;
  std::optional<double> budget;  ///< microseconds of a step
};

/// The model, renamed if a name is given.
Model read_named(const GenerateOptions& options) {
  Model model = read_set_model(options.model, options.set, options.sensitivities, "--sensitivities");
  if (options.name.empty()) return model;
  model.name = options.name;
  if (const std::string possible = solver_name(model); possible != options.name) {
    throw UserError(
        fmt::format("--name: \"{}\" cannot name files and a C++ namespace; \"{}\" can\n", options.name, possible));
  }
  return model;
}

/// Fails: UserError for an invalid budget.
void check_budget(const GenerateOptions& options) {
  if (!options.budget) return;
  if (!options.measure) throw UserError("--budget-us: needs --measure\n");
  if (!(*options.budget > 0) || !std::isfinite(*options.budget)) {
    throw UserError(fmt::format("--budget-us: must be positive and finite, found {}\n", *options.budget));
  }
}

/// Adds the files of the measured cost; the manifest remains the last one.
void add_measured_files(const MeasuredCost& cost, const Compilation& compilation, std::vector<EmittedFile>& files) {
  files.insert(files.end() - 1, {{cost.solver + "_measured.json", json_text(measured_json(cost, compilation))},
                                 {cost.solver + "_measured.txt", measured_text(cost, compilation)}});
}

/// Writes the files and their dependency rule. Result: their paths.
std::vector<std::string> write_all(const GenerateOptions& options, const Model& model,
                                   std::vector<EmittedFile> emitted) {
  std::vector<NamedText> files;
  std::vector<std::string> paths;
  for (EmittedFile& file : emitted) {
    paths.push_back((std::filesystem::path(options.directory) / file.path).string());
    files.push_back({std::move(file.path), std::move(file.text)});
  }
  std::optional<AtomicFile> depfile = depfile_of(options.depfile, paths.back(), model.files);
  // If mbgen is killed here, the manifest is older than the model and a build tool runs it again.
  if (depfile) depfile->commit();
  write_files(options.directory, files, model.files);  // the manifest has the model's name
  return paths;
}

/// Fails: UserError for options available in double precision only.
void require_precision(const GenerateOptions& options) {
  if (options.emit.scalar == Scalar::doubles) return;
  if (options.emit.lanes > 0) {
    throw UserError("generate: --batch has lanes of doubles: leave out --batch or --scalar float\n");
  }
  if (!options.sensitivities.empty()) {
    throw UserError(
        "generate: --sensitivities has derivatives of doubles: leave out --sensitivities or --scalar float\n");
  }
  if (options.adjoint)
    throw UserError("generate: --adjoint has derivatives of doubles: leave out --adjoint or --scalar float\n");
  if (options.measure) {
    throw UserError("generate: --measure times a solver in double precision: leave out --measure or --scalar float\n");
  }
}

/// Fails: UserError for options that a reading copy does not have.
void require_fast_copy(const GenerateOptions& options) {
  if (!options.reading) return;
  if (options.emit.lanes > 0) throw UserError("generate: --reading writes no lanes: leave out --batch or --reading\n");
  if (!options.sensitivities.empty())
    throw UserError("generate: --reading writes no derivatives: leave out --sensitivities or --reading\n");
  if (options.adjoint) throw UserError("generate: --reading writes no derivatives: leave out --adjoint or --reading\n");
  if (options.casadi) throw UserError("generate: --reading writes no derivatives: leave out --casadi or --reading\n");
  if (options.measure) throw UserError("generate: --measure times the fast solver: leave out --measure or --reading\n");
}

/// Fails: UserError for a number of the model outside the range of single precision.
void require_range(const Compilation& compilation, Scalar scalar) {
  if (scalar == Scalar::doubles) return;
  if (const std::optional<double> number = beyond_single_precision(compilation.emitted, compilation.model)) {
    throw UserError(fmt::format("{}: {} is beyond single precision; use other units, or leave out --scalar float\n",
                                compilation.model.file, *number));
  }
}

/// Fails: UserError for a C interface of derivatives whose start has none, or whose steps ask a host.
void require_derivatives(const GenerateOptions& options, const Compilation& compilation) {
  const bool has_derivatives = options.adjoint || !options.sensitivities.empty();
  if (!has_derivatives || !(options.c_interface || options.emit.calibration)) return;
  if (!tyres_on_host(compilation.model).empty())
    throw UserError(
        "generate: --c-api with --sensitivities or --adjoint knows no ground of a host, whose slopes have no "
        "derivatives\n"
        "  hint: leave out --c-api: in C++ take_ground gives a step its planes\n");
  if (has_start_with_derivatives(compilation.model, compilation.topology, compilation.analysis)) return;
  throw UserError(
      "generate: --c-api with --sensitivities or --adjoint needs a start with derivatives: \"initial\" without a "
      "static "
      "equilibrium, "
      "that gives or locks as many values as the loops leave free\n"
      "  hint: leave out --c-api: in C++ assemble_holding (derivatives) and assemble_back (adjoint) "
      "start where the caller wants\n");
}

/// Fails: UserError for a model that is no explicit differential equation.
void require_explicit(const GenerateOptions& options, const Compilation& compilation) {
  if (!options.casadi && !options.states.empty()) throw UserError("--states: needs --casadi\n");
  if (!options.casadi) return;
  const std::string reason = no_explicit_motion(compilation.model, compilation.topology, compilation.analysis);
  if (reason.empty()) return;
  throw UserError(
      fmt::format("{}: --casadi: the model is no differential equation of its independent coordinates: {}\n",
                  compilation.model.file, reason));
}

/// Tree coordinates of these names. Fails: UserError for a name without a coordinate, a driven one, and one named
/// twice.
std::vector<int> state_coordinates(const std::vector<std::string>& names, const Compilation& compilation) {
  std::vector<int> coordinates;
  for (const std::string& name : names) {
    const int coordinate = find_coordinate(compilation.topology, name);
    if (coordinate < 0)
      throw UserError(fmt::format("--states: the model has no coordinate \"{}\"; mbgen inspect lists them\n", name));
    if (compilation.analysis.driven[static_cast<std::size_t>(coordinate)])
      throw UserError(fmt::format("--states: \"{}\" is driven by a motion\n", name));
    if (std::ranges::count(coordinates, coordinate) > 0)
      throw UserError(fmt::format("--states: \"{}\" is named twice\n", name));
    coordinates.push_back(coordinate);
  }
  return coordinates;
}

/// The files for CasADi, of the states that are asked for. Fails: UserError for states that determine no motion.
std::vector<EmittedFile> casadi_files(const GenerateOptions& options, const Compilation& compilation,
                                      const InitialState& initial) {
  if (!initial.charts.empty())
    throw UserError("--casadi: a ball joint starts in the pole of its angles, where these are no states\n");
  if (options.states.empty()) return emit_casadi(compilation, initial);
  const std::vector<int> coordinates = state_coordinates(options.states, compilation);
  const std::optional<Compilation> chosen = with_states(compilation, initial.z, coordinates);
  if (!chosen)
    throw UserError(fmt::format(
        "--states: {} do not determine their loops at the start of the model\n"
        "  hint: name as many coordinates of a loop as it has freedoms, none of which follows from others\n",
        fmt::join(options.states, ", ")));
  return emit_casadi(*chosen, initial);
}

/// Puts files that are not there yet before the manifest.
void insert_files(std::vector<EmittedFile> more, std::vector<EmittedFile>& files) {
  std::erase_if(more,
                [&](const EmittedFile& file) { return std::ranges::count(files, file.path, &EmittedFile::path); });
  files.insert(files.end() - 1, std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

/// The files of the solver and of what was asked for beside it; the manifest is the last one.
std::vector<EmittedFile> emitted_files(const GenerateOptions& options, const Compilation& compilation,
                                       const EmitOptions& emitted) {
  std::vector<EmittedFile> files = emit(compilation, emitted);
  if (options.adjoint) {
    std::vector<EmittedFile> backwards = emit_adjoint(compilation, emitted);
    if (emitted.runtime_headers) add_runtime_headers(backwards);
    insert_files(std::move(backwards), files);
  }
  if (options.casadi) insert_files(casadi_files(options, compilation, *emitted.initial), files);
  return files;
}

/// The start, which follows from the decisions about a model, found beside its programs; none where a solver may lack
/// it.
std::future<std::optional<InitialState>> start_beside(const Compilation& decided, bool may_lack) {
  return std::async(std::launch::async | std::launch::deferred, [decided, may_lack] {
    return may_lack ? known_start(decided) : std::optional(default_initial_state(decided));
  });
}

int run(const GenerateOptions& options) {
  if (!options.dump.empty()) {
    print(dump_stage(read_named(options), options.dump, known_start, chosen_form(options.form), options.emit));
    return kDone;
  }
  if (options.directory.empty()) throw UserError("generate: --out DIR is required\n");
  if (is_standard_output(options.directory)) {
    throw UserError(
        "--out: the solver is several files, name a directory\n"
        "  hint: --dump code prints the solver, a directory of this name is ./-\n");
  }
  require_precision(options);
  require_fast_copy(options);
  check_budget(options);
  EmitOptions emitted = options.emit;
  emitted.tangents = options.adjoint || !options.sensitivities.empty();
  emitted.adjoint = options.adjoint;
  emitted.c_interface = options.c_interface || options.emit.calibration;
  emitted.casadi = options.casadi;
  std::future<std::optional<InitialState>> start;
  const Compilation compilation =
      compiled(read_named(options), {.form = chosen_form(options.form),
                                     .spelling = options.reading ? Spelling::reading : Spelling::fast,
                                     .for_text_alone = !options.casadi,
                                     .decided = [&](const Compilation& decided) {
                                       start = start_beside(decided, !emitted.c_interface && !options.casadi);
                                     }});
  require_range(compilation, options.emit.scalar);
  require_derivatives(options, compilation);
  require_explicit(options, compilation);
  emitted.initial = start.get();
  std::vector<EmittedFile> files = emitted_files(options, compilation, emitted);
  std::optional<MeasuredCost> cost;
  if (options.measure) {
    cost = measure_cost(compilation, emitted, options.budget);
    add_measured_files(*cost, compilation, files);
  }
  const std::vector<std::string> paths = write_all(options, compilation.model, std::move(files));
  if (cost && exceeds_budget(*cost)) throw UserError(budget_text(*cost));
  if (options.json) {
    nlohmann::ordered_json report = {{"model", compilation.model.name}, {"files", paths}};
    if (cost) report["measured"] = measured_json(*cost, compilation);
    print(json_text(report));
  } else {
    for (const std::string& path : paths) print(path + "\n");
    if (cost) print(budget_text(*cost));
  }
  return kDone;
}

}  // namespace

void add_generate(NamedCommand application, int& exit_code) {
  const auto options = std::make_shared<GenerateOptions>();
  NamedCommand command = application.add_command("generate", "write the specialised C++ solver of a model");
  command.footer(
      "Example: mbgen generate models/coach.json --out coach_solver\n"
      "Prints the files that it wrote; DIR/CMakeLists.txt builds them alone.");
  add_model_argument(command, options->model);
  command.add_option("-o,--out", options->directory, "directory of the files; made when it is missing");
  command.add_flag(
      "--no-runtime", [options] { options->emit.runtime_headers = false; },
      "leave out the runtime's headers (mbgen/*.hpp)");
  command.add_flag("--c-api", options->c_interface,
                   "add an interface in C99 (<model>_c.h, <model>_c.cpp) and a Python module over it (<model>.py)");
  command.add_flag(
      "--casadi", options->casadi,
      "add the motion as functions in C that CasADi finds by name (<model>_casadi.c) and a model of acados "
      "(<model>_acados.py; docs/use/casadi.md)");
  command
      .add_option("--states", options->states,
                  "with --casadi: coordinates of loops that are states, separated by commas (default: the solver's "
                  "choice)")
      .one_value_at_a_time()
      .separated_by(',');
  command.add_flag("--a2l", options->emit.calibration,
                   "add a calibration file, ASAP2 (<model>.a2l), the header of its symbols (<model>_a2l.h), and the "
                   "files of --c-api");
  command.add_flag("--reading", options->reading,
                   "write the solver for people: the same equations step by step, every program one function, every "
                   "quantity and every constant named");
  command.add_option("--name", options->name, "name of the files and the namespace (default: the model's)");
  add_set_option(command, options->set);
  add_depfile_option(command, options->depfile);
  add_form_option(command, options->form);
  add_batch_option(command, options->emit.lanes);
  add_scalar_option(command, options->emit.scalar);
  command
      .add_option("--sensitivities", options->sensitivities,
                  "parameters, separated by commas: add the solver with derivatives (<model>_tangents.hpp, .cpp), with "
                  "these parameters tunable (docs/use/sensitivities.md)")
      .one_value_at_a_time()
      .separated_by(',');
  command.add_flag("--adjoint", options->adjoint,
                   "add the solver's steps backwards (<model>_adjoint.hpp, .cpp): derivatives of one number by all "
                   "tunable parameters and inputs, those of --sensitivities among them");
  command.add_flag("--measure", options->measure,
                   "compile the solver and time a step: adds <model>_measured.txt and .json to the cost sheet");
  command.add_option("--budget-us", options->budget,
                     "with --measure: fail when the slowest step takes longer than so many microseconds");
  add_json_option(command, options->json);
  add_dump_option(command, options->dump);
  command.callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace mbgen::cli
