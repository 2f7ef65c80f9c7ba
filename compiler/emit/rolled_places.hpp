#pragma once
// Where the values of a rolled program live: units of straight code and loops, and the array of values that cross them.

#include <array>
#include <vector>

#include "compiler/passes/roll.hpp"
#include "compiler/program/program.hpp"

namespace mbgen {

/// A loop, or a stretch of straight code.
struct RolledUnit {
  std::size_t first = 0, period = 0, count = 1;  ///< places in Rolling::order; straight code is one slice
  std::size_t part = 0;                          ///< function that holds it
  bool is_loop = false;
  std::vector<int> stored;  ///< per value of a slice: place among the stored ones, -1 for none; of straight code in the
                            ///< whole array
  int first_stored = 0;     ///< place of the first slice in the array; 0 for straight code
  int stride = 0;           ///< stored values of one slice
};

/// Place of a value.
struct RolledPlace {
  int unit = -1;  ///< -1 for constants and inputs
  std::size_t slice = 0, offset = 0;
};

struct RolledPlaces {
  std::vector<RolledUnit> units;
  std::vector<RolledPlace> of;                   ///< per value of the program
  std::vector<std::array<ValueId, 3>> operands;  ///< per value; sums and products turned to match their other slices
  std::size_t parts = 0;
  int stored = 0;  ///< size of the array

  /// Index of a stored value in the array.
  int index_of(ValueId value) const {
    const RolledPlace& place = of[value];
    const RolledUnit& unit = units[static_cast<std::size_t>(place.unit)];
    return unit.first_stored + static_cast<int>(place.slice) * unit.stride + unit.stored[place.offset];
  }
};

/// One operand of a value in every slice of a unit.
std::vector<ValueId> operands_of(const RolledPlaces& places, const Rolling& rolling, std::size_t unit,
                                 std::size_t offset, int operand);

/// The operands are one value of the same slice, or one value of straight code in the same part: a local variable.
bool is_local(const RolledPlaces& places, std::size_t unit, const std::vector<ValueId>& operands);

RolledPlaces place_values(const Program& program, const Rolling& rolling);

}  // namespace mbgen
