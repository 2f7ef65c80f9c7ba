#pragma once
// The C++ compiler of the machine.

#include <filesystem>
#include <string>
#include <vector>

#include "compiler/base/process.hpp"

namespace mbgen::cli {

struct HostCompiler {
  std::vector<std::string> words;  ///< of $CXX
  std::string version;             ///< its own version text
  std::vector<std::string> flags;  ///< of emitted code; without -fPIC
  bool is_clang = false;
};

/// A machine that a compiler here can compile for.
struct CrossTarget {
  std::string platform;   ///< "" for this machine
  std::string compiler;   ///< its command
  std::string variable;   ///< of the environment, for another command
  std::string package;    ///< of Debian, that has it
  std::string otherwise;  ///< a way without that compiler
};

/// The compiler for a target. scratch: a directory for its answer. Fails: UserError when it does not run.
HostCompiler find_cross_compiler(const std::filesystem::path& scratch, const CrossTarget& target);

/// $CXX, or c++. scratch: a directory for its answer; processor: a flag like "-march=native", "" for none; lanes: as
/// the solver has them. Fails: UserError when it does not run.
HostCompiler find_compiler(const std::filesystem::path& scratch, const std::string& processor, int lanes);

/// A compilation without its output: the compiler, its flags, `-I` of each directory.
std::vector<std::string> compilation_of(const HostCompiler& compiler,
                                        const std::vector<std::filesystem::path>& directories);

/// Runs compilations side by side. Fails: std::runtime_error with the end of the messages of the first that fails.
void run_all(const std::vector<Command>& commands);

}  // namespace mbgen::cli
