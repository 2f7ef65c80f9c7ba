#pragma once
// Sums and products of the decimals that people type: 0.41 - 0.40 is 0.01.

#include <cstdint>
#include <optional>

namespace mbgen {

/// digits 10^exponent
struct TypedDecimal {
  std::int64_t digits = 0;
  int exponent = 0;
};

/// The shortest decimal that reads back as `value`, none when it is longer than people type (15 digits).
std::optional<TypedDecimal> typed_decimal(double value);

/// a + b and a b, taken as the shortest decimals that read back as a and b and rounded once. Where one of these has
/// more than 15 digits, which nobody typed: as doubles, then freed of their rounding.
double decimal_sum(double a, double b);
double decimal_product(double a, double b);

/// A number freed of the rounding of earlier steps: the decimal of at most 11 digits, counted from the first of `size`,
/// within 4e-15 of `size` of it; itself if there is none. size: of the largest term of a sum, so that the remainder of
/// terms that cancel becomes 0. Numbers that are equal up to rounding become one number.
double without_rounding(double value, double size);

}  // namespace mbgen
