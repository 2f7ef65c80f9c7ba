#pragma once
// Numbers modulo four primes: exact arithmetic of rational numbers that are told apart, not written down. Inside the
// program room.

#include <array>
#include <compare>
#include <cstdint>
#include <span>
#include <vector>

namespace mbgen {

/// A rational number, or the value of a rational function at a point of each of four prime fields.
struct Residue {
  std::array<std::uint64_t, 4> parts = {0, 0, 0, 0};  ///< each below its prime
  friend auto operator<=>(const Residue&, const Residue&) = default;
};

Residue operator+(const Residue& a, const Residue& b);
Residue operator-(const Residue& a);
Residue operator*(const Residue& a, const Residue& b);
inline Residue operator-(const Residue& a, const Residue& b) { return a + -b; }
/// Requires: invertible(a).
Residue inverse(const Residue& a);
bool invertible(const Residue& a);

/// The part of the first prime alone, up to sign the smaller one: enough to see that two residues differ.
std::uint64_t first_part(const Residue& a);
std::uint64_t first_part_of_difference(const Residue& a, const Residue& b);
/// inverse_part: of b, by first_parts_of_inverses.
std::uint64_t first_part_of_quotient(const Residue& a, std::uint64_t inverse_part);
/// Zero for zero.
std::vector<std::uint64_t> first_parts_of_inverses(std::span<const Residue> all);

/// The decimal that someone typed, see typed_decimal; a number with more digits as the dyadic fraction that it is.
/// Requires: finite.
Residue residue_of(double value);

/// Number `number` of a fixed sequence of random residues.
Residue random_residue(std::uint64_t number);

}  // namespace mbgen
