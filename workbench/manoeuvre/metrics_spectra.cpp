#include "workbench/manoeuvre/metrics_spectra.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "compiler/algebra/dense.hpp"

namespace mbgen::manoeuvre {

double Spectra::coherence(std::size_t line) const {
  const double both = input[line] * output[line];
  return both > 0 ? std::norm(across[line]) / both : 0;
}

Spectra spectra_of(const Values& input, const Values& output, double time_step, std::size_t width) {
  const std::size_t lines = power_of_two(width), hop = std::max<std::size_t>(width / 4, 1);
  Spectra s{1 / (time_step * static_cast<double>(lines)), Values(lines / 2), Values(lines / 2),
            std::vector<Complex>(lines / 2)};
  const auto windowed = [&](const Values& values, std::size_t begin) {
    const double middle = mean(values, {begin, begin + width});
    std::vector<Complex> x(lines);
    for (std::size_t i = 0; i < width; ++i) {
      const double sine = std::sin(std::numbers::pi * (static_cast<double>(i) + 0.5) / static_cast<double>(width));
      x[i] = (values[begin + i] - middle) * sine * sine;
    }
    return transformed(x);
  };
  for (std::size_t begin = 0; begin + width <= input.size(); begin += hop) {
    const std::vector<Complex> in = windowed(input, begin), out = windowed(output, begin);
    for (std::size_t k = 0; k < lines / 2; ++k) {
      s.input[k] += std::norm(in[k]);
      s.output[k] += std::norm(out[k]);
      s.across[k] += std::conj(in[k]) * out[k];
    }
  }
  return s;
}

double SecondOrder::natural_frequency() const { return 1 / std::sqrt(a2); }
double SecondOrder::damping() const { return a1 / (2 * std::sqrt(a2)); }

SecondOrder second_order(const Values& omega, const std::vector<Complex>& response) {
  SecondOrder fit;
  const auto rows = static_cast<Eigen::Index>(2 * omega.size());
  const auto denominator = [&](double w) { return Complex(1 - fit.a2 * w * w, fit.a1 * w); };
  for (int round = 0; round < 20; ++round) {
    // b0 + b1 s - H (a1 s + a2 s^2) = H, real and imaginary part.
    Eigen::MatrixXd matrix(rows, 4), right(rows, 1);
    for (std::size_t i = 0; i < omega.size(); ++i) {
      const Complex s(0, omega[i]), h = response[i];
      const double weight = 1 / (std::abs(h) * std::abs(denominator(omega[i])));
      const Complex row[] = {1, s, -h * s, -h * s * s};
      const auto at = static_cast<Eigen::Index>(2 * i);
      for (int c = 0; c < 4; ++c) matrix(at, c) = weight * row[c].real(), matrix(at + 1, c) = weight * row[c].imag();
      right(at, 0) = weight * h.real(), right(at + 1, 0) = weight * h.imag();
    }
    const Eigen::MatrixXd c = overdetermined_solution(matrix, right);
    fit = {c(0, 0), c(1, 0), c(2, 0), c(3, 0)};
  }
  double sum = 0;
  for (std::size_t i = 0; i < omega.size(); ++i) {
    const Complex value = Complex(fit.b0, fit.b1 * omega[i]) / denominator(omega[i]);
    sum += std::norm(value / response[i] - 1.0);
  }
  fit.left = std::sqrt(sum / static_cast<double>(omega.size()));
  return fit;
}

}  // namespace mbgen::manoeuvre
