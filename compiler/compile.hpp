#pragma once
// The whole pipeline as a page one reads aloud.

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/adjoint/adjoint.hpp"
#include "compiler/analysis/analysis.hpp"
#include "compiler/casadi/casadi.hpp"
#include "compiler/emit/emit.hpp"
#include "compiler/fmu/fmu.hpp"
#include "compiler/linearisation/linearisation.hpp"
#include "compiler/model/model.hpp"
#include "compiler/solver/programs.hpp"
#include "compiler/topology/topology.hpp"

namespace mbgen {

/// Everything that is known of a model before a line of code is emitted.
struct Compilation {
  Model model;
  Topology topology = {};
  Analysis analysis = {};
  WholePrograms whole = {};      ///< after the passes: derivatives are taken of them
  WrittenPrograms emitted = {};  ///< contracted, unless for reading
  Spelling spelling = Spelling::fast;
  std::shared_ptr<const DirectionalPrograms> directional = {};  ///< of `whole`, after add_directional

  Form form() const { return whole.programs.form; }
  /// Whether add_programs has run to its end.
  bool has_programs() const { return !emitted.programs.accelerations.outputs.empty(); }
};

/// A stage that has just ended.
struct Stage {
  std::string_view name;      ///< of stage_names
  const Compilation& so_far;  ///< programs as this stage left them: whole ones, and emitted ones once there are some
  double milliseconds = 0;    ///< of this stage alone
};

/// Looks at a stage. Result: false to stop there.
using StageWatch = std::function<bool(const Stage&)>;

/// Names of the stages in order: model, topology, analysis, program, every pass (see passes/passes.hpp).
std::vector<std::string> stage_names();

struct CompileOptions {
  std::optional<Form> form = {};       ///< of the accelerations, none for form_of
  StageWatch watch = {};               ///< called after each stage
  Spelling spelling = Spelling::fast;  ///< for reading: no whole programs, and stages end with "program"
  bool for_text_alone = false;  ///< without whole accelerations where the text has others: no derivatives are taken
  std::function<void(const Compilation& decided)> decided = {};  ///< called before the first program of a model is made
};

/// Analyses a model: no programs. All that is needed to check it, and by engines other than the generated one.
/// Fails: as the first stage that fails.
Result<Compilation> decide(Model model, const StageWatch& watch = {});
Result<Compilation> decide(const std::string& path);

/// Operations of a program up to which a solver is written: millions take gigabytes here and hours in a C++ compiler.
constexpr double kMostOperations = 2097152;

/// One diagnostic with the size when the solver of a decided model is too large to be written.
Diagnostics too_large(const Compilation& decided, std::optional<Form> form = {});

/// Decides a model whose solver is to be written. Fails: as decide, too_large.
Result<Compilation> decide_to_write(Model model, std::optional<Form> form = {});

/// The form in which the solver of a decided model is written. asked: by the user, none for the shorter one.
Form written_form(const Compilation& decided, std::optional<Form> asked);

/// Chooses the partitions of the recursive form by counting (counted_partitions.hpp), which engines that trace nothing
/// do without; then traces and lowers the programs of a decided model that is not too large.
void add_programs(Compilation& decided, const CompileOptions& options = {});

/// The programs by which operations are counted: without laws apart and without pairs, and without values of tunable
/// parameters alone.
Programs counted_programs(const Compilation& compilation);

/// All stages. Fails: as the first stage that fails, too_large.
Result<Compilation> compile(Model model, const CompileOptions& options = {});

/// Reads and compiles the model of a file. Fails: as the first stage that fails.
Result<Compilation> compile(const std::string& path, const CompileOptions& options = {});

/// The files of the specialised solver, see emit.
std::vector<EmittedFile> emit(const Compilation& compilation, const EmitOptions& options = {});

/// A solver that mbgen loads.
struct LoadedForm {
  bool clocked = false;  ///< the driver times the nine steps
  int lanes = 0;
  bool regular_only = false;  ///< of regular positions alone, where kLeftOutValues are left out
};

/// The sources of a solver that mbgen loads, with its driver last. mbgen gives parameters, inputs and states itself:
/// files of models with equal equations differ in comments at most.
std::vector<EmittedFile> emit_for_loading(const Compilation& compilation, const LoadedForm& form = {});

/// The same of the solver with derivatives, see emit_tangents.
std::vector<EmittedFile> emit_tangents_for_loading(const Compilation& compilation);

/// The model with partitions of its loop blocks chosen for one position (analysis/choice_at.hpp) and its `whole`
/// programs alone; none where no other choice helps. z: of every coordinate, loops closed.
std::optional<Compilation> chosen_at(const Compilation& compilation, const std::vector<double>& z);

/// Keeps the derivatives of the whole programs: for models that are linearised at many points.
void add_directional(Compilation& compilation);

/// The model with these tree coordinates among the independent ones of their loops, see with_independent of
/// analysis/choice_at.hpp, and its `whole` programs for them; `emitted` ones stay. z: of every coordinate, loops
/// closed. Result: none where they do not determine their loops there.
std::optional<Compilation> with_states(const Compilation& compilation, const std::vector<double>& z,
                                       const std::vector<int>& coordinates);

/// Linearises the model, see linearisation.hpp.
Result<LinearSystem> linearise(const Compilation& compilation, const OperatingPoint& point);

/// The same with partitions chosen for the point where the frozen ones are singular and the position is not: other
/// coordinates may be states then.
Result<LinearSystem> linearise_by_any_choice(const Compilation& compilation, const OperatingPoint& point);

/// The files for CasADi and acados, see emit_casadi. Requires: no_explicit_motion of the model is empty.
std::vector<EmittedFile> emit_casadi(const Compilation& compilation, const InitialState& initial);

/// The solver's steps backwards, see emit_adjoint. Requires: options.tangents.
std::vector<EmittedFile> emit_adjoint(const Compilation& compilation, const EmitOptions& options);

/// The files of an FMU that starts from `initial`, see emit_fmu.
FmuFiles emit_fmu(const Compilation& compilation, const InitialState& initial, FmiVersion version);

}  // namespace mbgen
