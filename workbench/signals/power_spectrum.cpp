#include "workbench/signals/power_spectrum.hpp"

#include <cmath>
#include <numbers>
#include <numeric>

#include "workbench/signals/fourier.hpp"

namespace mbgen {

PowerSpectrum power_spectrum(const std::vector<double>& values, double time_step, std::size_t points) {
  const auto n = static_cast<double>(points);
  std::vector<double> window(points);
  double power = 0;
  for (std::size_t i = 0; i < points; ++i) {
    const double sine = std::sin(std::numbers::pi * static_cast<double>(i) / n);
    window[i] = sine * sine;
    power += window[i] * window[i];
  }
  PowerSpectrum spectrum{1 / (time_step * n), std::vector<double>(points / 2 + 1)};
  const std::size_t hop = points - points / 2;
  double segments = 0;
  for (std::size_t begin = 0; begin + points <= values.size(); begin += hop, ++segments) {
    const auto first = values.begin() + static_cast<std::ptrdiff_t>(begin);
    const double mean = std::accumulate(first, first + static_cast<std::ptrdiff_t>(points), 0.0) / n;
    std::vector<Complex> x(points);
    for (std::size_t i = 0; i < points; ++i) x[i] = window[i] * (values[begin + i] - mean);
    x = transformed(x);
    for (std::size_t k = 0; k < spectrum.density.size(); ++k) spectrum.density[k] += std::norm(x[k]);
  }
  for (std::size_t k = 0; k < spectrum.density.size(); ++k) {
    const bool is_single = k == 0 || 2 * k == points;  // without a line at the negative frequency
    spectrum.density[k] *= (is_single ? 1 : 2) * time_step / (power * segments);
  }
  return spectrum;
}

}  // namespace mbgen
