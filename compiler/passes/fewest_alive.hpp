#pragma once

#include "compiler/program/program.hpp"

namespace mbgen {

/// Orders operations so that few values are alive at a time, wherever their sections are: registers and first-level
/// cache hold eight times fewer vectors than numbers. Built from the end, where of the operations that all users of
/// stand, the one that brings the fewest new values to life comes next; then each operation that ends the life of a
/// value moves up to where its operands are known. Ensures: the same operations, outputs bit for bit.
///   %2 = mul %0 %1; %3 = sin %0; %4 = mul %3 %3; %5 = add %4 %2
///   =>   %2 = sin %0; %3 = mul %2 %2; %4 = mul %0 %1; %5 = add %3 %4
Program fewest_alive(const Program& program);

}  // namespace mbgen
