#pragma once
// Numbers that people write on the command line and in tables.

#include <string>

namespace mbgen {

/// A finite number. Fails: UserError with `what` in front.
double parse_number(const std::string& text, const std::string& what);

/// Digits behind the point of the shortest decimal that reads back as `value`.
int decimals_of(double value);

/// The double of the decimal with so many digits that `value` is but for the rounding of a product; else `value`.
double on_decimals(double value, int decimals);

}  // namespace mbgen
