#pragma once
// Numbers modulo four primes: exact arithmetic of rational numbers that are told apart, not written down. Inside the
// program room.

#include <array>
#include <compare>
#include <cstdint>

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

/// The decimal that someone typed, see typed_decimal; a number with more digits as the dyadic fraction that it is.
/// Requires: finite.
Residue residue_of(double value);

/// Number `number` of a fixed sequence of random residues.
Residue random_residue(std::uint64_t number);

}  // namespace mbgen
