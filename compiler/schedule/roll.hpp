#pragma once

#include <cstddef>
#include <set>
#include <string>
#include <vector>

#include "compiler/program/program.hpp"

namespace mbgen {

/// `count` slices of `period` values each with the same operations on other numbers: one loop.
struct RolledLoop {
  std::size_t first = 0;   ///< place in Rolling::order
  std::size_t period = 0;  ///< values of one slice
  std::size_t count = 0;   ///< slices
  std::size_t end() const { return first + period * count; }
};

struct Rolling {
  std::vector<ValueId> order;     ///< operations needed by outputs, in program order
  std::vector<RolledLoop> loops;  ///< ascending, disjoint; values between them are straight-line code
};

/// Number of operations and outputs above which a program is rolled: larger straight-line code exceeds the instruction
/// cache and takes long to compile. Measured in docs/evidence/growth.md.
constexpr std::size_t kRollAbove = 8192;

/// Finds the loops over equal subsystems: runs of consecutive slices with the same operations in the same sections on
/// operands of the same kinds (constant, input of a group, value) for the same groups of outputs. Which constant, input
/// or value it is may differ from slice to slice; the emitted code takes it from a table where it is no linear function
/// of the slice. Longest savings first, from the start of the program; a loop starts where the fewest values cross
/// from one slice to the next.
/// indexed: groups of slots whose index may differ from slice to slice.
///   sin %z0; mul %c0 ..; sin %z1; mul %c1 ..; sin %z2; mul %c2 ..  =>  3 slices of 2 values
Rolling roll(const Program& program, const std::set<SlotGroup>& indexed);

}  // namespace mbgen
