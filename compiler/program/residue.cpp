#include "compiler/program/residue.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "compiler/decimal/decimal.hpp"

namespace mbgen {
namespace {

__extension__ typedef unsigned __int128 Wide;

/// The first primes from four random numbers of 61 bits on: the first 61 bits of SHA-256 of "mbgen prime 0" to 3.
constexpr std::uint64_t kPrimes[4] = {2040407225263923611u, 1237463980827930211u, 1801596723558883943u,
                                      1514242856581469813u};

std::uint64_t product(std::uint64_t a, std::uint64_t b, std::uint64_t prime) {
  return static_cast<std::uint64_t>(static_cast<Wide>(a) * b % prime);
}

std::uint64_t power(std::uint64_t base, std::uint64_t exponent, std::uint64_t prime) {
  std::uint64_t result = 1;
  for (; exponent != 0; exponent >>= 1, base = product(base, base, prime))
    if (exponent & 1) result = product(result, base, prime);
  return result;
}

template <class Make>
Residue for_each_prime(const Make& make) {
  Residue result;
  for (std::size_t k = 0; k < result.parts.size(); ++k) result.parts[k] = make(k, kPrimes[k]);
  return result;
}

/// digits base^exponent
Residue scaled(std::uint64_t digits, std::uint64_t base, int exponent) {
  return for_each_prime([&](std::size_t, std::uint64_t prime) {
    const std::uint64_t scale = power(base, static_cast<std::uint64_t>(std::abs(exponent)), prime);
    return product(digits % prime, exponent < 0 ? power(scale, prime - 2, prime) : scale, prime);
  });
}

/// Number `number` of the sequence splitmix64.
std::uint64_t random_word(std::uint64_t number) {
  std::uint64_t word = (number + 1) * 0x9e3779b97f4a7c15u;
  word = (word ^ (word >> 30)) * 0xbf58476d1ce4e5b9u;
  word = (word ^ (word >> 27)) * 0x94d049bb133111ebu;
  return word ^ (word >> 31);
}

}  // namespace

Residue operator+(const Residue& a, const Residue& b) {
  return for_each_prime([&](std::size_t k, std::uint64_t prime) {
    const std::uint64_t sum = a.parts[k] + b.parts[k];
    return sum >= prime ? sum - prime : sum;
  });
}

Residue operator-(const Residue& a) {
  return for_each_prime([&](std::size_t k, std::uint64_t prime) { return a.parts[k] == 0 ? 0 : prime - a.parts[k]; });
}

Residue operator*(const Residue& a, const Residue& b) {
  return for_each_prime([&](std::size_t k, std::uint64_t prime) { return product(a.parts[k], b.parts[k], prime); });
}

bool invertible(const Residue& a) {
  return std::ranges::all_of(a.parts, [](std::uint64_t part) { return part != 0; });
}

// By Fermat: a^(p - 2) a = 1 modulo p.
Residue inverse(const Residue& a) {
  return for_each_prime([&](std::size_t k, std::uint64_t prime) { return power(a.parts[k], prime - 2, prime); });
}

Residue residue_of(double value) {
  constexpr int kBits = 53;
  const double size = std::abs(value);
  if (const std::optional<TypedDecimal> typed = typed_decimal(size)) {
    const Residue result = scaled(static_cast<std::uint64_t>(typed->digits), 10, typed->exponent);
    return value < 0 ? -result : result;
  }
  int exponent = 0;
  const double fraction = std::frexp(size, &exponent);
  const auto digits = static_cast<std::uint64_t>(std::ldexp(fraction, kBits));
  const Residue result = scaled(digits, 2, exponent - kBits);
  return value < 0 ? -result : result;
}

Residue random_residue(std::uint64_t number) {
  return for_each_prime(
      [&](std::size_t k, std::uint64_t prime) { return random_word(std::size(kPrimes) * number + k) % prime; });
}

}  // namespace mbgen
