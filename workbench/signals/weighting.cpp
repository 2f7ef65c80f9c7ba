#include "workbench/signals/weighting.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

namespace mbgen {
namespace {

/// A row of table 3 of ISO 8041-1; zero frequencies are infinite ones.
struct Parameters {
  double high, low;               ///< f1, f2
  double lead, lag, lag_q;        ///< f3, f4, Q4
  double from, from_q, to, to_q;  ///< f5, Q5, f6, Q6
  double least_rate;              ///< Hz
};

/// In the order of Weighting.
constexpr std::array<Parameters, 6> kTable = {{
    {0.4, 100, 12.5, 12.5, 0.63, 2.37, 0.91, 3.35, 0.91, 50},
    {0.4, 100, 2, 2, 0.63, 0, 1, 0, 1, 20},
    {0.4, 100, 8, 8, 0.63, 0, 1, 0, 1, 50},
    {0.4, 100, 1, 1, 0.63, 0, 1, 0, 1, 20},
    {0.4, 100, 0, 0, 1, 3.75, 0.91, 5.32, 0.91, 100},
    {0.08, 0.63, 0, 0.25, 0.86, 0.0625, 0.80, 0.10, 0.80, 4},
}};

constexpr const char* kLetters = "kdcejf";
constexpr double kButterworth = std::numbers::sqrt2 / 2;
constexpr double kRunning = 1;  ///< s, of the running root mean square

/// 1 + s / (q w) + s^2 / w^2, w of a frequency in Hz.
Complex second_order(Complex s, double frequency, double q) {
  const Complex ratio = s / (2 * std::numbers::pi * frequency);
  return 1.0 + ratio / q + ratio * ratio;
}

/// Mean of the squares by the trapezoidal rule.
double mean_square(const std::vector<double>& x, std::size_t begin, std::size_t end) {
  double sum = 0;
  for (std::size_t i = begin + 1; i < end; ++i) sum += (x[i - 1] * x[i - 1] + x[i] * x[i]) / 2;
  return sum / static_cast<double>(end - begin - 1);
}

/// The largest running root mean square.
double largest_running(const std::vector<double>& x, double time_step) {
  const auto steps = std::max<std::size_t>(1, static_cast<std::size_t>(std::lround(kRunning / time_step)));
  if (x.size() <= steps) return std::sqrt(mean_square(x, 0, x.size()));
  const auto area = [&](std::size_t i) { return (x[i - 1] * x[i - 1] + x[i] * x[i]) / 2; };
  double sum = 0, most = 0;
  for (std::size_t i = 1; i < x.size(); ++i) {
    sum += area(i);
    if (i > steps) sum -= area(i - steps);
    if (i >= steps) most = std::max(most, sum);
  }
  return std::sqrt(most / static_cast<double>(steps));
}

}  // namespace

std::optional<Weighting> weighting_of(std::string_view letter) {
  const std::size_t place = letter.size() == 1 ? std::string_view(kLetters).find(letter) : std::string_view::npos;
  return place == std::string_view::npos ? std::nullopt : std::optional(static_cast<Weighting>(place));
}

Complex weighting_factor(Weighting weighting, double frequency) {
  const Parameters& p = kTable[static_cast<std::size_t>(weighting)];
  const Complex s(0, 2 * std::numbers::pi * frequency);
  const Complex high = s / (2 * std::numbers::pi * p.high);
  Complex factor = high * high / second_order(s, p.high, kButterworth) / second_order(s, p.low, kButterworth);
  if (p.lead > 0) factor *= 1.0 + s / (2 * std::numbers::pi * p.lead);
  if (p.lag > 0) factor /= second_order(s, p.lag, p.lag_q);
  if (p.from > 0) {
    const double ratio = p.from / p.to;
    factor *= second_order(s, p.from, p.from_q) / second_order(s, p.to, p.to_q) * ratio * ratio;
  }
  return factor;
}

double least_rate(Weighting weighting) { return kTable[static_cast<std::size_t>(weighting)].least_rate; }

std::vector<double> weighted(const std::vector<double>& values, double time_step, Weighting weighting) {
  std::vector<Complex> x(power_of_two(2 * values.size()));
  std::copy(values.begin(), values.end(), x.begin());
  x = transformed(x);
  const std::size_t half = x.size() / 2;
  const double line = 1 / (time_step * static_cast<double>(x.size()));
  for (std::size_t k = 0; k <= half; ++k) {
    x[k] *= weighting_factor(weighting, line * static_cast<double>(k));
    if (k > 0 && k < half) x[x.size() - k] = std::conj(x[k]);
  }
  x[half] = x[half].real();
  x = transformed_back(x);
  std::vector<double> result;
  for (std::size_t i = 0; i < values.size(); ++i) result.push_back(x[i].real());
  return result;
}

std::vector<double> without_mean(std::vector<double> values) {
  const double mean = std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
  for (double& value : values) value -= mean;
  return values;
}

Comfort comfort_of(const std::vector<double>& acceleration, double time_step, Weighting weighting) {
  const std::vector<double> felt = weighted(without_mean(acceleration), time_step, weighting);
  Comfort comfort;
  comfort.rms = std::sqrt(mean_square(felt, 0, felt.size()));
  double most = 0, fourth = 0;
  for (std::size_t i = 0; i < felt.size(); ++i) {
    most = std::max(most, std::abs(felt[i]));
    if (i > 0) fourth += (std::pow(felt[i - 1], 4) + std::pow(felt[i], 4)) / 2;
  }
  if (comfort.rms > 0) comfort.crest = most / comfort.rms;
  comfort.transient = largest_running(felt, time_step);
  comfort.dose = std::pow(fourth * time_step, 0.25);
  return comfort;
}

}  // namespace mbgen
