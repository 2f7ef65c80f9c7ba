#pragma once
// Rough roads from their spectrum, with equal bits on every machine.

#include <cstdint>
#include <vector>

namespace mbgen::reading {

/// Samples per shortest wave: the error of the spline is at most 0.3 % of that wave.
constexpr double kSamplesPerWave = 6;

/// A road with the one-sided power spectral density roughness (n / 0.1)^-2, n the wave number in 1/m.
struct RoughRoad {
  double roughness = 0;  ///< m^3, at 0.1 1/m
  std::uint64_t seed = 1;
  double length = 0;                           ///< m, the period
  double coherence = 0;                        ///< of the two tracks at 0.1 1/m, squared; at n raised to n / 0.1
  double longest_wave = 0, shortest_wave = 0;  ///< m
  int count = 0;                               ///< samples per period, at least kSamplesPerWave per wave
};

/// Coefficients of two periodic tracks in the form of Model::samples: a sum of sines with multiples of 1/length as wave
/// numbers and random phases from the seed. Mean and half difference of the tracks are independent. Source: ISO
/// 8608:2016, annex B (classes), with w = 2.
std::vector<double> coefficients_of(const RoughRoad& road);

}  // namespace mbgen::reading
