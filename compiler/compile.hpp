#pragma once
// The whole pipeline as a page one reads aloud.

#include <optional>
#include <string>
#include <vector>

#include "compiler/analysis/analysis.hpp"
#include "compiler/emit/emit.hpp"
#include "compiler/emit/fmu.hpp"
#include "compiler/linearisation/linearisation.hpp"
#include "compiler/model/model.hpp"
#include "compiler/topology/topology.hpp"
#include "compiler/trace/trace.hpp"

namespace mbgen {

/// Everything that is known of a model before a line of code is emitted.
struct Compilation {
  Model model;
  Topology topology;
  Analysis analysis;
  Programs programs;
};

/// Every program after the passes.
Programs optimise(Programs programs);

/// Keeps one form of the accelerations: that asked for, else the one with fewer operations, the matrix form of equals.
/// Requires: both forms, after the passes.
void take_form(Programs& programs, std::optional<Form> form);

/// Takes what depends on tunable parameters alone out of every program: it is computed where they change.
/// Requires: one form, after the passes.
void take_out_derived_constants(Programs& programs);

/// Counts what treatments and passes save: traces the accelerations again without each. For `inspect`; nothing where
/// only one form was traced.
void count_savings(Compilation& compilation);

/// Reads, where it is a file, and analyses a model: no programs. All that is needed to check it, and by engines other
/// than the generated one. Fails: as the first stage that fails.
Result<Compilation> decide(Model model);
Result<Compilation> decide(const std::string& path);

/// Operations of a program up to which a solver is written: millions take gigabytes here and hours in a C++ compiler.
constexpr double kMostOperations = 2097152;

/// Parts of a model with a title of their own (bodies, joints, loops, blocks, force elements, outputs) up to which a
/// solver is written: programs number them with 16 bits, and have some more.
constexpr std::size_t kMostTitles = 65000;

/// One diagnostic with the size when the solver of a decided model is too large to be written.
Diagnostics too_large(const Compilation& decided, std::optional<Form> form = {});

/// Traces the programs of a decided model that is not too large. form: of the accelerations, none for the cheaper one.
void add_programs(Compilation& decided, std::optional<Form> form = {});

/// Analyses and traces a model. form: of the accelerations, none for the cheaper one. Fails: as the first stage that
/// fails, too_large.
Result<Compilation> compile(Model model, std::optional<Form> form = {});

/// Reads and compiles the model of a file. Fails: as the first stage that fails.
Result<Compilation> compile(const std::string& path, std::optional<Form> form = {});

/// Every program as it is emitted: contracted, so that every compiler rounds alike, and the recursive form in an order
/// for few registers.
Programs as_emitted(Programs programs);

/// The files of the specialised solver, see emit.
std::vector<EmittedFile> emit(const Compilation& compilation, const EmitOptions& options = {});

/// Every program after the passes with the constants that follow from tunable parameters still in it: derivatives go
/// through them.
Programs whole_programs(const Compilation& compilation);

/// Linearises the model, see linearisation.hpp.
Result<LinearSystem> linearise(const Compilation& compilation, const OperatingPoint& point);

/// The files of an FMU that starts from `initial`, see emit_fmu.
FmuFiles emit_fmu(const Compilation& compilation, const InitialState& initial, FmiVersion version);

/// The driver that times the nine steps, see emit_clocked_driver.
EmittedFile emit_clocked_driver(const Compilation& compilation, int lanes = 0);

}  // namespace mbgen
