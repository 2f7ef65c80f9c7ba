// Power spectra against sines and noise of known density, frequency weightings against the standard's table.
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <map>
#include <numbers>
#include <random>

#include "workbench/signals/power_spectrum.hpp"
#include "workbench/signals/weighting.hpp"

namespace mbgen {
namespace {

constexpr double kTwoPi = 2 * std::numbers::pi;

std::vector<double> sine(double amplitude, double frequency, double time_step, std::size_t points) {
  std::vector<double> x;
  for (std::size_t i = 0; i < points; ++i)
    x.push_back(3 + amplitude * std::sin(kTwoPi * frequency * time_step * static_cast<double>(i)));
  return x;
}

// A sine on a line of the spectrum: its mean square stands on that line and, by the Hann window, on its neighbours.
TEST(PowerSpectrum, OfASineIsItsMeanSquare) {
  const double amplitude = 0.8, step = 1.0 / 128;
  const PowerSpectrum spectrum = power_spectrum(sine(amplitude, 5, step, 1024), step, 256);
  ASSERT_EQ(spectrum.density.size(), 129u);
  EXPECT_EQ(spectrum.step, 0.5);
  double sum = 0;
  for (const double density : spectrum.density) sum += density * spectrum.step;
  EXPECT_NEAR(sum, amplitude * amplitude / 2, 1e-12);
  // Coherent gain 1/2, power 3/8: the line has amplitude^2 / 2 * (1/4) / (3/8) of the sum, each neighbour a quarter of
  // it.
  const double line = amplitude * amplitude / 2 * (2.0 / 3) / spectrum.step;
  EXPECT_NEAR(spectrum.density[10], line, 1e-12);
  EXPECT_NEAR(spectrum.density[9], line / 4, 1e-12);
  EXPECT_NEAR(spectrum.density[11], line / 4, 1e-12);
  EXPECT_LT(spectrum.density[0], 1e-25);
  EXPECT_LT(spectrum.density[40], 1e-25);
}

// White noise of the standard deviation s at the rate r has the one-sided density 2 s^2 / r. The mean over k lines of n
// segments deviates by 1 / sqrt(n k), times 1.43 since the Hann window and the overlap by half couple lines and
// segments: 0.9 % here, of which the bound is four.
TEST(PowerSpectrum, OfWhiteNoiseIsFlatAtItsDensity) {
  const double deviation = 0.5, rate = 200;
  std::mt19937 random(5);
  std::normal_distribution<double> normal(2, deviation);
  std::vector<double> x(1 << 17);
  for (double& value : x) value = normal(random);
  const PowerSpectrum spectrum = power_spectrum(x, 1 / rate, 1001);
  const double expected = 2 * deviation * deviation / rate;
  for (const std::size_t from : {2u, 102u, 202u, 302u, 398u}) {
    double mean = 0;
    for (std::size_t k = from; k < from + 100; ++k) mean += spectrum.density[k] / 100;
    EXPECT_NEAR(mean / expected, 1, 0.036) << from;
  }
}

// The definition, summed without a fast transform: an odd number of points, segments that do not fill the series.
TEST(PowerSpectrum, IsItsDefinition) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::vector<double> x(50);
  for (double& value : x) value = uniform(random);
  for (const std::size_t n : {15u, 16u}) {
    const double step = 0.1;
    const PowerSpectrum spectrum = power_spectrum(x, step, n);
    ASSERT_EQ(spectrum.density.size(), n / 2 + 1);
    for (std::size_t k = 0; k <= n / 2; ++k) {
      double sum = 0, count = 0, power = 0;
      for (std::size_t i = 0; i < n; ++i) power += std::pow(0.5 - 0.5 * std::cos(kTwoPi * double(i) / double(n)), 2);
      for (std::size_t begin = 0; begin + n <= x.size(); begin += n - n / 2, ++count) {
        double mean = 0;
        for (std::size_t i = 0; i < n; ++i) mean += x[begin + i] / double(n);
        std::complex<double> line = 0;
        for (std::size_t i = 0; i < n; ++i)
          line += (0.5 - 0.5 * std::cos(kTwoPi * double(i) / double(n))) * (x[begin + i] - mean) *
                  std::polar(1.0, -kTwoPi * double(i * k) / double(n));
        sum += std::norm(line);
      }
      const double sides = k == 0 || 2 * k == n ? 1 : 2;
      EXPECT_NEAR(spectrum.density[k], sides * step * sum / (count * power), 1e-13) << n << " " << k;
    }
  }
}

/// Weighting factors at 10^(n/10) Hz, n from `first` on, with the four digits of the standard: ISO 8041-1:2017, annex
/// B, tables B.2 to B.5, B.7 and B.8, as github.com/jmrplens/phonometry has them beside its tests.
struct Tabulated {
  const char* letter;
  int first;
  std::vector<double> factors;
};

const std::vector<Tabulated> kStandard = {
    {"c", -10, {0.06238, 0.09858, 0.1551,  0.2415,   0.3669,   0.5302,   0.7042,  0.8442, 0.9292, 0.9716,
                0.991,   1.0,     1.006,   1.012,    1.017,    1.023,    1.024,   1.013,  0.9739, 0.8941,
                0.7762,  0.6425,  0.5166,  0.4098,   0.3236,   0.2549,   0.2002,  0.1557, 0.1182, 0.08538,
                0.05665, 0.03394, 0.01868, 0.009772, 0.004987, 0.002518, 0.001266}},
    {"d", -10, {0.06242, 0.09867,  0.1553,   0.242,    0.3682,   0.533,     0.7097,   0.854,   0.9443,  0.9914,
                1.011,   1.007,    0.9707,   0.8913,   0.7733,   0.6398,    0.5143,   0.4081,  0.3226,  0.255,
                0.2017,  0.1597,   0.1266,   0.1004,   0.07958,  0.06299,   0.04965,  0.03872, 0.02946, 0.0213,
                0.01414, 0.008478, 0.004668, 0.002442, 0.001246, 0.0006293, 0.0003164}},
    {"e", -10, {0.06252,  0.09893,  0.156,    0.2435,   0.3715,    0.5394,    0.7198,   0.8635,  0.9389,  0.9423,
                0.8798,   0.7683,   0.6372,   0.5127,   0.407,     0.3218,    0.2543,   0.2012,  0.1594,  0.1263,
                0.1002,   0.07954,  0.06314,  0.05011,  0.03975,   0.03147,   0.02481,  0.01935, 0.01473, 0.01065,
                0.007071, 0.004239, 0.002334, 0.001221, 0.0006232, 0.0003147, 0.0001582}},
    {"f", -17, {0.02407, 0.03803, 0.06021, 0.09619, 0.1575, 0.2675,  0.4537,  0.6951,   0.9,      1.004,   0.9928,
                0.8501,  0.6149,  0.3884,  0.2225,  0.1157, 0.05434, 0.02352, 0.009705, 0.003916, 0.001566}},
    {"j", -10, {0.03099, 0.04897, 0.07703, 0.1199, 0.1821, 0.263,   0.3489, 0.4176, 0.4585, 0.4776,
                0.4844,  0.4851,  0.4832,  0.4819, 0.4889, 0.5246,  0.6251, 0.7948, 0.947,  1.016,
                1.03,    1.026,   1.019,   1.012,  1.006,  1.0,     0.9911, 0.972,  0.9304, 0.8465,
                0.7075,  0.5338,  0.37,    0.2437, 0.1565, 0.09951, 0.06297}},
    {"k", -10, {0.03121, 0.04931, 0.07756, 0.1207,  0.1832,   0.2644,   0.3504,  0.4188, 0.4588, 0.4767,
                0.4825,  0.4846,  0.4935,  0.5308,  0.6335,   0.8071,   0.9648,  1.039,  1.054,  1.037,
                0.9884,  0.8989,  0.7743,  0.6373,  0.5103,   0.4031,   0.316,   0.2451, 0.1857, 0.1339,
                0.08873, 0.05311, 0.02922, 0.01528, 0.007795, 0.003935, 0.001978}}};

TEST(Weighting, HasTheFactorsOfTheStandard) {
  for (const Tabulated& table : kStandard) {
    const Weighting weighting = weighting_of(table.letter).value();
    for (std::size_t i = 0; i < table.factors.size(); ++i) {
      const double frequency = std::pow(10, (table.first + static_cast<int>(i)) / 10.0);
      const double factor = std::abs(weighting_factor(weighting, frequency)), expected = table.factors[i];
      // Half a unit of the fourth digit.
      const double digit = std::pow(10, std::floor(std::log10(expected)) - 3);
      EXPECT_NEAR(factor, expected, 0.5001 * digit) << table.letter << " at " << frequency << " Hz";
    }
  }
  EXPECT_FALSE(weighting_of("x"));
  EXPECT_FALSE(weighting_of(""));
  EXPECT_FALSE(weighting_of("kd"));
}

// A sine of 40 s: away from its ends it is the sine times the factor; its numbers are those of a sine, to its ends.
TEST(Weighting, OfASineIsTheSineTimesTheFactor) {
  const double amplitude = 1.5, step = 2e-3;
  for (const char* letter : {"k", "d", "c", "e", "j"}) {
    const Weighting weighting = weighting_of(letter).value();
    const std::vector<double> x = sine(amplitude, 4, step, 20001);
    const Complex factor = weighting_factor(weighting, 4);
    std::vector<double> centred = x;
    for (double& value : centred) value -= 3;
    const std::vector<double> felt = weighted(centred, step, weighting);
    for (std::size_t i = 5000; i < 15000; i += 37) {
      const double t = step * static_cast<double>(i);
      EXPECT_NEAR(felt[i], amplitude * std::imag(factor * std::polar(1.0, kTwoPi * 4 * t)), 2e-4) << letter;
    }
    const Comfort comfort = comfort_of(x, step, weighting);
    const double felt_amplitude = amplitude * std::abs(factor);
    EXPECT_NEAR(comfort.rms / (felt_amplitude / std::numbers::sqrt2), 1, 0.01) << letter;
    EXPECT_GT(comfort.crest, std::numbers::sqrt2 * 0.99) << letter;
    EXPECT_LT(comfort.crest, 2) << letter;  // the sine begins at once
    EXPECT_NEAR(comfort.dose / (felt_amplitude * std::pow(3.0 / 8 * 40, 0.25)), 1, 0.02) << letter;
    EXPECT_GE(comfort.transient, felt_amplitude / std::numbers::sqrt2 * 0.999) << letter;
  }
}

}  // namespace
}  // namespace mbgen
