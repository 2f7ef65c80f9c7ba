#pragma once
// The door of the emit room: Programs -> C++ text. The same input gives the same bytes on any machine.

#include <string>
#include <vector>

#include "compiler/analysis/analysis.hpp"
#include "compiler/model/model.hpp"
#include "compiler/passes/roll.hpp"
#include "compiler/topology/topology.hpp"
#include "compiler/trace/trace.hpp"

namespace mbgen {

/// Version of mbgen in banners and manifests, equal to the project version of CMakeLists.txt.
constexpr const char* kMbgenVersion = "0.1.0";

/// A file to write, path relative to the output directory.
struct EmittedFile {
  std::string path;
  std::string text;
};

struct EmitOptions {
  bool runtime_headers = true;  ///< add the runtime's headers under mbgen/, so that the directory stands alone
  std::size_t roll_above = kRollAbove;  ///< operations of a program above which equal subsystems become loops
};

/// The specialised solver: <model>.hpp, <model>.cpp, <model>.json (manifest), CMakeLists.txt, and the runtime headers.
/// Requires: `programs` traced from the same model, topology and analysis.
std::vector<EmittedFile> emit(const Programs& programs, const Model& model, const Topology& topology,
                              const Analysis& analysis, const EmitOptions& options = {});

/// `<model>_driver.cpp`: the table of mbgen/driver.hpp over plain arrays, for whoever loads the compiled solver.
EmittedFile emit_driver(const Model& model);

/// The same with step_ticks: it holds the program of accelerations once more, cut at its steps.
/// Requires: as emit.
EmittedFile emit_clocked_driver(const Programs& programs, const Model& model, const Topology& topology,
                                const Analysis& analysis);

/// The compilers that emitted code is tuned for.
enum class CompilerFamily { gnu, clang };

/// Flags that make emitted code fast and keep its object free of symbols other than libm's; the one place they are
/// listed. Without the processor flag (-march) and without warnings. Source: design.md section 7.
std::vector<std::string> solver_compile_flags(CompilerFamily family);

/// Name of the emitted files and of the namespace: the identifier of the model's name.
std::string solver_name(const Model& model);

/// C++ identifier for a model name: unique within `taken`, no keyword, ASCII. Adds the result to `taken`.
std::string identifier(const std::string& name, std::vector<std::string>& taken);

}  // namespace mbgen
