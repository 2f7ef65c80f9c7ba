// Rough roads of ISO 8608: spectrum and coherence by Welch's method, and their bits.

#include "compiler/formats/rough_road.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <complex>
#include <numbers>

namespace mbgen {
namespace {

using reading::RoughRoad;
using Complex = std::complex<double>;

/// Fourier transform in place. Requires: a power of two.
void transform(std::vector<Complex>& x) {
  const std::size_t n = x.size();
  if (n == 1) return;
  std::vector<Complex> even(n / 2), odd(n / 2);
  for (std::size_t i = 0; i < n / 2; ++i) even[i] = x[2 * i], odd[i] = x[2 * i + 1];
  transform(even);
  transform(odd);
  for (std::size_t i = 0; i < n / 2; ++i) {
    const Complex turned =
        std::polar(1.0, -2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(n)) * odd[i];
    x[i] = even[i] + turned;
    x[i + n / 2] = even[i] - turned;
  }
}

/// Heights of a track at its places, by the spline. side: 0 right, 1 left.
std::vector<double> heights(const std::vector<double>& c, std::size_t side) {
  std::vector<double> z;
  for (std::size_t i = side; i + 8 < c.size() + side; i += 2) z.push_back((c[i] + 4 * c[i + 2] + c[i + 4]) / 6);
  return z;
}

/// One-sided densities, m^3, over wave numbers: of two signals and across them.
struct Spectra {
  std::vector<double> number, right, left;
  std::vector<Complex> across;
};

/// By P. D. Welch, "The use of fast Fourier transform for the estimation of power spectra", IEEE Transactions on Audio
/// and Electroacoustics 15(2), 1967: windows of Hann that overlap by half.
Spectra welch(const RoughRoad& road) {
  constexpr std::size_t kSegment = 4096;
  const std::vector<double> c = coefficients_of(road), right = heights(c, 0), left = heights(c, 1);
  const double spacing = road.length / road.count, width = spacing * kSegment;
  Spectra s{std::vector<double>(kSegment / 2), std::vector<double>(kSegment / 2), std::vector<double>(kSegment / 2),
            std::vector<Complex>(kSegment / 2)};
  double segments = 0;
  for (std::size_t begin = 0; begin + kSegment <= right.size(); begin += kSegment / 2, ++segments) {
    const auto spectrum = [&](const std::vector<double>& z) {
      std::vector<Complex> x(kSegment);
      for (std::size_t i = 0; i < kSegment; ++i)
        x[i] = z[begin + i] * std::pow(std::sin(std::numbers::pi * static_cast<double>(i) / kSegment), 2);
      transform(x);
      return x;
    };
    const std::vector<Complex> r = spectrum(right), l = spectrum(left);
    for (std::size_t k = 0; k < kSegment / 2; ++k) {
      s.right[k] += std::norm(r[k]);
      s.left[k] += std::norm(l[k]);
      s.across[k] += std::conj(r[k]) * l[k];
    }
  }
  const double factor = 2 * spacing / (0.375 * kSegment * segments);  // 0.375: mean square of the window
  for (std::size_t k = 0; k < kSegment / 2; ++k) {
    s.number[k] = static_cast<double>(k) / width;
    s.right[k] *= factor, s.left[k] *= factor, s.across[k] *= factor;
  }
  return s;
}

RoughRoad road_of(double roughness, std::uint64_t seed, double coherence) {
  return {roughness, seed, 1000, coherence, 90, 0.35, static_cast<int>(6 * 1000 / 0.35)};
}

/// Calls check(mean wave number, mean of right * (n / 0.1)^2, of left, squared coherence) for each third of an octave
/// with at least 8 lines.
template <class Check>
void for_bands(const Spectra& s, const Check& check) {
  for (double low = 0.02; low < 2.5; low *= std::cbrt(2.0)) {
    double right = 0, left = 0, number = 0, lines = 0, rr = 0, ll = 0;
    Complex across = 0;
    for (std::size_t k = 0; k < s.number.size(); ++k) {
      if (s.number[k] < low || s.number[k] >= low * std::cbrt(2.0)) continue;
      const double flat = std::pow(s.number[k] / 0.1, 2);
      right += flat * s.right[k], left += flat * s.left[k], number += s.number[k], ++lines;
      rr += flat * s.right[k], ll += flat * s.left[k], across += flat * s.across[k];
    }
    if (lines >= 8) check(number / lines, right / lines, left / lines, std::norm(across) / (rr * ll));
  }
}

// The band of a class is its geometric mean, by two and times two. Source: ISO 8608, table C.1.
TEST(RoughRoad, HasTheSpectrumOfItsClass) {
  for (const auto& [mean_of_class, seed_of_road] : {std::pair(16e-6, 1), {256e-6, 2}, {16e-6 * 16384, 77}}) {
    const double mean = mean_of_class;
    const int seed = seed_of_road;
    int bands = 0;
    for_bands(welch(road_of(mean, static_cast<std::uint64_t>(seed), 0.5)),
              [&](double number, double right, double left, double) {
                ++bands;
                for (const double density : {right, left}) {
                  EXPECT_GT(density, mean / 2) << number << " 1/m, seed " << seed;
                  EXPECT_LT(density, mean * 2) << number << " 1/m, seed " << seed;
                }
              });
    EXPECT_GT(bands, 10);
  }
}

TEST(RoughRoad, TracksAreAsCoherentAsAsked) {
  for (const double coherence : {0.0, 0.2, 0.7, 1.0}) {
    double worst = 0;
    for_bands(welch(road_of(64e-6, 5, coherence)), [&](double number, double, double, double measured) {
      worst = std::max(worst, std::abs(measured - std::pow(coherence, number / 0.1)));
    });
    EXPECT_LT(worst, 0.12) << coherence;
  }
}

// FNV-1a over the bits: the same on every machine.
TEST(RoughRoad, HasTheSameBitsEverywhere) {
  std::uint64_t hash = 0xcbf29ce484222325u;
  for (const double c : coefficients_of(RoughRoad{256e-6, 1, 250, 0.5, 90, 0.35, 4286})) {
    const auto bits = std::bit_cast<std::uint64_t>(c);
    for (int byte = 0; byte < 8; ++byte) hash = (hash ^ (bits >> 8 * byte & 0xff)) * 0x100000001b3u;
  }
  EXPECT_EQ(hash, 0xa1a91a3671d06c05u);
}

}  // namespace
}  // namespace mbgen
