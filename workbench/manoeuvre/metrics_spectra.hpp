#pragma once
// Fourier transforms, and frequency responses estimated from series.

#include <complex>
#include <vector>

#include "workbench/manoeuvre/metrics_fits.hpp"

namespace mbgen::manoeuvre {

using Complex = std::complex<double>;

/// The least power of two that is not below n.
std::size_t power_of_two(std::size_t n);

/// Fourier transform, sum x[i] exp(-2 pi j i k / n).
std::vector<Complex> transformed(const std::vector<Complex>& x);

/// The inverse, with its factor 1 / n.
std::vector<Complex> transformed_back(const std::vector<Complex>& x);

/// Averages over windows of Hann that overlap by three quarters, their means taken out: of both series and across them.
/// P. D. Welch, IEEE Transactions on Audio and Electroacoustics 15(2), 1967.
struct Spectra {
  double step = 0;       ///< Hz between two lines; the first is at zero
  Values input, output;  ///< per line, to one common factor
  std::vector<Complex> across;
  /// Of the output to the input: least squares of the output's noise.
  Complex response(std::size_t line) const { return across[line] / input[line]; }
  /// Squared coherence, 0 to 1.
  double coherence(std::size_t line) const;
};

/// Requires: width <= size of the series, which are of one size; time_step in s.
Spectra spectra_of(const Values& input, const Values& output, double time_step, std::size_t width);

/// (b0 + b1 s) / (1 + a1 s + a2 s^2).
struct SecondOrder {
  double b0 = 0, b1 = 0, a1 = 0, a2 = 0;
  double left = 0;  ///< root of the mean square of what it leaves, over the response
  double damping() const;
  double natural_frequency() const;  ///< rad/s, undamped; NaN where a2 is not positive
};

/// The second order that is nearest to a frequency response, relative to its size: least squares repeated with the
/// denominator before. Sanathanan and Koerner, IEEE Transactions on Automatic Control 8(1), 1963.
/// omega: rad/s. Requires: at least three points.
SecondOrder second_order(const Values& omega, const std::vector<Complex>& response);

}  // namespace mbgen::manoeuvre
