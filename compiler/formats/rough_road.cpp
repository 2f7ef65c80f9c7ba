#include "compiler/formats/rough_road.hpp"

#include <array>
#include <cmath>
#include <cstddef>

namespace mbgen::reading {
namespace {

constexpr double kReference = 0.1;  // 1/m
constexpr double kTwoPi = 6.283185307179586;

/// Next number of a sequence. Source: G. L. Steele, D. Lea, C. H. Flood, "Fast Splittable Pseudorandom Number
/// Generators", OOPSLA 2014.
std::uint64_t next(std::uint64_t& state) {
  std::uint64_t z = state += 0x9e3779b97f4a7c15u;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return z ^ (z >> 31);
}

/// cos x (step 1) or sin x / x (step 2) by Taylor series; z = x^2. With explicit fused operations: sines differ between
/// libraries, fused operations between compilers.
double series(double z, int step) {
  constexpr int kTerms = 11;  // beyond them 1e-20 for angles up to pi/4
  double sum = 0;
  for (int k = kTerms; k > 0; --k) {
    const double below = 1.0 / ((2 * k + step - 2) * (2 * k + step - 1));
    sum = std::fma(-(z * below), sum, 1.0);
  }
  return sum;
}

/// base^exponent, 0 <= base <= 1, exponent >= 0, by square roots, which are exact to the bit everywhere.
double power(double base, double exponent) {
  if (base == 0) return exponent == 0 ? 1 : 0;
  double result = 1;
  for (; exponent >= 1; exponent -= 1) result *= base;
  for (double root = std::sqrt(base); exponent > 0 && root < 1; root = std::sqrt(root)) {
    exponent *= 2;
    if (exponent < 1) continue;
    result *= root;
    exponent -= 1;
  }
  return result;
}

/// cos(2 pi place / count), 0 <= place < count.
double cosine_of(int place, int count) {
  std::int64_t eighths = 8 * static_cast<std::int64_t>(place);  // of a turn, times count
  if (eighths > 4LL * count) eighths = 8LL * count - eighths;
  const double sign = eighths > 2LL * count ? -1 : 1;
  if (sign < 0) eighths = 4LL * count - eighths;
  const bool is_steep = eighths > count;
  if (is_steep) eighths = 2LL * count - eighths;
  const double angle = kTwoPi * (static_cast<double>(eighths) / (8.0 * count));
  const double value = is_steep ? angle * series(angle * angle, 2) : series(angle * angle, 1);
  return sign * value;
}

}  // namespace

std::vector<double> coefficients_of(const RoughRoad& road) {
  const auto count = static_cast<std::size_t>(road.count);
  std::vector<double> cosine(count);
  for (std::size_t i = 0; i < count; ++i) cosine[i] = cosine_of(static_cast<int>(i), road.count);
  std::vector<std::array<double, 2>> sums(count);  // of the mean and of the half difference
  std::uint64_t state = road.seed;
  const auto first = static_cast<std::size_t>(std::ceil(road.length / road.longest_wave));
  const auto last = static_cast<std::size_t>(std::floor(road.length / road.shortest_wave));
  for (std::size_t k = first; k <= last; ++k) {
    const double number = static_cast<double>(k) / road.length;  // 1/m
    const double ratio = kReference / number;
    const double square = 2 * road.roughness * (ratio * ratio) / road.length;
    // Spline coefficients of a sine are the sine times this factor.
    const double amplitude = std::sqrt(square) * (3 / (2 + cosine[k]));
    const double alike = power(road.coherence, 0.5 * number / kReference);
    const std::array<double, 2> share = {amplitude * std::sqrt((1 + alike) / 2),
                                         amplitude * std::sqrt((1 - alike) / 2)};
    for (std::size_t part = 0; part < 2; ++part) {
      std::size_t place = next(state) % count;
      for (std::size_t i = 0; i < count; ++i) {
        sums[i][part] = std::fma(share[part], cosine[place], sums[i][part]);
        place += k;
        if (place >= count) place -= count;
      }
    }
  }
  std::vector<double> coefficients;
  coefficients.reserve(2 * (count + 4));
  for (std::size_t i = 0; i < count + 4; ++i) {
    const auto& [mean, half] = sums[(i + count - 1) % count];
    coefficients.push_back(mean - half);
    coefficients.push_back(mean + half);
  }
  return coefficients;
}

}  // namespace mbgen::reading
