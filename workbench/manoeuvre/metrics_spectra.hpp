#pragma once
// Frequency responses estimated from series.

#include <vector>

#include "workbench/manoeuvre/metrics_fits.hpp"
#include "workbench/signals/fourier.hpp"

namespace mbgen::manoeuvre {

/// Auto- and cross-spectra of two series by Welch's method: Hann windows that overlap by three quarters, without their
/// means. P. D. Welch, IEEE Transactions on Audio and Electroacoustics 15(2), 1967.
struct Spectra {
  double step = 0;       ///< Hz between lines; the first is at zero
  Values input, output;  ///< per line, to one common factor
  std::vector<Complex> across;
  /// Frequency response from input to output: least squares for noise in the output.
  Complex response(std::size_t line) const { return across[line] / input[line]; }
  /// Squared coherence, 0 to 1.
  double coherence(std::size_t line) const;
};

/// Requires: width <= size; series of equal size; time_step in s.
Spectra spectra_of(const Values& input, const Values& output, double time_step, std::size_t width);

/// (b0 + b1 s) / (1 + a1 s + a2 s^2).
struct SecondOrder {
  double b0 = 0, b1 = 0, a1 = 0, a2 = 0;
  double left = 0;  ///< root-mean-square residual, over the response
  double damping() const;
  double natural_frequency() const;  ///< rad/s, undamped; NaN where a2 is not positive
};

/// Second-order model fitted to a frequency response with relative weights: iterated linear least squares with the
/// previous denominator. Sanathanan and Koerner, IEEE Transactions on Automatic Control 8(1), 1963. omega: rad/s.
/// Requires: at least three points.
SecondOrder second_order(const Values& omega, const std::vector<Complex>& response);

}  // namespace mbgen::manoeuvre
