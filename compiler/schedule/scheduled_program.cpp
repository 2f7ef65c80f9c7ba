#include "compiler/schedule/scheduled_program.hpp"

#include <algorithm>

namespace mbgen {

std::size_t Schedule::loops() const {
  return static_cast<std::size_t>(std::ranges::count_if(units, &ScheduledUnit::is_loop));
}

std::size_t Schedule::written() const {
  std::size_t count = 0;
  for (const ScheduledUnit& unit : units) count += unit.period;
  return count;
}

std::vector<ValueId> Schedule::operands_of(const ScheduledUnit& unit, std::size_t offset, int operand) const {
  std::vector<ValueId> operands;
  for (std::size_t slice = 0; slice < unit.count; ++slice)
    operands.push_back(
        value[order[unit.first + slice * unit.period + offset]].operands[static_cast<std::size_t>(operand)]);
  return operands;
}

bool Schedule::is_local(const ScheduledUnit& unit, const std::vector<ValueId>& operands) const {
  const ScheduledValue& first = value[operands[0]];
  const ScheduledUnit& home = units[static_cast<std::size_t>(first.unit)];
  if (!home.is_loop())
    return home.part == unit.part && std::ranges::all_of(operands, [&](ValueId v) { return v == operands[0]; });
  if (&home != &unit) return false;
  for (std::size_t slice = 0; slice < operands.size(); ++slice) {
    const ScheduledValue& other = value[operands[slice]];
    if (other.unit != first.unit || other.slice != slice || other.offset != first.offset) return false;
  }
  return true;
}

int Schedule::index_of(ValueId v) const {
  const ScheduledUnit& unit = units[static_cast<std::size_t>(value[v].unit)];
  return unit.first_stored + static_cast<int>(value[v].slice) * unit.stride + unit.stored[value[v].offset];
}

void Schedule::place_values(const Program& program) {
  value.assign(program.nodes.size(), {});
  for (std::size_t u = 0; u < units.size(); ++u)
    for (std::size_t i = units[u].first; i < units[u].last(); ++i) {
      const Node& node = program.nodes[order[i]];
      const std::size_t place = i - units[u].first;
      ScheduledValue& v = value[order[i]];
      v.unit = static_cast<int>(u);
      v.slice = place / units[u].period;
      v.offset = place % units[u].period;
      std::ranges::copy(node.operands, v.operands.begin());
    }
}

}  // namespace mbgen
