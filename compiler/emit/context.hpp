#pragma once
// The source of every emitted file.

#include <optional>
#include <string>

#include "compiler/emit/files.hpp"
#include "compiler/emit/layout.hpp"
#include "compiler/emit/names.hpp"

namespace mbgen {

/// Source of every emitted file.
struct EmitContext {
  const Programs& programs;
  const Model& model;
  const Topology& topology;
  const Analysis& analysis;
  SolverNames names;
  SolverLayout layout;
  std::size_t roll_above = kRollAbove;             ///< see EmitOptions
  int lanes = 0;                                   ///< of the batch interface, 0 for none
  bool c_interface = false;                        ///< whether there is one
  std::string scalar = "double";                   ///< of the solver: double or float
  std::optional<InitialState> initial = {};        ///< where it starts, if it is to know
  std::size_t file_part_values = kFilePartValues;  ///< see EmitOptions
};

}  // namespace mbgen
