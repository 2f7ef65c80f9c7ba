#include "compiler/program/residue.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "compiler/decimal/decimal.hpp"
#include "compiler/program/mixed_words.hpp"

namespace mbgen {
namespace {

__extension__ typedef unsigned __int128 Wide;

struct Prime {
  std::uint64_t value;
  std::uint64_t reciprocal;  ///< floor(2^122 / value)
};

constexpr Prime prime(std::uint64_t value) { return {value, static_cast<std::uint64_t>((Wide{1} << 122) / value)}; }

/// The first primes from four random numbers of 61 bits on, of SHA-256 of "mbgen prime 0" to 3.
constexpr Prime kPrimes[4] = {prime(kFirstPrime), prime(1237463980827930211u), prime(1801596723558883943u),
                              prime(1514242856581469813u)};

/// Barrett's reduction: the quotient by the reciprocal is at most three too small.
constexpr std::uint64_t product(std::uint64_t a, std::uint64_t b, const Prime& p) {
  const Wide whole = Wide{a} * b;
  const auto quotient = static_cast<std::uint64_t>(((whole >> 60) * p.reciprocal) >> 62);
  auto rest = static_cast<std::uint64_t>(whole) - quotient * p.value;
  while (rest >= p.value) rest -= p.value;
  return rest;
}

constexpr std::uint64_t power(std::uint64_t base, std::uint64_t exponent, const Prime& p) {
  std::uint64_t result = 1;
  for (; exponent != 0; exponent >>= 1, base = product(base, base, p))
    if (exponent & 1) result = product(result, base, p);
  return result;
}

template <class Make>
Residue for_each_prime(const Make& make) {
  Residue result;
  for (std::size_t k = 0; k < result.parts.size(); ++k) result.parts[k] = make(k, kPrimes[k]);
  return result;
}

/// By Fermat: a^(p - 2) a = 1 modulo p.
constexpr std::uint64_t inverse_part(std::uint64_t a, const Prime& p) { return power(a, p.value - 2, p); }

/// A base of numbers with its inverse modulo each prime.
struct Base {
  std::uint64_t value;
  std::uint64_t inverse[4];
};

constexpr Base base(std::uint64_t value) {
  return {value,
          {inverse_part(value, kPrimes[0]), inverse_part(value, kPrimes[1]), inverse_part(value, kPrimes[2]),
           inverse_part(value, kPrimes[3])}};
}

constexpr Base kTwo = base(2), kTen = base(10);

/// digits base^exponent
Residue scaled(std::uint64_t digits, const Base& base, int exponent) {
  const auto size = static_cast<std::uint64_t>(std::abs(exponent));
  return for_each_prime([&](std::size_t k, const Prime& p) {
    return product(digits % p.value, power(exponent < 0 ? base.inverse[k] : base.value, size, p), p);
  });
}

}  // namespace

Residue operator+(const Residue& a, const Residue& b) {
  return for_each_prime([&](std::size_t k, const Prime& p) {
    const std::uint64_t sum = a.parts[k] + b.parts[k];
    return sum >= p.value ? sum - p.value : sum;
  });
}

Residue operator-(const Residue& a) {
  return for_each_prime([&](std::size_t k, const Prime& p) { return a.parts[k] == 0 ? 0 : p.value - a.parts[k]; });
}

Residue operator*(const Residue& a, const Residue& b) {
  return for_each_prime([&](std::size_t k, const Prime& p) { return product(a.parts[k], b.parts[k], p); });
}

bool invertible(const Residue& a) {
  return std::ranges::all_of(a.parts, [](std::uint64_t part) { return part != 0; });
}

Residue inverse(const Residue& a) {
  return for_each_prime([&](std::size_t k, const Prime& p) { return inverse_part(a.parts[k], p); });
}

// One inverse for all: of their product, which is taken apart from its end (P. L. Montgomery 1987).
std::vector<std::uint64_t> first_parts_of_inverses(std::span<const Residue> all) {
  const Prime& p = kPrimes[0];
  std::vector<std::uint64_t> before(all.size());
  std::uint64_t whole = 1;
  for (std::size_t i = 0; i < all.size(); ++i) {
    before[i] = whole;
    if (all[i].parts[0] != 0) whole = product(whole, all[i].parts[0], p);
  }
  std::uint64_t rest = inverse_part(whole, p);
  for (std::size_t i = all.size(); i-- > 0;) {
    if (all[i].parts[0] == 0) {
      before[i] = 0;
      continue;
    }
    before[i] = product(before[i], rest, p);
    rest = product(rest, all[i].parts[0], p);
  }
  return before;
}

std::uint64_t first_part_of_quotient(const Residue& a, std::uint64_t inverse_part) {
  return smaller_of_signs(product(a.parts[0], inverse_part, kPrimes[0]));
}

Residue residue_of(double value) {
  constexpr int kBits = 53;
  const double size = std::abs(value);
  if (const std::optional<TypedDecimal> typed = typed_decimal(size)) {
    const Residue result = scaled(static_cast<std::uint64_t>(typed->digits), kTen, typed->exponent);
    return value < 0 ? -result : result;
  }
  int exponent = 0;
  const double fraction = std::frexp(size, &exponent);
  const auto digits = static_cast<std::uint64_t>(std::ldexp(fraction, kBits));
  const Residue result = scaled(digits, kTwo, exponent - kBits);
  return value < 0 ? -result : result;
}

Residue random_residue(std::uint64_t number) {
  return for_each_prime(
      [&](std::size_t k, const Prime& p) { return random_word(std::size(kPrimes) * number + k) % p.value; });
}

}  // namespace mbgen
