#pragma once
// Programs of slots, run on numbers.

#include <map>
#include <vector>

#include "compiler/program/program.hpp"

namespace mbgen {

using SlotNumbers = std::map<Slot, double>;

/// All outputs by their slots, from inputs by theirs.
inline SlotNumbers outputs_at(const Program& program, const SlotNumbers& inputs) {
  std::vector<double> given;
  for (const Slot& slot : program.inputs) given.push_back(inputs.at(slot));
  const std::vector<double> values = interpret(program, given);
  SlotNumbers outputs;
  for (std::size_t i = 0; i < values.size(); ++i) outputs[program.outputs[i].slot] = values[i];
  return outputs;
}

}  // namespace mbgen
