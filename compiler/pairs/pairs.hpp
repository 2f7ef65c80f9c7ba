#pragma once
// The door of the pairs room: left and right of a mechanism, or twins, in two lanes.

#include <span>

#include "compiler/solver/programs.hpp"

namespace mbgen {

/// Left and right of a mechanism as pairs: a value and what its mirror image is become one value of two lanes, each
/// operation on it one for both sides. A second lane holds the image, not the value of the other side, so that both
/// lanes have the same operations, constants and signs. Sums over both sides are summed in lanes. Pairs that cost more
/// to pack and take apart than they save stay numbers. mirror: see AlikeInputs. Empty where no pair is worth it.
/// Ensures: values equal up to rounding; what the pairs replace is dead. Method: docs/method/pairs.md.
///   %2 = mul %0 %0; %3 = mul %1 %1; %4 = add %2 %3      %0 left, %1 right
///   =>   %2 = pack %0 %1; %3 = mul %2 %2; %4 = first_lane %3; %5 = second_lane %3; %6 = add %4 %5
Program fold_pairs(const Program& program, std::span<const MirroredInput> mirror);

/// Twins as pairs, likewise: the same operations on other operands become one operation, the second lane of a pair the
/// value of the other part. twins: see AlikeInputs.
///   %2 = mul %0 0.5; %3 = mul %1 0.7      %0 and %1 twins   =>   %2 = pack %0 %1; %3 = pack 0.5 0.7; %4 = mul %2 %3
Program fold_twins(const Program& program, std::span<const TwinInput> twins);

}  // namespace mbgen
