#pragma once
// The door of the passes room. A pass is a pure function Program -> Program; each header holds its contract.

#include "compiler/program/program.hpp"

namespace mbgen {

/// Removes values that no output needs. Ensures: same outputs, same order of the remaining values, verified.
///   %0 = input z[0]; %1 = sin %0; %2 = cos %0; out zdd[0] = %1   =>   %0 = input z[0]; %1 = sin %0; out zdd[0] = %1
Program remove_dead_values(const Program& program);

/// All passes in order: the list is the architecture.
Program optimise(const Program& program);

}  // namespace mbgen
