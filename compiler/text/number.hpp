#pragma once
// Numbers on the command line and in tables.

#include <string>

namespace mbgen {

/// Parses a finite number. Fails: UserError that begins with `what`.
double parse_number(const std::string& text, const std::string& what);

/// Decimal places of the shortest decimal equal to `value`.
int decimals_of(double value);

/// `value` rounded to so many decimals if the difference is rounding of a product; else `value`.
double on_decimals(double value, int decimals);

}  // namespace mbgen
