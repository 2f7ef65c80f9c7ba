#pragma once
// The files that people read first: the interface of a solver, its manifest and its build file.

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "compiler/emit/emit.hpp"
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

/// First lines of every emitted file, each after `mark` ("//" or "#"): model, content hash, command, mbgen version.
std::string banner_text(const Model& model, const std::string& mark);

/// Comment of struct State: how one starts, as the solver knows its start or does not.
std::string state_comment(const EmitContext& context);

/// The state of initial_state() in words, for comments.
std::string start_comment();

/// `<model>.hpp`.
std::string interface_text(const EmitContext& context);

/// `<model>.cpp`. appendix: further text of the solver, after its namespace.
EmittedFile solver_file(const EmitContext& context, std::vector<ShapedProgram> programs,
                        const std::string& appendix = "");

/// The constants that the texts of a file use, under a heading; empty without any.
std::string constants_text(const ConstantNames& names, const std::string& scalar);

/// Members of the struct System, see mbgen/blocks.hpp and mbgen/batch.hpp. members: those that are its programs' and
/// their results'; scalar: type of its values.
std::string system_text(const EmitContext& context, const std::string& members, const std::string& scalar);

/// `<model>_batch.hpp`. Requires: context.lanes > 0, as for the next.
std::string batch_interface_text(const EmitContext& context);

/// `<model>_batch.cpp`.
/// scalars: the solver's programs. Loops over subsystems are of numbers: here all code is straight.
std::string batch_text(const EmitContext& context, const std::vector<ShapedProgram>& scalars);

/// Members of struct Parameters or Inputs or Outputs: name, value ("" for none), unit.
struct NumberMember {
  std::string name, value, unit;
};
std::vector<NumberMember> parameter_members(const EmitContext& context);
std::vector<NumberMember> input_members(const EmitContext& context);
std::vector<NumberMember> output_members(const EmitContext& context);

/// The manifest: sizes, names, loop blocks, operation counts of every section of every program, worst case.
nlohmann::ordered_json manifest_json(const EmitContext& context, const std::vector<ShapedProgram>& programs);

/// `<model>.json`.
std::string manifest_text(const nlohmann::ordered_json& manifest);

/// `CMakeLists.txt`.
std::string build_text(const EmitContext& context);

}  // namespace mbgen
