#pragma once
// Files that are written, choices for them, and the solver's knowledge of its start.

#include <optional>
#include <string>
#include <vector>

#include "compiler/emit/scalar.hpp"
#include "compiler/schedule/roll.hpp"

namespace mbgen {

/// Version of mbgen in banners and manifests, equal to the project version of CMakeLists.txt.
constexpr const char* kMbgenVersion = "0.1.0";

/// Least number of values for which a part of a file gets its own compilation: this reads the headers once more, which
/// takes as long as some thousand values.
constexpr std::size_t kFilePartValues = 4000;

/// Values of the program for other partitions and charts from which a solver for regular positions alone is worth it.
constexpr std::size_t kLeftOutValues = 1000;

/// Derivatives that a number with tangents has: a vector of the widest processors.
constexpr int kDirections = 8;

/// Suffix of the name of a solver with derivatives.
constexpr const char* kTangentSuffix = "_tangents";

/// A file to write, path relative to the output directory.
struct EmittedFile {
  std::string path;
  std::string text;
  /// For a source: compilations with MBGEN_PART = 0, 1, ..., rare_parts together give the code of one without it. Code
  /// of the parts from 1 on runs rarely.
  int rare_parts = 0;
};

/// A parameter that affects the start, and the derivative of the initial velocities with respect to it.
struct StartParameter {
  int parameter = -1;  ///< index into Model::parameters
  std::vector<double> zd;
};

/// Initial state of solvers: loops closed, velocities consistent.
struct InitialState {
  std::vector<double> z, zd, x;
  std::vector<StartParameter> parameters = {};
  std::vector<double> charts = {};  ///< per ball of the topology; empty: all 0
};

struct EmitOptions {
  bool runtime_headers = true;          ///< add the runtime's headers under mbgen/, so that the directory stands alone
  std::size_t roll_above = kRollAbove;  ///< operations of a program above which equal subsystems become loops
  std::size_t file_part_values = kFilePartValues;  ///< least number of values in a part of the file that runs rarely
  int lanes = 0;                    ///< instances that a call of the batch interface solves, 0 for no such interface
  Scalar scalar = Scalar::doubles;  ///< of the solver: doubles, or floats without the two interfaces
  std::optional<InitialState> initial = {};  ///< add initial_state() to the interfaces
  bool tangents = false;                     ///< add <model>_tangents.hpp and .cpp, the solver with derivatives
  bool adjoint = false;                      ///< CMakeLists.txt builds <model>_adjoint.cpp; needs `tangents`
  bool c_interface = false;                  ///< add <model>_c.h, <model>_c.cpp and <model>.py; needs `initial`
  bool casadi = false;                       ///< CMakeLists.txt includes <model>_casadi.cmake
  bool calibration = false;                  ///< and <model>.a2l with <model>_a2l.h, which stand on them
  Spelling spelling = Spelling::fast;        ///< of the programs; for reading: each is one function
  bool sources_alone = false;  ///< leave out what tells or builds the sources: cost sheet, CMakeLists.txt, manifest
  /// Values of the program for other partitions and charts from which a solver is one of regular positions alone, see
  /// mbgen/solver/regular.hpp; none: always whole.
  std::optional<std::size_t> regular_only_from = {};
};

}  // namespace mbgen
