#pragma once
// The file that people read first: the interface of a solver.

#include <string>
#include <vector>

#include "compiler/emit/context.hpp"
#include "compiler/emit/frame.hpp"

namespace mbgen {

/// First lines of every emitted file, each after `mark` ("//" or "#"): model, content hash, command, mbgen version.
std::string banner_text(const Model& model, const std::string& mark);

/// `<model>.hpp`.
std::string interface_text(const EmitContext& context);

/// Members of struct Parameters or Inputs or Outputs: name, value ("" for none), unit.
struct NumberMember {
  std::string name, value, unit;
};
std::vector<NumberMember> parameter_members(const EmitContext& context);
std::vector<NumberMember> input_members(const EmitContext& context);
std::vector<NumberMember> output_members(const EmitContext& context);

/// A row for each name, as `member`.
FrameRows name_rows(const std::vector<std::string>& names);

/// A row for each, with its unit for a comment: `member`, `unit`.
FrameRows member_rows(const std::vector<NumberMember>& members);

/// Values of tuned.in, struct Tuned: the tunable parameters with the constants that follow from them, which every
/// function of a solver takes. constructs: whether it makes itself of parameters.
FrameValues tuned_values(const Programs& programs, bool constructs);

}  // namespace mbgen
