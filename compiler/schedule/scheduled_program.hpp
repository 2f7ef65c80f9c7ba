#pragma once
// A program as it is written: the order of its values, its loops, its calls for many arguments, and its functions.

#include <array>
#include <cstddef>
#include <vector>

#include "compiler/program/program.hpp"
#include "compiler/schedule/array_calls.hpp"
#include "compiler/schedule/roll.hpp"

namespace mbgen {

/// Values of a part: one function holds at most so many, and at least half of that unless the program is smaller. g++
/// takes 251 s for 22 000 statements in one function and 2 s in parts of this size, which run no slower. Where time
/// counts, smaller ones take fewer bytes: registers are allotted better.
constexpr std::size_t kLargestPart = 800;
constexpr std::size_t kLargestHotPart = 500;

/// Places of values that cross parts in one struct. AVX-512 addresses numbers and vectors by multiples of their size:
/// so many after a pointer take one byte, the others four.
constexpr std::size_t kPlacesTogether = 128;

/// Half-open range of places in Schedule::order.
struct PlaceRange {
  std::size_t first = 0, last = 0;
};

/// A loop over `count` slices of `period` values each, or straight code: one slice.
struct ScheduledUnit {
  std::size_t first = 0, period = 0, count = 1;
  std::size_t part = 0;
  std::vector<int> stored = {};  ///< per value of a slice, in programs with loops: its place among the stored ones of
                                 ///< the slice, of straight code in the whole array; -1 for a local variable
  int first_stored = 0;          ///< place of the first slice in the array; 0 for straight code
  int stride = 0;                ///< stored values of one slice

  bool is_loop() const { return count > 1; }
  std::size_t last() const { return first + period * count; }
};

/// A value's place and use. Facts of the first slice hold for the values at the same offset of the others.
struct ScheduledValue {
  int unit = -1;  ///< -1 for constants, inputs and dead values
  std::size_t slice = 0, offset = 0;
  std::array<ValueId, 3> operands = {kNoValue, kNoValue, kNoValue};  ///< of loops: turned alike in all slices
  int users = 0;                                                     ///< operands that are this value
  ValueId user = kNoValue;                                           ///< the last of them
  bool crosses = false;        ///< used where no local variable of its part is seen
  int place = -1;              ///< of one that crosses parts, without loops and calls: see Schedule::places
  bool is_inlined = false;     ///< only its one user needs to know it: part of that user's expression
  ValueId partner = kNoValue;  ///< sine or cosine of the same angle beside this one, which no larger call computes
};

/// In which order straight code stands.
enum class ValueOrder {
  by_section,    ///< as the program has them, section after section where operands allow it
  fewest_alive,  ///< see fewest_alive.hpp
  reading        ///< as the program has them, for people: one function without calls for many arguments, and sums are
                 ///< written out over all parts of the mechanism
};

struct Schedule {
  ValueOrder ordered = ValueOrder::by_section;
  std::vector<ValueId> order;        ///< operations that an output needs, unit after unit
  std::vector<ScheduledUnit> units;  ///< at least one a part
  std::vector<PlaceRange> parts;     ///< at least one; each one function
  std::size_t law_part = 0;          ///< the first part that takes results of shared laws, 0 where there are none: they
                                     ///< are computed before it, from arguments that the parts before it give
  std::vector<ScheduledValue> value;  ///< per value of the program
  ArrayCalls calls;                   ///< elementary functions in lanes
  int stored = 0;                     ///< size of the array of values that cross, of programs with loops
  int places = 0;                     ///< for the others that cross, in each struct the most frequently
                                      ///< read first: the sixteen first are the cheapest to address

  bool has_loops() const { return loops() > 0; }
  std::size_t loops() const;
  /// Operations in the text: of one slice of each loop, and of straight code.
  std::size_t written() const;
  /// One operand of a value in every slice of a unit.
  std::vector<ValueId> operands_of(const ScheduledUnit& unit, std::size_t offset, int operand) const;
  /// The operands, one a slice of the unit, are one value of the same slice, or one value of straight code in the same
  /// part: a local variable.
  bool is_local(const ScheduledUnit& unit, const std::vector<ValueId>& operands) const;
  /// Index of a stored value in the array.
  int index_of(ValueId value) const;
  /// Fills units, slices, offsets and operands of `value`.
  void place_values(const Program& program);
};

/// Where a program without loops is cut into parts.
enum class Division {
  cheapest,   ///< where the fewest values cross
  by_section  ///< at every end of a section, and inside long ones where the fewest values cross
};

/// Inside the room, straight code: order, parts, calls and one unit a part; no facts of values.
Schedule straight_schedule(const Program& program, Division division, ValueOrder order, Gathering gathering);

/// Inside the room, code with loops: order, parts, units with their stored values, and the places and operands of
/// values.
Schedule rolled_schedule(const Program& program, const Rolling& rolling);

}  // namespace mbgen
