#pragma once

#include "compiler/program/program.hpp"

namespace mbgen {

/// Three or more divisions by one value become one reciprocal and products: a division costs several products.
/// Ensures: each replaced quotient within 1.5 units in the last place while the reciprocal is a normal number; the
/// reciprocal stands where the first of the divisions stood. Leaves single reciprocals as they are; constants divide
/// like any value.
///   %4 = div %0 %3; %5 = div %1 %3; %6 = div %2 %3
///   =>   %4 = constant 1; %5 = div %4 %3; %6 = mul %0 %5; %7 = mul %1 %5; %8 = mul %2 %5
Program merge_divisions(const Program& program);

}  // namespace mbgen
