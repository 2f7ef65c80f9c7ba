#pragma once

#include "compiler/program/program.hpp"

namespace mbgen {

/// Removes values and inputs that no output needs. Ensures: the same outputs bit for bit, the same order of what
/// remains.
///   %0 = input z[0]; %1 = sin %0; %2 = cos %0; out zdd[0] = %1   =>   %0 = input z[0]; %1 = sin %0; out zdd[0] = %1
Program remove_dead_values(const Program& program);

}  // namespace mbgen
