#pragma once
// Other programs, started without a shell.

#include <filesystem>
#include <string>
#include <vector>

namespace mbgen::cli {

/// A program with its arguments; its output goes to the file `log`.
struct Command {
  std::vector<std::string> arguments;
  std::filesystem::path log;
};

/// Exit code of a program that could not be started.
constexpr int kNotStarted = 127;

/// Runs all of them at the same time and waits for the last. Result: exit codes, in order; 128 + signal for a killed
/// one.
std::vector<int> run_side_by_side(const std::vector<Command>& commands);

/// The words of a command line, split at blanks.
std::vector<std::string> split_words(const std::string& line);

}  // namespace mbgen::cli
