#pragma once
// Numbers modulo four primes: exact arithmetic of rational numbers that are told apart, not written down. Inside the
// program room.

#include <algorithm>
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

constexpr std::uint64_t kFirstPrime = 2040407225263923611u;

/// The part of the first prime alone, up to sign the smaller one: enough to see that two residues differ.
constexpr std::uint64_t smaller_of_signs(std::uint64_t part) { return std::min(part, kFirstPrime - part); }
constexpr std::uint64_t first_part(const Residue& a) { return smaller_of_signs(a.parts[0]); }
/// Of the sum of two parts of the first prime.
constexpr std::uint64_t first_part_of_sum(std::uint64_t x, std::uint64_t y) {
  return smaller_of_signs(x + y >= kFirstPrime ? x + y - kFirstPrime : x + y);
}
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
