#pragma once
// Fourier transforms.

#include <complex>
#include <vector>

namespace mbgen {

using Complex = std::complex<double>;

/// The least power of two that is not below n.
std::size_t power_of_two(std::size_t n);

/// Fourier transform, sum x[i] exp(-2 pi j i k / n).
std::vector<Complex> transformed(const std::vector<Complex>& x);

/// The inverse, with its factor 1 / n.
std::vector<Complex> transformed_back(const std::vector<Complex>& x);

}  // namespace mbgen
