#pragma once
// The commands of mbgen, one file each.

#include <CLI/CLI.hpp>

namespace mbgen::cli {

/// Exit codes, the same for every command.
enum ExitCode : int { kDone = 0, kUserFault = 1, kOurDefect = 2 };

// Each adds its command to the application; when the command line names it, it runs and sets the exit code.
// Fails: UserError.
void add_check(CLI::App& application, int& exit_code);
void add_explain(CLI::App& application, int& exit_code);
void add_new(CLI::App& application, int& exit_code);
void add_inspect(CLI::App& application, int& exit_code);
void add_generate(CLI::App& application, int& exit_code);
void add_export(CLI::App& application, int& exit_code);
void add_simulate(CLI::App& application, int& exit_code);
void add_evaluate(CLI::App& application, int& exit_code);
void add_plot(CLI::App& application, int& exit_code);
void add_report(CLI::App& application, int& exit_code);
void add_equilibrium(CLI::App& application, int& exit_code);
void add_linearize(CLI::App& application, int& exit_code);
void add_sweep(CLI::App& application, int& exit_code);
void add_bench(CLI::App& application, int& exit_code);
void add_import(CLI::App& application, int& exit_code);
void add_schema(CLI::App& application, int& exit_code);
void add_completion(CLI::App& application, int& exit_code);
void add_manual(CLI::App& application, int& exit_code);

}  // namespace mbgen::cli
