#include "compiler/emit/rolled_places.hpp"

#include <algorithm>
#include <tuple>

#include "compiler/emit/arrangement.hpp"

namespace mbgen {
namespace {

bool is_operation(const Node& node) { return node.op != Op::constant && node.op != Op::input; }

constexpr int kAdopted = 1 << 30;  // added to places that a loop gave to straight values

bool commutes(Op op) { return op == Op::add || op == Op::multiply; }

void add_straight(std::size_t first, std::size_t last, RolledPlaces& places) {
  for (; first < last; first += kSmallestPart)
    places.units.push_back({first, std::min(last - first, kSmallestPart), 1, 0, false, {}, 0, 0});
}

/// Units in order, gathered into parts of at most kLargestPart written operations.
void add_units(const Rolling& rolling, RolledPlaces& places) {
  std::size_t next = 0;
  for (const RolledLoop& loop : rolling.loops) {
    add_straight(next, loop.first, places);
    places.units.push_back({loop.first, loop.period, loop.count, 0, true, {}, 0, 0});
    next = loop.end();
  }
  add_straight(next, rolling.order.size(), places);
  std::size_t written = 0;
  for (RolledUnit& unit : places.units) {
    if (written > 0 && written + unit.period > kLargestPart) {
      ++places.parts;
      written = 0;
    }
    written += unit.period;
    unit.part = places.parts;
    unit.stored.assign(unit.period, -1);
  }
  ++places.parts;
}

/// How an operand lies to the slice that uses it.
std::tuple<int, long, std::size_t> relation(const RolledPlaces& places, const RolledPlace& user, ValueId operand) {
  const RolledPlace& place = places.of[operand];
  return {place.unit, static_cast<long>(place.slice) - static_cast<long>(user.slice), place.offset};
}

/// Commuted operands were ordered by age, which may differ from slice to slice: turned to match the middle slice.
void match_operands(const Program& program, const Rolling& rolling, const RolledUnit& unit, RolledPlaces& places) {
  for (std::size_t offset = 0; offset < unit.period; ++offset) {
    const ValueId model = rolling.order[unit.first + (unit.count / 2) * unit.period + offset];
    if (!commutes(program.nodes[model].op)) continue;
    const auto first = relation(places, places.of[model], places.operands[model][0]);
    const auto second = relation(places, places.of[model], places.operands[model][1]);
    for (std::size_t slice = 0; slice < unit.count; ++slice) {
      const ValueId v = rolling.order[unit.first + slice * unit.period + offset];
      std::array<ValueId, 3>& operands = places.operands[v];
      const auto a = relation(places, places.of[v], operands[0]), b = relation(places, places.of[v], operands[1]);
      const bool fits = a == first || b == second, fits_turned = a == second || b == first;
      if (!fits && fits_turned) std::swap(operands[0], operands[1]);
    }
  }
}

/// Marks what is used elsewhere as stored, all values at its place of the slice alike.
void mark_stored(const Program& program, const Rolling& rolling, RolledPlaces& places) {
  for (std::size_t u = 0; u < places.units.size(); ++u) {
    for (std::size_t offset = 0; offset < places.units[u].period; ++offset) {
      const Node& node = program.nodes[rolling.order[places.units[u].first + offset]];
      for (int k = 0; k < arity(node.op); ++k) {
        const std::vector<ValueId> operands = operands_of(places, rolling, u, offset, k);
        if (!is_operation(program.nodes[operands[0]]) || is_local(places, u, operands)) continue;
        for (const ValueId v : operands) {
          const RolledPlace& place = places.of[v];
          places.units[static_cast<std::size_t>(place.unit)].stored[place.offset] = 0;
        }
      }
    }
  }
}

/// The slices before and after a loop, as far as straight code next to it does the same: their values stand in the
/// array where those of the loop's slices would, so that indices stay linear at its ends.
void extend_loop(const Program& program, const Rolling& rolling, const RolledUnit& loop, RolledPlaces& places) {
  const auto adopt = [&](std::size_t place, std::size_t offset, int slice) {
    const ValueId v = rolling.order[place];
    RolledUnit& home = places.units[static_cast<std::size_t>(places.of[v].unit)];
    if (home.is_loop || program.nodes[v].op != program.nodes[rolling.order[loop.first + offset]].op) return false;
    int& stored = home.stored[places.of[v].offset];
    if (stored == 0 && loop.stored[offset] >= 0)
      stored = kAdopted + loop.first_stored + slice * loop.stride + loop.stored[offset];
    return true;
  };
  const std::size_t end = loop.first + loop.period * loop.count;
  for (std::size_t k = 1; k <= std::min(loop.period, loop.first); ++k)
    if (!adopt(loop.first - k, loop.period - k, -1)) break;
  for (std::size_t k = 0; k < loop.period && end + k < rolling.order.size(); ++k)
    if (!adopt(end + k, k, static_cast<int>(loop.count))) break;
}

/// Gives every stored value its place in the array. Those of straight code are absolute.
void number_stored(const Program& program, const Rolling& rolling, RolledPlaces& places) {
  for (RolledUnit& unit : places.units) {
    if (!unit.is_loop) continue;
    for (int& stored : unit.stored)
      if (stored == 0) stored = unit.stride++;
    unit.first_stored = places.stored + unit.stride;
    places.stored += unit.stride * static_cast<int>(unit.count + 2);
  }
  for (const RolledUnit& unit : places.units)
    if (unit.is_loop) extend_loop(program, rolling, unit, places);
  for (RolledUnit& unit : places.units) {
    if (unit.is_loop) continue;
    for (int& stored : unit.stored)
      if (stored >= kAdopted)
        stored -= kAdopted;
      else if (stored == 0)
        stored = places.stored++;
  }
}

}  // namespace

std::vector<ValueId> operands_of(const RolledPlaces& places, const Rolling& rolling, std::size_t unit,
                                 std::size_t offset, int operand) {
  const RolledUnit& u = places.units[unit];
  std::vector<ValueId> operands;
  for (std::size_t slice = 0; slice < u.count; ++slice)
    operands.push_back(places.operands[rolling.order[u.first + slice * u.period + offset]][operand]);
  return operands;
}

bool is_local(const RolledPlaces& places, std::size_t unit, const std::vector<ValueId>& operands) {
  const RolledPlace& first = places.of[operands[0]];
  const RolledUnit& home = places.units[static_cast<std::size_t>(first.unit)];
  if (!home.is_loop)
    return home.part == places.units[unit].part &&
           std::all_of(operands.begin(), operands.end(), [&](ValueId v) { return v == operands[0]; });
  if (static_cast<std::size_t>(first.unit) != unit) return false;
  for (std::size_t slice = 0; slice < operands.size(); ++slice) {
    const RolledPlace& place = places.of[operands[slice]];
    if (static_cast<std::size_t>(place.unit) != unit || place.slice != slice || place.offset != first.offset)
      return false;
  }
  return true;
}

RolledPlaces place_values(const Program& program, const Rolling& rolling) {
  RolledPlaces places;
  add_units(rolling, places);
  places.of.resize(program.nodes.size());
  places.operands.resize(program.nodes.size());
  for (std::size_t u = 0; u < places.units.size(); ++u) {
    const RolledUnit& unit = places.units[u];
    for (std::size_t i = 0; i < unit.period * unit.count; ++i)
      places.of[rolling.order[unit.first + i]] = {static_cast<int>(u), i / unit.period, i % unit.period};
  }
  for (const ValueId v : rolling.order)
    std::copy(std::begin(program.nodes[v].operands), std::end(program.nodes[v].operands), places.operands[v].begin());
  for (const RolledUnit& unit : places.units)
    if (unit.is_loop) match_operands(program, rolling, unit, places);
  mark_stored(program, rolling, places);
  number_stored(program, rolling, places);
  return places;
}

}  // namespace mbgen
