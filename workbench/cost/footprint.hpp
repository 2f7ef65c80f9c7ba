#pragma once
// Bytes of a compiled solver: code, data, and the stack that its functions need.

#include <string>
#include <vector>

#include "compiler/emit/emit.hpp"
#include "workbench/engines/host_compiler.hpp"

namespace mbgen {

/// Stack of one function of the solver.
struct StackUse {
  std::string function;           ///< "four_bar::step_rk4"
  long bytes = 0;                 ///< of its frame and the frames of the functions that it calls
  std::vector<std::string> path;  ///< the call path that needs most, from the function on; empty where it is not known
};

/// How StackUse::bytes was found.
enum class StackCount {
  deepest_path,   ///< largest sum of frames over all call paths: g++, by its call graph
  sum_of_frames,  ///< sum over all functions of the solver, which is no less because nothing recurses: clang++
};

/// Bytes, summed over the objects; functions and tables that several objects hold count once.
struct Footprint {
  long code = 0;           ///< machine code
  long read_only = 0;      ///< constants and tables
  long writable = 0;       ///< static data that is written to: there is none
  long unwind_tables = 0;  ///< tables with which debuggers and exceptions of others walk the stack
  StackCount stack_count = StackCount::deepest_path;
  std::vector<StackUse> stack;       ///< the deepest first
  std::vector<std::string> outside;  ///< functions outside the solver that it calls: their frames come on top
};

/// Compiles the solver's sources in `scratch` as the emitted CMake file does, and counts.
/// Requires: `files` with the runtime's headers. Fails: as run_all.
Footprint measure_footprint(const std::vector<EmittedFile>& files, const std::string& solver,
                            const HostCompiler& compiler, const std::filesystem::path& scratch);

}  // namespace mbgen
