#pragma once
// The door of the emit room: Programs -> C++ text. The same input gives the same bytes on any machine.

#include <optional>
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

/// Values that make a part of a file worth a compilation of its own: that reads the headers once more, which takes as
/// long as some thousand values.
constexpr std::size_t kFilePartValues = 4000;

/// A file to write, path relative to the output directory.
struct EmittedFile {
  std::string path;
  std::string text;
  /// Of a source: compilations with MBGEN_PART = 0, 1, ..., rare_parts give together what one without it gives. What
  /// the parts from 1 on hold runs rarely.
  int rare_parts = 0;
};

/// A parameter that acts at the start, and the change of the velocities there by its change of 1.
struct StartParameter {
  int parameter = -1;  ///< index into Model::parameters
  std::vector<double> zd;
};

/// Where solvers start: loops closed, velocities consistent.
struct InitialState {
  std::vector<double> z, zd, x;
  std::vector<StartParameter> parameters = {};
};

struct EmitOptions {
  bool runtime_headers = true;          ///< add the runtime's headers under mbgen/, so that the directory stands alone
  std::size_t roll_above = kRollAbove;  ///< operations of a program above which equal subsystems become loops
  std::size_t file_part_values = kFilePartValues;  ///< least number of values in a part of the file that runs rarely
  int lanes = 0;                  ///< instances that a call of the batch interface solves, 0 for no such interface
  std::string scalar = "double";  ///< of the solver: double, or float without the two interfaces
  std::optional<InitialState> initial = {};  ///< add initial_state() to the interfaces
  bool c_interface = false;                  ///< add <model>_c.h, <model>_c.cpp and <model>.py; needs `initial`
  bool calibration = false;                  ///< and <model>.a2l with <model>_a2l.h, which stand on them
};

/// The specialised solver: <model>.hpp, <model>.cpp, <model>_cost.txt (cost sheet), CMakeLists.txt, with lanes also
/// <model>_batch.hpp and <model>_batch.cpp, the runtime headers, and last <model>.json (manifest): where it is, all
/// are. Requires: `programs` traced from the same model, topology and analysis, and contracted: compilers do not
/// contract.
std::vector<EmittedFile> emit(const Programs& programs, const Model& model, const Topology& topology,
                              const Analysis& analysis, const EmitOptions& options = {});

/// A number of the programs or a default of the model that is finite and no float is, none when all are.
std::optional<double> beyond_single_precision(const Programs& programs, const Model& model);

/// `<model>_driver.cpp`: the table of mbgen/driver.hpp over plain arrays, for whoever loads the compiled solver.
/// lanes: as the solver has them.
EmittedFile emit_driver(const Model& model, int lanes = 0);

/// The same with step_ticks: it holds the program of accelerations once more, cut at its steps.
/// Requires: as emit.
EmittedFile emit_clocked_driver(const Programs& programs, const Model& model, const Topology& topology,
                                const Analysis& analysis, int lanes = 0);

/// Adds the runtime's headers that the files include, under mbgen/.
void add_runtime_headers(std::vector<EmittedFile>& files);

/// The compilers that emitted code is tuned for.
enum class CompilerFamily { gnu, clang };

/// Flags that make emitted code fast and keep its object free of symbols other than libm's: those of templates/*.flags,
/// which the CMake package reads too. Without the processor flag (-march) and without warnings. Contraction is the
/// program's own: docs/evidence/determinism.md. Other flags were measured:
/// docs/evidence/performance.md, "What was tried and left out".
std::vector<std::string> solver_compile_flags(CompilerFamily family);

/// Further flags for a solver that runs soon and not for long: a shorter compilation, the same bits.
std::vector<std::string> quick_compile_flags(CompilerFamily family);

/// Further flags for code that runs rarely: its compilation is to be short. The bits of results stay.
std::vector<std::string> rare_compile_flags(CompilerFamily family);

/// Further flags of g++ for solvers with lanes on x86-64, and only there.
std::vector<std::string> lane_flags_of_gnu_on_x86();

/// Name of the emitted files and of the namespace: the identifier of the model's name.
std::string solver_name(const Model& model);

/// C++ identifier for a model name: unique within `taken`, no keyword, ASCII. Adds the result to `taken`.
std::string identifier(const std::string& name, std::vector<std::string>& taken);

}  // namespace mbgen
