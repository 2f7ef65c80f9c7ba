#include "compiler/expressions/unit_exponents.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <numbers>

namespace mbgen {
namespace {

struct NamedUnit {
  std::string_view symbol;
  UnitExponents meaning;
};

constexpr double kDegree = std::numbers::pi / 180;

// Source: SI Brochure, tables 2, 4 and 8.
constexpr NamedUnit kUnits[] = {{"1", {}},
                                {"kg", {1, {1}}},
                                {"g", {1e-3, {1}}},
                                {"t", {1e3, {1}}},
                                {"m", {1, {0, 1}}},
                                {"mm", {1e-3, {0, 1}}},
                                {"cm", {1e-2, {0, 1}}},
                                {"km", {1e3, {0, 1}}},
                                {"s", {1, {0, 0, 1}}},
                                {"ms", {1e-3, {0, 0, 1}}},
                                {"min", {60, {0, 0, 1}}},
                                {"h", {3600, {0, 0, 1}}},
                                {"A", {1, {0, 0, 0, 1}}},
                                {"K", {1, {0, 0, 0, 0, 1}}},
                                {"mol", {1, {0, 0, 0, 0, 0, 1}}},
                                {"cd", {1, {0, 0, 0, 0, 0, 0, 1}}},
                                {"rad", {1, {0, 0, 0, 0, 0, 0, 0, 1}}},
                                {"deg", {kDegree, {0, 0, 0, 0, 0, 0, 0, 1}}},
                                {"rpm", {2 * std::numbers::pi / 60, {0, 0, -1, 0, 0, 0, 0, 1}}},
                                {"Hz", {1, {0, 0, -1}}},
                                {"N", {1, {1, 1, -2}}},
                                {"kN", {1e3, {1, 1, -2}}},
                                {"Nm", {1, {1, 2, -2}}},
                                {"Pa", {1, {1, -1, -2}}},
                                {"kPa", {1e3, {1, -1, -2}}},
                                {"MPa", {1e6, {1, -1, -2}}},
                                {"bar", {1e5, {1, -1, -2}}},
                                {"kNm", {1e3, {1, 2, -2}}},
                                {"J", {1, {1, 2, -2}}},
                                {"W", {1, {1, 2, -3}}},
                                {"kW", {1e3, {1, 2, -3}}},
                                {"V", {1, {1, 2, -3, -1}}},
                                {"%", {1e-2, {}}}};

UnitExponents product(const UnitExponents& a, const UnitExponents& b, int power) {
  UnitExponents result = a;
  result.factor *= std::pow(b.factor, power);
  for (std::size_t i = 0; i < result.exponents.size(); ++i) result.exponents[i] += power * b.exponents[i];
  return result;
}

/// Reads a unit from left to right.
class UnitReader {
 public:
  explicit UnitReader(std::string_view text) : text_(text) {}

  std::optional<UnitExponents> whole() {
    const auto result = terms();
    return at_ == text_.size() ? result : std::nullopt;
  }

 private:
  bool take(char c) {
    if (at_ >= text_.size() || text_[at_] != c) return false;
    ++at_;
    return true;
  }

  void skip_blanks() {
    while (take(' ')) continue;
  }

  std::optional<UnitExponents> terms() {
    UnitExponents result;
    for (bool is_first = true;; is_first = false) {
      skip_blanks();
      if (at_ == text_.size() || text_[at_] == ')') return is_first ? std::nullopt : std::optional(result);
      const int sign = !is_first && take('/') ? -1 : 1;
      if (sign == 1 && !is_first && !take('*')) take('.');
      skip_blanks();
      const std::optional<UnitExponents> next = factor();
      if (!next) return std::nullopt;
      result = product(result, *next, sign);
    }
  }

  std::optional<UnitExponents> factor() {
    std::optional<UnitExponents> base;
    if (take('(')) {
      base = terms();
      if (!take(')')) return std::nullopt;
    } else {
      base = symbol();
    }
    if (!base) return std::nullopt;
    if (!take('^')) return base;
    const bool is_negative = take('-');
    if (at_ >= text_.size() || std::isdigit(static_cast<unsigned char>(text_[at_])) == 0) return std::nullopt;
    const int power = text_[at_++] - '0';
    return product({}, *base, is_negative ? -power : power);
  }

  std::optional<UnitExponents> symbol() {
    const std::size_t start = at_;
    while (at_ < text_.size() && (std::isalpha(static_cast<unsigned char>(text_[at_])) != 0 || text_[at_] == '%'))
      ++at_;
    if (start == at_) take('1');
    const std::string_view name = text_.substr(start, at_ - start);
    for (const NamedUnit& unit : kUnits) {
      if (unit.symbol == name) return unit.meaning;
    }
    return std::nullopt;
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

}  // namespace

std::vector<std::string_view> known_units() {
  std::vector<std::string_view> symbols;
  for (const NamedUnit& unit : kUnits) symbols.push_back(unit.symbol);
  return symbols;
}

bool are_alike(const UnitExponents& one, const UnitExponents& other) {
  constexpr std::ptrdiff_t kBeforeAngles = 7;
  return std::equal(one.exponents.begin(), one.exponents.begin() + kBeforeAngles, other.exponents.begin());
}

std::optional<UnitExponents> unit_exponents(std::string_view unit) { return UnitReader(unit).whole(); }

}  // namespace mbgen
