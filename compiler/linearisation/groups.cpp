#include "compiler/linearisation/groups.hpp"

#include <algorithm>

namespace mbgen {

std::vector<double> group_of(const Groups& groups, SlotGroup name, int size) {
  const auto found = groups.find(name);
  std::vector<double> group = found == groups.end() ? std::vector<double>() : found->second;
  group.resize(static_cast<std::size_t>(size));
  return group;
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
