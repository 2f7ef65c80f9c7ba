#pragma once
// A program in which some values take another form, and a program put into another.

#include <span>
#include <vector>

#include "compiler/program/program.hpp"

namespace mbgen {

/// rewrite(builder, v, renamed) appends another form of value v of `program`, or gives kNoValue for a copy. renamed:
/// new value of each older one. The new value keeps section, owner and label.
template <class Rewrite>
Program rewritten(const Program& program, const Rewrite& rewrite) {
  ProgramBuilder builder = ProgramBuilder::like(program);
  std::vector<ValueId> renamed;
  renamed.reserve(program.nodes.size());
  for (ValueId v = 0; v < program.nodes.size(); ++v) {
    const Node& node = program.nodes[v];
    builder.set_origin(node);
    const ValueId value = rewrite(builder, v, std::span<const ValueId>(renamed));
    if (value != kNoValue) builder.label_like(value, program, node);
    renamed.push_back(value != kNoValue ? value : builder.copy(program, node, renamed));
  }
  for (const auto& [slot, value] : program.outputs) builder.output(slot.group, slot.index, renamed[value]);
  return builder.finish();
}

/// Appends the values of `program` to another one. given(slot): the value there of an input of it, kNoValue for an input
/// of the same slot. Result: new value of each.
template <class Given>
std::vector<ValueId> put_in(ProgramBuilder& builder, const Program& program, const Given& given) {
  std::vector<ValueId> renamed;
  renamed.reserve(program.nodes.size());
  for (const Node& node : program.nodes) {
    const ValueId value =
        node.op == Op::input ? given(program.inputs[static_cast<std::size_t>(node.input)]) : kNoValue;
    renamed.push_back(value != kNoValue ? value : builder.copy(program, node, renamed));
  }
  return renamed;
}

}  // namespace mbgen
