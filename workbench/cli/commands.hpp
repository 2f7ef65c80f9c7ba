#pragma once
// The commands of mbgen, one file each.

#include "workbench/cli/command_line.hpp"

namespace mbgen::cli {

/// Exit codes, the same for every command.
enum ExitCode : int { kDone = 0, kUserFault = 1, kOurDefect = 2, kInterrupted = 130 };

// Each function adds its command to the application; the command sets the exit code when it is run. Fails: UserError.
void add_check(NamedCommand application, int& exit_code);
void add_explain(NamedCommand application, int& exit_code);
void add_new(NamedCommand application, int& exit_code);
void add_inspect(NamedCommand application, int& exit_code);
void add_generate(NamedCommand application, int& exit_code);
void add_export(NamedCommand application, int& exit_code);
void add_simulate(NamedCommand application, int& exit_code);
void add_evaluate(NamedCommand application, int& exit_code);
void add_plot(NamedCommand application, int& exit_code);
void add_report(NamedCommand application, int& exit_code);
void add_equilibrium(NamedCommand application, int& exit_code);
void add_linearize(NamedCommand application, int& exit_code);
void add_kc(NamedCommand application, int& exit_code);
void add_sweep(NamedCommand application, int& exit_code);
void add_fit(NamedCommand application, int& exit_code);
void add_optimise(NamedCommand application, int& exit_code);
void add_bench(NamedCommand application, int& exit_code);
void add_cache(NamedCommand application, int& exit_code);
void add_import(NamedCommand application, int& exit_code);
void add_schema(NamedCommand application, int& exit_code);
void add_completion(NamedCommand application, int& exit_code);
void add_manual(NamedCommand application, int& exit_code);

}  // namespace mbgen::cli
