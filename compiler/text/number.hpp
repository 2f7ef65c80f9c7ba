#pragma once
// Numbers on the command line and in tables.

#include <string>
#include <string_view>

namespace mbgen {

/// Largest magnitude of a number in a file or on the command line.
constexpr double kLargestNumber = 1e15;

/// Message on a larger number. written: its text.
std::string too_large(std::string_view written);

/// Parses a number of at most kLargestNumber in magnitude. Fails: UserError that begins with `what`.
double parse_number(const std::string& text, const std::string& what);

/// Decimal places of the shortest decimal equal to `value`.
int decimals_of(double value);

/// `value` rounded to so many decimals if the difference is rounding of a product; else `value`.
double on_decimals(double value, int decimals);

/// The largest of 1, 2 and 5 times a power of ten that is at most `value`. Requires: value > 0.
double round_number_below(double value);

}  // namespace mbgen
