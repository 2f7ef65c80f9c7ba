#pragma once
// Other programs, started without a shell.

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
  std::filesystem::path result = {};  ///< file that it makes; empty for none
};

/// Exit code of a program that was not started.
constexpr int kNotStarted = 127;

/// A signal that ends this process came while it waited for programs. It passes through every function, so that they
/// tidy up; main then ends by the signal.
struct Interrupted {
  int signal = 0;
};

/// Runs programs, in order, as many at a time as there are processors, and waits for the last. None is started after a
/// failure. watch: called every few hundredths of a second with the number of programs that have ended. Result: exit
/// codes, in order; 128 + signal for a killed program. The first code that is not 0 belongs to a program that failed.
/// Fails: Interrupted, once the programs have been ended.
std::vector<int> run_side_by_side(const std::vector<Command>& commands,
                                  const std::function<void(std::size_t ended)>& watch = {});

/// The words of a command line, split at blanks.
std::vector<std::string> split_words(const std::string& line);

}  // namespace mbgen
