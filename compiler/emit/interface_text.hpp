#pragma once
// The files that people read first: the interface of a solver, its manifest and its build file.

#include <string>

#include "compiler/emit/layout.hpp"
#include "compiler/emit/names.hpp"

namespace mbgen {

/// What every emitted file is made from.
struct EmitContext {
  const Programs& programs;
  const Model& model;
  const Topology& topology;
  const Analysis& analysis;
  SolverNames names;
  SolverLayout layout;
  std::size_t roll_above = kRollAbove;  ///< see EmitOptions
};

/// First lines of every emitted file, each after `mark` ("//" or "#"): model, content hash, command, mbgen version.
std::string banner_text(const Model& model, const std::string& mark);

/// `<model>.hpp`.
std::string interface_text(const EmitContext& context);

/// `<model>.cpp`.
std::string solver_text(const EmitContext& context);

/// `<model>.json`: sizes, names, loop blocks and operation counts of every section of every program.
std::string manifest_text(const EmitContext& context);

/// `CMakeLists.txt`.
std::string build_text(const EmitContext& context);

}  // namespace mbgen
