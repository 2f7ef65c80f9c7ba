#pragma once
// The order in which a program's values are emitted, and its division into functions.

#include <cstddef>
#include <vector>

#include "compiler/emit/array_calls.hpp"
#include "compiler/program/program.hpp"

namespace mbgen {

/// Values of a part: one function holds at least the first and at most the second number, unless the program is
/// smaller. g++ takes 251 s for 22 000 statements in one function and 2 s in parts of this size, which run no slower.
constexpr std::size_t kSmallestPart = 400;
constexpr std::size_t kLargestPart = 1000;

/// Half-open range of places in Arrangement::order.
struct PartRange {
  std::size_t first = 0, last = 0;
};

struct Arrangement {
  std::vector<ValueId> order;    ///< operations that an output needs; inputs and constants are left out
  std::vector<PartRange> parts;  ///< at least one
  ArrayCalls array_calls;        ///< elementary functions in lanes
};

/// Where a program is cut into parts.
enum class Division {
  cheapest,   ///< where the fewest values cross
  by_section  ///< at every end of a section, and inside long ones where the fewest values cross
};

/// Orders and divides a program.
/// Order: that of the program, with the sections one after the other where operands allow it, and the cosine of an
/// angle right after its sine (or the other way round) where both are in one section; then gather_calls.
/// Parts: the cheapest division has the fewest values that cross from one part to the next; a cut inside a section
/// counts as kSectionCost more values, one between the two functions of an angle or inside a call for many arguments is
/// never made. Results of such a call are in memory anyway and do not count as crossing.
Arrangement arrange(const Program& program, Division division = Division::cheapest);

}  // namespace mbgen
