#pragma once

#include "compiler/program/program.hpp"

namespace mbgen {

/// Writes every sum as one chain: terms that cancel leave it, constants become one, a factor that several products
/// share is taken out, plain terms come before products so that each product fuses with an addition. A sum is what
/// additions, subtractions and negations of unnamed values of one use make; named values stay as they are. Ensures:
/// fewer operations or as many; values equal up to rounding.
///   %3 = mul %0 %1; %4 = mul %0 %2; %5 = add %3 %4   =>   %3 = add %1 %2; %4 = mul %0 %3
Program factor_sums(const Program& program);

}  // namespace mbgen
