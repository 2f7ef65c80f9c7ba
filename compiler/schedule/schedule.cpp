#include "compiler/schedule/schedule.hpp"

#include <algorithm>
#include <functional>
#include <utility>

#include "compiler/program/kinds.hpp"

namespace mbgen {
namespace {

/// Loops of a program too large for straight-line code; none if they save too little.
Rolling worthwhile_loops(const Program& program, const ScheduleOptions& options) {
  const auto statements = [&](std::size_t operations) { return operations + program.outputs.size(); };
  if (statements(program.nodes.size()) <= options.roll_above) return {};
  Rolling rolling = roll(program, options.indexed);
  if (statements(rolling.order.size()) <= options.roll_above) return {};
  std::size_t written = rolling.order.size();
  for (const RolledLoop& loop : rolling.loops) written -= loop.period * (loop.count - 1);
  return 2 * written > rolling.order.size() ? Rolling{} : rolling;
}

bool has_shared_laws(const Program& program) {
  return std::ranges::any_of(program.inputs, [](const Slot& slot) { return slot.group.array == Array::law_result; });
}

bool is_angle_pair(const Program& program, const Schedule& schedule, ValueId a, ValueId b) {
  if (schedule.calls.place[a].call >= 0 || schedule.calls.place[b].call >= 0) return false;
  const Node& first = program.nodes[a];
  const Node& second = program.nodes[b];
  return ((first.op == Op::sin && second.op == Op::cos) || (first.op == Op::cos && second.op == Op::sin)) &&
         schedule.value[a].operands == schedule.value[b].operands && first.section == second.section;
}

/// Counts the uses of every value, and finds the values that cannot be local variables.
void find_uses(const Program& program, Schedule& schedule) {
  for (const ScheduledUnit& unit : schedule.units)
    for (std::size_t i = unit.first; i < unit.last(); ++i) {
      const ValueId v = schedule.order[i];
      for (int k = 0; k < arity(program.nodes[v].op); ++k) {
        const ValueId operand = schedule.value[v].operands[static_cast<std::size_t>(k)];
        ScheduledValue& value = schedule.value[operand];
        ++value.users;
        value.user = v;
        if (value.unit < 0 || schedule.has_loops()) continue;
        value.crosses = value.crosses || schedule.units[static_cast<std::size_t>(value.unit)].part != unit.part;
      }
    }
  for (const ScheduledUnit& unit : schedule.units)
    for (std::size_t i = unit.first; schedule.has_loops() && i < unit.last(); ++i) {
      ScheduledValue& value = schedule.value[schedule.order[i]];
      value.crosses = unit.stored[value.offset] >= 0;
    }
}

/// Assigns places to values that cross parts: the most frequently read values get short addresses.
void place_crossing(const Program& program, Schedule& schedule, bool shares) {
  const std::vector<int> widths = widths_of(program);
  const auto part_of = [&](ValueId v) { return schedule.units[static_cast<std::size_t>(schedule.value[v].unit)].part; };
  struct Place {
    std::vector<ValueId> values;  ///< one after the other
    int users = 0;
  };
  std::vector<Place> places;
  for (const ValueId v : schedule.order) {
    const ScheduledValue& value = schedule.value[v];
    if (!value.crosses || schedule.calls.place[v].call >= 0) continue;
    const auto is_free = [&](const Place& place) {
      return shares && widths[place.values.back()] == widths[v] &&
             part_of(schedule.value[place.values.back()].user) < part_of(v);
    };
    auto place = std::ranges::find_if(places, is_free);
    if (place == places.end()) place = places.insert(places.end(), Place{});
    place->values.push_back(v);
    place->users += value.users;
  }
  // Pairs come first, in structs of their own except the last, each aligned for vectors.
  std::stable_partition(places.begin(), places.end(), [&](const Place& place) { return widths[place.values[0]] == 2; });
  for (std::size_t first = 0; first < places.size(); first += kPlacesTogether)
    std::ranges::stable_sort(places.begin() + first, places.begin() + std::min(first + kPlacesTogether, places.size()),
                             std::greater{},
                             [&](const Place& place) { return std::pair(widths[place.values[0]], place.users); });
  for (const Place& place : places) {
    for (const ValueId v : place.values) schedule.value[v].place = schedule.places;
    ++schedule.places;
  }
}

/// Sines next to cosines of the same angles, in all slices of a unit.
void find_partners(const Program& program, Schedule& schedule) {
  for (const ScheduledUnit& unit : schedule.units)
    for (std::size_t offset = 1; offset < unit.period; ++offset) {
      const auto value_at = [&](std::size_t slice, std::size_t at) {
        return schedule.order[unit.first + slice * unit.period + at];
      };
      bool are_pairs = true;
      for (std::size_t slice = 0; are_pairs && slice < unit.count; ++slice)
        are_pairs = is_angle_pair(program, schedule, value_at(slice, offset - 1), value_at(slice, offset));
      const ValueId a = value_at(0, offset - 1), b = value_at(0, offset);
      if (!are_pairs || (unit.is_loop() && schedule.value[a].partner != kNoValue)) continue;
      schedule.value[a].partner = b;
      schedule.value[b].partner = a;
    }
}

/// Whether a value has a single user, in the same slice and under the same heading.
bool can_be_inlined(const Program& program, const Schedule& schedule, const std::vector<bool>& is_output, ValueId v) {
  const ScheduledValue& value = schedule.value[v];
  const Node& node = program.nodes[v];
  if (value.users != 1 || value.crosses || value.partner != kNoValue || is_output[v] || node.label >= 0) return false;
  const ScheduledValue& place = schedule.value[value.user];
  const Op taken_by = program.nodes[value.user].op;
  if (taken_by == Op::first_lane || taken_by == Op::second_lane) return false;
  if (schedule.has_loops() && (place.unit != value.unit || place.slice != value.slice)) return false;
  if (schedule.ordered == ValueOrder::fewest_alive) return true;
  const Node& user = program.nodes[value.user];
  const bool is_of_a_sum = schedule.ordered == ValueOrder::reading && is_sum(user) && is_sum(node);
  return user.section == node.section && (user.owner == node.owner || is_of_a_sum);
}

/// Merges facts over all slices: a value is inlined or unused only if it is so in every slice.
void merge_slices(const Program& program, Schedule& schedule) {
  std::vector<bool> is_output(program.nodes.size(), false);
  for (const OutputValue& output : program.outputs) is_output[output.value] = true;
  for (const ScheduledUnit& unit : schedule.units)
    for (std::size_t offset = 0; offset < unit.period; ++offset) {
      ScheduledValue& first = schedule.value[schedule.order[unit.first + offset]];
      bool is_inlined = true;
      int users = 0;
      for (std::size_t slice = 0; slice < unit.count; ++slice) {
        const ValueId v = schedule.order[unit.first + slice * unit.period + offset];
        is_inlined = is_inlined && can_be_inlined(program, schedule, is_output, v) &&
                     schedule.value[schedule.value[v].user].offset == schedule.value[first.user].offset;
        users = std::max(users, schedule.value[v].users);
      }
      first.is_inlined = is_inlined;
      first.users = users;
    }
}

}  // namespace

bool is_rolled(const Program& program, const ScheduleOptions& options) {
  return !has_shared_laws(program) && !worthwhile_loops(program, options).loops.empty();
}

Schedule schedule(const Program& program, const ScheduleOptions& options) {
  const bool can_roll = options.order != ValueOrder::reading && options.division == Division::cheapest &&
                        !has_shared_laws(program) && !has_pairs(program);
  const Rolling rolling = can_roll ? worthwhile_loops(program, options) : Rolling{};
  Schedule result;
  if (rolling.loops.empty()) {
    result = straight_schedule(program, options.division, options.order, options.gathering);
    result.place_values(program);
  } else {
    result = rolled_schedule(program, rolling);
  }
  find_uses(program, result);
  if (!result.has_loops()) place_crossing(program, result, options.shares_places);
  find_partners(program, result);
  merge_slices(program, result);
  return result;
}

}  // namespace mbgen
