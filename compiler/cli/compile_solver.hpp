#pragma once
// From emitted code to a loaded solver, by the C++ compiler of the machine.

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "compiler/cli/engine.hpp"
#include "compiler/cli/process.hpp"
#include "compiler/compile.hpp"
#include "mbgen/driver.hpp"

namespace mbgen::cli {

/// The C++ compiler of the machine.
struct Compiler {
  std::vector<std::string> words;  ///< of $CXX
  std::string version;             ///< what it says of itself
  std::vector<std::string> flags;  ///< for this processor; without -fPIC
  bool is_clang = false;
};

/// $CXX, or c++. scratch: where its answers go; lanes: as the solver has them.
/// Fails: UserError when there is none.
Compiler find_compiler(const std::filesystem::path& scratch, int lanes);

/// A compilation without its output: the compiler, its flags, `-I scratch`.
std::vector<std::string> compilation_of(const Compiler& compiler, const std::filesystem::path& scratch);

/// Runs compilations side by side. Fails: std::runtime_error with the end of the messages of one that failed.
void run_all(const std::vector<Command>& commands);

/// Emits the solver and its driver, compiles them with $CXX (or c++) for this processor and loads the result.
/// choice: its use, its lanes, and use_cache: look for the object under ${XDG_CACHE_HOME:-~/.cache}/mbgen first, and
/// keep it there. Its name is a hash of the code, the compiler's version, the flags and the processor; any number of
/// mbgen may run at the same time.
/// Fails: UserError when there is no compiler (the text names --engine generic), std::runtime_error with the end of the
/// compiler's messages when it rejects the code.
std::shared_ptr<const SolverTable> load_solver(const Compilation& compilation, const EngineChoice& choice);

}  // namespace mbgen::cli
