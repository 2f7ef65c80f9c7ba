#include "compiler/linearisation/groups.hpp"

#include <algorithm>

namespace mbgen {

std::vector<double> group_of(const Groups& groups, SlotGroup name, int size) {
  const auto found = groups.find(name);
  std::vector<double> group = found == groups.end() ? std::vector<double>() : found->second;
  group.resize(static_cast<std::size_t>(size));
  return group;
}

std::vector<Groups> evaluate(const Program& program, const Groups& inputs, SlotGroup varied,
                             const std::vector<std::vector<double>>& values) {
  std::vector<double> all;
  all.reserve(program.inputs.size() * values.size());
  for (const Slot& slot : program.inputs) {
    const auto index = static_cast<std::size_t>(slot.index);
    const double known = slot.group == varied ? 0 : inputs.at(slot.group).at(index);
    for (const std::vector<double>& one : values) all.push_back(slot.group == varied ? one.at(index) : known);
  }
  const std::vector<double> results = interpret(program, all, values.size());
  std::vector<Groups> outputs(values.size());
  for (std::size_t i = 0; i < program.outputs.size(); ++i) {
    const Slot& slot = program.outputs[i].slot;
    const auto index = static_cast<std::size_t>(slot.index);
    for (std::size_t k = 0; k < values.size(); ++k) {
      std::vector<double>& group = outputs[k][slot.group];
      group.resize(std::max(group.size(), index + 1));
      group[index] = results[i * values.size() + k];
    }
  }
  return outputs;
}

Groups evaluate(const Program& program, const Groups& inputs) {
  std::vector<double> values;
  for (const Slot& slot : program.inputs) {
    values.push_back(inputs.at(slot.group).at(static_cast<std::size_t>(slot.index)));
  }
  const std::vector<double> results = interpret(program, values);
  Groups outputs;
  for (std::size_t i = 0; i < results.size(); ++i) {
    const Slot& slot = program.outputs[i].slot;
    std::vector<double>& group = outputs[slot.group];
    group.resize(std::max(group.size(), static_cast<std::size_t>(slot.index) + 1));
    group[static_cast<std::size_t>(slot.index)] = results[i];
  }
  return outputs;
}

int direction_size(std::span<const DirectionGroup> groups) {
  int size = 0;
  for (const DirectionGroup& group : groups) size += group.size;
  return size;
}

std::vector<double> joined(std::span<const DirectionGroup> groups, const Groups& direction) {
  std::vector<double> entries;
  for (const DirectionGroup& group : groups) {
    const std::vector<double> part = group_of(direction, group.group, group.size);
    entries.insert(entries.end(), part.begin(), part.end());
  }
  return entries;
}

}  // namespace mbgen
