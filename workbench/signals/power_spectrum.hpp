#pragma once
// Power spectral density of a series.

#include <vector>

namespace mbgen {

/// One-sided density over frequency.
struct PowerSpectrum {
  double step = 0;              ///< Hz from one line to the next; the first is at zero
  std::vector<double> density;  ///< unit of the values squared, over Hz
};

/// Density by Welch's method: segments of `points` that overlap by half, each without its mean and under a periodic
/// Hann window, their squared transforms averaged. Scaled such that the sum of density times step is the mean square of
/// the segments without their means. P. D. Welch, IEEE Transactions on Audio and Electroacoustics 15(2), 1967.
/// time_step: s. Requires: 2 <= points <= values.size().
PowerSpectrum power_spectrum(const std::vector<double>& values, double time_step, std::size_t points);

}  // namespace mbgen
