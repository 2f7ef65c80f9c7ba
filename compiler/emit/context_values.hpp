#pragma once
// Values of frames that several files share.

#include <string>
#include <vector>

#include "compiler/emit/context.hpp"
#include "compiler/emit/frame.hpp"

namespace mbgen {

/// The embedded frame of this name, filled with the values and, where it names them, with the common values of the
/// solver (names, sizes, choices), listed in context_values.cpp.
std::string fill_template(const EmitContext& context, const std::string& name, const FrameValues& values = {});

/// First lines of every emitted file, each after `mark` ("//" or "#"): model, content hash, command, mbgen version.
/// options: of the command.
std::string banner_text(const Model& model, const std::string& mark, const std::string& options = "");

/// banner_text as one comment of C.
std::string c_banner_text(const Model& model);

/// Text on one line for a comment of C.
std::string c_comment_text(const std::string& text);

/// FOUR_BAR_, for macros.
std::string guard_of(const std::string& solver);

/// Members of struct Parameters or Inputs or Outputs: name, value ("" for none), unit.
struct NumberMember {
  std::string name, value, unit;
};
std::vector<NumberMember> parameter_members(const EmitContext& context);
std::vector<NumberMember> input_members(const EmitContext& context);
std::vector<NumberMember> output_members(const EmitContext& context);

/// Whether the solver is one with derivatives and gives its start some, see has_start_with_derivatives.
bool starts_with_derivatives(const EmitContext& context);

/// Name of the solver's step function for the model's integrator.
std::string step_function(const SolverSettings& settings);

/// A row for each name, as `member`.
FrameRows name_rows(const std::vector<std::string>& names);

/// A row for each, with its unit for a comment: `member`, `unit`.
FrameRows member_rows(const std::vector<NumberMember>& members);

/// Values of tuned.in, struct Tuned: the tunable parameters with the constants that depend on them; every function of a
/// solver takes it. constructs: whether it is constructed from parameters.
FrameValues tuned_values(const Programs& programs, bool constructs);

}  // namespace mbgen
