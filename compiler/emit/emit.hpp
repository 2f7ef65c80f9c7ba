#pragma once
// The door of the emit room: WrittenPrograms -> C++ text. The same input gives the same bytes on any machine.

#include <optional>
#include <string>
#include <vector>

#include "compiler/analysis/analysis.hpp"
#include "compiler/emit/files.hpp"
#include "compiler/emit/names.hpp"
#include "compiler/model/model.hpp"
#include "compiler/solver/programs.hpp"
#include "compiler/topology/topology.hpp"

namespace mbgen {

/// The specialised solver: <model>.hpp, <model>.cpp, <model>_cost.txt (cost sheet), CMakeLists.txt, with lanes also
/// <model>_batch.hpp and <model>_batch.cpp, the runtime headers, and last <model>.json (manifest), which marks
/// completion. Requires: `programs` traced from the same model, topology and analysis, and contracted, since compilers
/// do not contract.
std::vector<EmittedFile> emit(const WrittenPrograms& programs, const Model& model, const Topology& topology,
                              const Analysis& analysis, const EmitOptions& options = {});

/// `<model>_driver.cpp`: the table of mbgen/driver.hpp over plain arrays, for programs that load the compiled solver.
/// lanes: of the solver. inverse: whether it has inverse dynamics.
EmittedFile emit_driver(const Model& model, int lanes = 0, bool inverse = false);

/// The same with step_ticks: it holds the program of accelerations a second time, divided at its steps. Requires: as
/// emit.
EmittedFile emit_clocked_driver(const WrittenPrograms& programs, const Model& model, const Topology& topology,
                                const Analysis& analysis, int lanes = 0);

/// The driver of the solver with derivatives; its table has numbers with derivatives in place of doubles.
EmittedFile emit_tangent_driver(const Model& model, bool inverse = false);

/// The solver with derivatives alone, its driver and the runtime's headers, for programs that load it. Requires: as
/// emit.
std::vector<EmittedFile> emit_tangents(const WrittenPrograms& programs, const Model& model, const Topology& topology,
                                       const Analysis& analysis);

/// The first number, of the programs or a default of the model, that single precision cannot hold, if any.
std::optional<double> beyond_single_precision(const WrittenPrograms& programs, const Model& model);

/// Adds the runtime's headers that the files include, under mbgen/.
void add_runtime_headers(std::vector<EmittedFile>& files);

/// Compilers with tuned flags for emitted code.
enum class CompilerFamily { gnu, clang };

/// Flags that make emitted code fast and keep its object free of symbols other than those of libm: templates/*.flags,
/// which the CMake package reads too. They contain neither the processor flag (-march) nor warnings. The program itself
/// decides on contraction: docs/evidence/determinism.md. Other flags were measured: docs/evidence/performance.md, "What
/// was tried and left out".
std::vector<std::string> solver_compile_flags(CompilerFamily family);

/// Further flags for a solver that is compiled fast and runs briefly: the same bits.
std::vector<std::string> quick_compile_flags(CompilerFamily family);

/// Further flags for rarely used code: a short compilation with the same bits.
std::vector<std::string> rare_compile_flags(CompilerFamily family);

/// Further flags of g++ for solvers with lanes on x86-64, and only there.
std::vector<std::string> lane_flags_of_gnu_on_x86();

}  // namespace mbgen
