#include <algorithm>
#include <unordered_map>
#include <utility>
#include <vector>

#include "compiler/passes/passes.hpp"

namespace mbgen {
namespace {

/// The program that gives the derived constants, in the making.
class Derivation {
 public:
  Derivation(SlotGroup group, const std::string& name) : group_(group), builder_(name) {}

  /// The program without what depends on the group alone.
  Program taken_out_of(const Program& program) {
    const std::vector<ValueId> derived = derived_values(program);
    ProgramBuilder rest = ProgramBuilder::like(program);
    std::vector<ValueId> renamed(program.nodes.size(), kNoValue);
    const auto prepare = [&](ValueId value) {
      if (renamed[value] == kNoValue) renamed[value] = in_rest(rest, derived[value]);
    };
    for (std::size_t i = 0; i < program.nodes.size(); ++i) {
      const Node& node = program.nodes[i];
      if (derived[i] != kNoValue && node.op != Op::constant) continue;
      for (int k = 0; k < arity(node.op); ++k) prepare(node.operands[k]);
      renamed[i] = rest.copy(program, node, renamed);
    }
    for (const OutputValue& output : program.outputs) {
      prepare(output.value);
      rest.output(output.slot.group, output.slot.index, renamed[output.value]);
    }
    return remove_dead_values(rest.finish());
  }

  Program finish() { return remove_dead_values(builder_.finish()); }

 private:
  /// Per node its value in the derivation, kNoValue where it depends on more than the group.
  std::vector<ValueId> derived_values(const Program& program) {
    std::vector<ValueId> derived(program.nodes.size(), kNoValue);
    for (std::size_t i = 0; i < program.nodes.size(); ++i) {
      const Node& node = program.nodes[i];
      bool is_derived = node.op != Op::pack && (node.op != Op::input || program.inputs[node.input].group == group_);
      for (int k = 0; k < arity(node.op); ++k) is_derived = is_derived && derived[node.operands[k]] != kNoValue;
      if (is_derived) derived[i] = builder_.copy(program, node, derived);
      if (is_derived && node.op == Op::input) slot_index_[derived[i]] = program.inputs[node.input].index;
    }
    return derived;
  }

  /// The value that stands for one of the derivation.
  ValueId in_rest(ProgramBuilder& rest, ValueId value) {
    const Node node = builder_.node(value);
    if (node.op == Op::constant) return rest.constant_like(node, builder_.constants());
    if (node.op == Op::negate) return rest.append(Op::negate, in_rest(rest, node.operands[0]));
    if (node.op == Op::input) return rest.input(group_, slot_index_.at(value));
    const auto [place, is_new] = places_.emplace(value, static_cast<int>(places_.size()));
    if (is_new) builder_.output(Array::derived, place->second, value);
    return rest.input(Array::derived, place->second);
  }

  SlotGroup group_;
  ProgramBuilder builder_;
  std::unordered_map<ValueId, int> slot_index_;  ///< of the inputs
  std::unordered_map<ValueId, int> places_;      ///< among the derived constants
};

}  // namespace

Program take_out_derived(std::span<Program* const> programs, SlotGroup group, const std::string& name) {
  Derivation derivation(group, name);
  for (Program* program : programs) {
    const bool has_any = std::ranges::any_of(program->inputs, [&](const Slot& slot) { return slot.group == group; });
    if (has_any) *program = derivation.taken_out_of(*program);
  }
  return derivation.finish();
}

}  // namespace mbgen
