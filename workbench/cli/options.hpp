#pragma once
// Arguments shared by several commands.

#include <string>
#include <vector>

#include "compiler/emit/scalar.hpp"
#include "workbench/cli/command_line.hpp"

namespace mbgen {
struct EngineArguments;
struct SimulationArguments;
struct StateArguments;
}  // namespace mbgen

namespace mbgen::cli {

/// MODEL, the first argument of most commands.
void add_model_argument(NamedCommand command, std::string& path);

/// --jobs and --restart of a search with a journal. jobs: 0 for one a processor.
void add_journal_options(NamedCommand command, int& jobs, bool& restart);

/// --json
void add_json_option(NamedCommand command, bool& json);

/// --form recursive|matrix
void add_form_option(NamedCommand command, std::string& form);

/// --dump=STAGE
void add_dump_option(NamedCommand command, std::string& stage);

/// --depfile FILE
void add_depfile_option(NamedCommand command, std::string& path);

/// --batch: 4 or 8 instances per call, 0 if not given.
void add_batch_option(NamedCommand command, int& lanes);

/// --scalar double|float
void add_scalar_option(NamedCommand command, Scalar& scalar);

/// --input
void add_input_option(NamedCommand command, std::vector<std::string>& inputs);

/// --input, --no-cache
void add_run_options(NamedCommand command, EngineArguments& arguments);

/// --engine, --linear-algebra, --factorisation, --stabilisation and the run options
void add_engine_options(NamedCommand command, EngineArguments& arguments);

/// --set
Option add_set_option(NamedCommand command, std::vector<std::string>& assignments);

/// --duration, --step, --integrator, --input-table, --interpolation
void add_simulation_options(NamedCommand command, SimulationArguments& arguments);

/// --at, --hold, --solve, --states, --index, --result, --row, --time, --input
void add_state_options(NamedCommand command, StateArguments& arguments);

}  // namespace mbgen::cli
