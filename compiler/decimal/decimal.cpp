#include "compiler/decimal/decimal.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <optional>
#include <string>

namespace mbgen {
namespace {

__extension__ typedef __int128 Wide;

/// digits 10^exponent
struct Decimal {
  Wide digits = 0;
  int exponent = 0;
};

constexpr int kMostDigits = 15;   ///< of a decimal that a double holds whatever its digits
constexpr int kMostShift = 18;    ///< 15 + 18 digits fit into Wide
constexpr int kFreedDigits = 11;  ///< one number in a thousand that nobody typed lies that near to so short a decimal
constexpr double kRounding = 4e-15;  ///< of the size of a number: what some twenty roundings leave

constexpr double kPowers[] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,  1e10, 1e11,
                              1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
constexpr int kMostPower = std::size(kPowers) - 1;  ///< of ten that a double holds
constexpr Wide kMostWhole = Wide{1} << 53;          ///< up to here doubles hold every whole number

/// The nearest double.
double nearest(Decimal decimal) {
  // One operation on numbers that are doubles rounds once (W. D. Clinger 1990).
  if (-kMostWhole <= decimal.digits && decimal.digits <= kMostWhole && std::abs(decimal.exponent) <= kMostPower) {
    const auto digits = static_cast<double>(static_cast<std::int64_t>(decimal.digits));
    const double power = kPowers[std::abs(decimal.exponent)];
    return decimal.exponent < 0 ? digits / power : digits * power;
  }
  const bool is_negative = decimal.digits < 0;
  std::string digits;
  for (Wide rest = is_negative ? -decimal.digits : decimal.digits; rest != 0; rest /= 10)
    digits.insert(digits.begin(), static_cast<char>('0' + static_cast<int>(rest % 10)));
  if (digits.empty()) return 0;
  digits += 'e' + std::to_string(decimal.exponent);
  double value = 0;
  std::from_chars(digits.data(), digits.data() + digits.size(), value);
  return is_negative ? -value : value;
}

Decimal with_exponent(Decimal decimal, int exponent) {
  for (; decimal.exponent > exponent; --decimal.exponent) decimal.digits *= 10;
  return decimal;
}

}  // namespace

namespace {

/// A number with at most kFewPlaces digits after the point: a decimal of at most 15 digits that reads back as it is the
/// only one.
std::optional<TypedDecimal> with_few_places(double value) {
  constexpr int kFewPlaces = 6;
  constexpr double kMost = 1e9;  // 15 digits with six places
  if (!(std::abs(value) < kMost)) return {};
  for (int places = 0; places <= kFewPlaces; ++places) {
    auto digits = static_cast<std::int64_t>(value * kPowers[places] + (value < 0 ? -0.5 : 0.5));
    if (static_cast<double>(digits) / kPowers[places] != value) continue;
    int exponent = -places;
    for (; digits != 0 && digits % 10 == 0; digits /= 10) ++exponent;
    return TypedDecimal{digits, digits == 0 ? 0 : exponent};
  }
  return {};
}

}  // namespace

std::optional<TypedDecimal> typed_decimal(double value) {
  if (const std::optional<TypedDecimal> typed = with_few_places(value)) return typed;
  char text[32];
  const auto written = std::to_chars(text, text + sizeof text, std::abs(value), std::chars_format::scientific);
  std::int64_t digits = 0;
  int count = 0, after_point = 0;
  const char* at = text;
  for (bool is_after_point = false; at != written.ptr && *at != 'e'; ++at) {
    if (*at == '.') {
      is_after_point = true;
      continue;
    }
    digits = 10 * digits + (*at - '0');
    ++count;
    if (is_after_point) ++after_point;
  }
  if (at == written.ptr || count > kMostDigits) return {};
  const bool has_sign = at[1] == '+';
  int exponent = 0;
  std::from_chars(at + (has_sign ? 2 : 1), written.ptr, exponent);
  return TypedDecimal{value < 0 ? -digits : digits, exponent - after_point};
}

double decimal_sum(double a, double b) {
  const double sum = a + b;
  if (!std::isfinite(sum)) return sum;
  const std::optional<TypedDecimal> first = typed_decimal(a), second = typed_decimal(b);
  if (!first || !second) return without_rounding(sum, std::max(std::abs(a), std::abs(b)));
  if (std::abs(first->exponent - second->exponent) > kMostShift) return sum;
  const int exponent = first->exponent < second->exponent ? first->exponent : second->exponent;
  return nearest({with_exponent({first->digits, first->exponent}, exponent).digits +
                      with_exponent({second->digits, second->exponent}, exponent).digits,
                  exponent});
}

double decimal_product(double a, double b) {
  const double product = a * b;
  if (!std::isnormal(product)) return product;
  const std::optional<TypedDecimal> first = typed_decimal(a), second = typed_decimal(b);
  if (!first || !second) return without_rounding(product, product);
  return nearest({Wide{first->digits} * second->digits, first->exponent + second->exponent});
}

double without_rounding(double value, double size) {
  if (!std::isnormal(size)) return value;
  const int exponent = static_cast<int>(std::floor(std::log10(std::abs(size)))) - (kFreedDigits - 1);
  const double count = std::nearbyint(value / std::pow(10.0, exponent));
  if (!(std::abs(count) < std::pow(10.0, kMostDigits))) return value;
  const double freed = nearest({static_cast<std::int64_t>(count), exponent});
  return std::abs(freed - value) <= kRounding * std::abs(size) ? freed : value;
}

}  // namespace mbgen
