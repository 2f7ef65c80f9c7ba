#pragma once
// Sums and products of the decimals that people type: 0.41 - 0.40 is 0.01. Inside the program room.

namespace mbgen {

/// a + b and a b, taken as the shortest decimals that read back as a and b and rounded once; as doubles where one of
/// these has more than 15 digits, which nobody typed.
double decimal_sum(double a, double b);
double decimal_product(double a, double b);

}  // namespace mbgen
