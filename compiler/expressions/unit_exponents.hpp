#pragma once
// Units as people write them, in terms of the base units.

#include <array>
#include <optional>
#include <string_view>
#include <vector>

namespace mbgen {

/// A unit as factor times a product of powers: 1 unit = factor kg^.. m^.. s^.. A^.. K^.. mol^.. cd^.. rad^..
struct UnitExponents {
  double factor = 1;
  std::array<int, 8> exponents{};  ///< kg m s A K mol cd rad
};

/// Reads "N m s/rad", "kg m^2", "N/(m/s)": symbols with whole powers, side by side or with * or . between them; a slash
/// divides by the next unit or parenthesis alone. None for an unknown unit.
std::optional<UnitExponents> unit_exponents(std::string_view unit);

/// Whether numbers of one unit can be given in the other: angles count as numbers, so that N m/rad is N m.
bool are_alike(const UnitExponents& one, const UnitExponents& other);

/// Every symbol that it knows.
std::vector<std::string_view> known_units();

}  // namespace mbgen
