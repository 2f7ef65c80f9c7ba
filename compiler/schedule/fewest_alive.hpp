#pragma once
// Order of straight-line code.

#include <span>
#include <vector>

#include "compiler/program/program.hpp"

namespace mbgen {

/// An order of operations with few simultaneously live values, regardless of sections: registers and first-level cache
/// contain few numbers, and eight times fewer vectors. Built from the end: next comes the operation, with all users
/// placed, that makes the fewest new values alive; then each last use of a value moves up to the point where its
/// operands are known. bundles: the operations in a valid order, with operations that stay together in one bundle;
/// operands from other bundles precede it.
///   %2 = mul %0 %1; %3 = sin %0; %4 = mul %3 %3; %5 = add %4 %2   =>   %3 %4 %2 %5
std::vector<ValueId> fewest_alive(const Program& program, std::span<const std::vector<ValueId>> bundles);

}  // namespace mbgen
