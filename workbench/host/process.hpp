#pragma once
// Execution of programs without a shell.

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace mbgen {

/// A program with its arguments; its output goes to the file `log`.
struct Command {
  std::vector<std::string> arguments;
  std::filesystem::path log;
  std::filesystem::path result = {};  ///< its output file; empty for none
};

/// Exit code of a program that was not started.
constexpr int kNotStarted = 127;

/// A termination signal during the wait for programs. Thrown through all functions, so that they clean up; main then
/// ends the process by the signal, and with the exit code of Ctrl-C after SIGTERM.
struct Interrupted {
  int signal = 0;
};

/// Runs programs in order, at most one per processor at a time, and waits for all. None is started after a failure.
/// watch: called every few hundredths of a second with the number of ended programs. Result: exit codes, in order; 128
/// + signal for a killed program. The first code that is not 0 belongs to a failed program. Fails: Interrupted, after
/// the programs have been ended.
std::vector<int> run_side_by_side(const std::vector<Command>& commands,
                                  const std::function<void(std::size_t ended)>& watch = {});

/// The words of a command line, split at blanks.
std::vector<std::string> split_words(const std::string& line);

}  // namespace mbgen
