#include "compiler/text/number.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include "compiler/text/user_error.hpp"

namespace mbgen {

std::string too_large(std::string_view written) {
  return fmt::format("must be at most {:g} in magnitude, got {}", kLargestNumber, written);
}

double parse_number(const std::string& text, const std::string& what) {
  double value = 0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || stop != end || !std::isfinite(value)) {
    throw UserError(fmt::format("{}: \"{}\" is not a finite number\n", what, text));
  }
  if (std::abs(value) > kLargestNumber) throw UserError(fmt::format("{}: {}\n", what, too_large(text)));
  return value;
}

int decimals_of(double value) {
  const std::string text = fmt::format("{}", value);
  const std::size_t exponent = std::min(text.find('e'), text.size()), point = text.find('.');
  const int digits = point < exponent ? static_cast<int>(exponent - point) - 1 : 0;
  return std::max(0, digits - (exponent < text.size() ? std::stoi(text.substr(exponent + 1)) : 0));
}

double on_decimals(double value, int decimals) {
  const double decimal = std::stod(fmt::format("{:.{}f}", value, decimals));
  const double rounding = 2 * std::numeric_limits<double>::epsilon() * std::abs(value);
  return std::abs(decimal - value) <= rounding ? decimal : value;
}

double round_number_below(double value) {
  const double power = std::pow(10.0, std::floor(std::log10(value)));
  return (value >= 5 * power ? 5 : value >= 2 * power ? 2 : 1) * power;
}

}  // namespace mbgen
