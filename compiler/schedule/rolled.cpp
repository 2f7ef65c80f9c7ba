#include <algorithm>
#include <tuple>
#include <utility>

#include "compiler/program/kinds.hpp"
#include "compiler/schedule/scheduled_program.hpp"

namespace mbgen {
namespace {

constexpr int kAdopted = 1 << 30;  // added to places that a loop gave to straight values

bool commutes(Op op) { return op == Op::add || op == Op::multiply; }

/// One loop over slices, or a stretch of straight code of at most half a part.
void add_unit(std::size_t first, std::size_t period, std::size_t count, Schedule& schedule) {
  const std::size_t part = schedule.parts.size() - 1;
  schedule.units.push_back(
      {.first = first, .period = period, .count = count, .part = part, .stored = std::vector<int>(period, -1)});
}

void add_straight(std::size_t first, std::size_t last, Schedule& schedule) {
  for (; first < last; first += kLargestPart / 2)
    add_unit(first, std::min(last - first, kLargestPart / 2), 1, schedule);
}

/// Units in order, gathered into parts of at most kLargestPart written operations.
void add_units(const Rolling& rolling, Schedule& schedule) {
  schedule.parts = {{0, 0}};
  std::size_t next = 0;
  for (const RolledLoop& loop : rolling.loops) {
    add_straight(next, loop.first, schedule);
    add_unit(loop.first, loop.period, loop.count, schedule);
    next = loop.end();
  }
  add_straight(next, schedule.order.size(), schedule);
  std::size_t written = 0;
  for (ScheduledUnit& unit : schedule.units) {
    if (written > 0 && written + unit.period > kLargestPart) {
      schedule.parts.push_back({unit.first, unit.first});
      written = 0;
    }
    written += unit.period;
    unit.part = schedule.parts.size() - 1;
    schedule.parts.back().last = unit.last();
  }
}

/// How an operand lies to the slice that uses it.
std::tuple<int, long, std::size_t> relation(const Schedule& schedule, ValueId user, ValueId operand) {
  const ScheduledValue& place = schedule.value[operand];
  return {place.unit, static_cast<long>(place.slice) - static_cast<long>(schedule.value[user].slice), place.offset};
}

/// Commuted operands were ordered by age, which may differ from slice to slice: turned to match the middle slice.
void match_operands(const Program& program, const ScheduledUnit& unit, Schedule& schedule) {
  for (std::size_t offset = 0; offset < unit.period; ++offset) {
    const ValueId model = schedule.order[unit.first + (unit.count / 2) * unit.period + offset];
    if (!commutes(program.nodes[model].op)) continue;
    const auto first = relation(schedule, model, schedule.value[model].operands[0]);
    const auto second = relation(schedule, model, schedule.value[model].operands[1]);
    for (std::size_t slice = 0; slice < unit.count; ++slice) {
      const ValueId v = schedule.order[unit.first + slice * unit.period + offset];
      std::array<ValueId, 3>& operands = schedule.value[v].operands;
      const auto a = relation(schedule, v, operands[0]), b = relation(schedule, v, operands[1]);
      const bool fits = a == first || b == second, fits_turned = a == second || b == first;
      if (!fits && fits_turned) std::swap(operands[0], operands[1]);
    }
  }
}

/// Marks values with uses elsewhere as stored, all values at one place of the slice alike.
void mark_stored(const Program& program, Schedule& schedule) {
  for (const ScheduledUnit& unit : schedule.units) {
    for (std::size_t offset = 0; offset < unit.period; ++offset) {
      const Node& node = program.nodes[schedule.order[unit.first + offset]];
      for (int k = 0; k < arity(node.op); ++k) {
        const std::vector<ValueId> operands = schedule.operands_of(unit, offset, k);
        if (!is_operation(program.nodes[operands[0]]) || schedule.is_local(unit, operands)) continue;
        for (const ValueId v : operands) {
          const ScheduledValue& value = schedule.value[v];
          schedule.units[static_cast<std::size_t>(value.unit)].stored[value.offset] = 0;
        }
      }
    }
  }
}

/// The slices before and after a loop, as far as straight code next to it does the same: their values stand in the
/// array where those of the loop's slices would, so that indices stay linear at its ends.
void extend_loop(const Program& program, const ScheduledUnit& loop, Schedule& schedule) {
  const auto adopt = [&](std::size_t place, std::size_t offset, int slice) {
    const ValueId v = schedule.order[place];
    ScheduledUnit& home = schedule.units[static_cast<std::size_t>(schedule.value[v].unit)];
    if (home.is_loop() || program.nodes[v].op != program.nodes[schedule.order[loop.first + offset]].op) return false;
    int& stored = home.stored[schedule.value[v].offset];
    if (stored == 0 && loop.stored[offset] >= 0)
      stored = kAdopted + loop.first_stored + slice * loop.stride + loop.stored[offset];
    return true;
  };
  for (std::size_t k = 1; k <= std::min(loop.period, loop.first); ++k)
    if (!adopt(loop.first - k, loop.period - k, -1)) break;
  for (std::size_t k = 0; k < loop.period && loop.last() + k < schedule.order.size(); ++k)
    if (!adopt(loop.last() + k, k, static_cast<int>(loop.count))) break;
}

/// Gives every stored value its place in the array. Those of straight code are absolute.
void number_stored(const Program& program, Schedule& schedule) {
  for (ScheduledUnit& unit : schedule.units) {
    if (!unit.is_loop()) continue;
    for (int& stored : unit.stored)
      if (stored == 0) stored = unit.stride++;
    unit.first_stored = schedule.stored + unit.stride;
    schedule.stored += unit.stride * static_cast<int>(unit.count + 2);
  }
  for (const ScheduledUnit& unit : schedule.units)
    if (unit.is_loop()) extend_loop(program, unit, schedule);
  for (ScheduledUnit& unit : schedule.units) {
    if (unit.is_loop()) continue;
    for (int& stored : unit.stored)
      if (stored >= kAdopted)
        stored -= kAdopted;
      else if (stored == 0)
        stored = schedule.stored++;
  }
}

}  // namespace

Schedule rolled_schedule(const Program& program, const Rolling& rolling) {
  Schedule schedule;
  schedule.order = rolling.order;
  schedule.calls.place.resize(program.nodes.size());
  add_units(rolling, schedule);
  schedule.place_values(program);
  for (const ScheduledUnit& unit : schedule.units)
    if (unit.is_loop()) match_operands(program, unit, schedule);
  mark_stored(program, schedule);
  number_stored(program, schedule);
  return schedule;
}

}  // namespace mbgen
