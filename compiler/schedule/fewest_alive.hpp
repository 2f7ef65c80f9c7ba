#pragma once
// The order of straight code.

#include <span>
#include <vector>

#include "compiler/program/program.hpp"

namespace mbgen {

/// An order of operations in which few values are alive at a time, wherever their sections are: registers and
/// first-level cache hold few numbers, and eight times fewer vectors. Built from the end: of the operations whose users
/// all stand, the one that brings the fewest new values to life comes next; then each operation that ends the life of a
/// value moves up to where its operands are known. bundles: the operations in an order that is sound, those that
/// stay together in one bundle; all that they need of others stands before them.
///   %2 = mul %0 %1; %3 = sin %0; %4 = mul %3 %3; %5 = add %4 %2   =>   %3 %4 %2 %5
std::vector<ValueId> fewest_alive(const Program& program, std::span<const std::vector<ValueId>> bundles);

}  // namespace mbgen
