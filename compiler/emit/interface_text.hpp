#pragma once
// The files that people read first: the interface of a solver and its build file.

#include <string>
#include <vector>

#include "compiler/emit/context.hpp"

namespace mbgen {

/// First lines of every emitted file, each after `mark` ("//" or "#"): model, content hash, command, mbgen version.
std::string banner_text(const Model& model, const std::string& mark);

/// Comment of struct State: how one starts, as the solver knows its start or does not.
std::string state_comment(const EmitContext& context);

/// The state of initial_state() in words, for comments.
std::string start_comment();

/// `<model>.hpp`.
std::string interface_text(const EmitContext& context);

/// Members of struct Parameters or Inputs or Outputs: name, value ("" for none), unit.
struct NumberMember {
  std::string name, value, unit;
};
std::vector<NumberMember> parameter_members(const EmitContext& context);
std::vector<NumberMember> input_members(const EmitContext& context);
std::vector<NumberMember> output_members(const EmitContext& context);

/// `CMakeLists.txt`.
std::string build_text(const EmitContext& context);

}  // namespace mbgen
