#pragma once
// Which values of a program are the same by algebra, whatever the inputs.

#include <vector>

#include "compiler/program/program.hpp"

namespace mbgen {

/// Identity of a value: zero, an earlier value or its negative; itself when `first` is its own number.
struct Identity {
  ValueId first = kNoValue;
  int sign = 1;  ///< 1, -1, or 0 for zero
};

/// One per value. Values are equal as rational functions of the inputs, of sines and cosines with sin^2 + cos^2 = 1,
/// and of the values of all other functions, the numbers of the model being the decimals that were typed: never because
/// they are near each other at some states. Equality is decided by evaluation at four random points, each modulo a
/// prime of 61 bits; the seed is fixed. Values of too high a degree count as new variables, so that the chance of one
/// wrong identity in a program stays below 2^-100. Method: docs/method/identities.md.
///   %2 = mul %0 %1; %3 = div %2 %1; %4 = sub %3 %0   =>   %3 is %0, %4 is zero
std::vector<Identity> identities(const Program& program);

}  // namespace mbgen
