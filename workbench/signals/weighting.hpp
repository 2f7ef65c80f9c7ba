#pragma once
// Frequency weightings of whole-body vibration, and the numbers of ISO 2631-1 from a weighted acceleration.

#include <optional>
#include <string_view>
#include <vector>

#include "workbench/signals/fourier.hpp"

namespace mbgen {

/// Weightings of ISO 2631-1: k vertical, seated, standing or lying; d horizontal; c at the backrest, along x; e
/// rotation; j vertical, under the head of a lying person; f motion sickness.
enum class Weighting { k, d, c, e, j, f };

/// The weighting of a letter, "k" to "f"; nothing for other texts.
std::optional<Weighting> weighting_of(std::string_view letter);

/// Factor of a weighting at a frequency in Hz: band limits, transition from acceleration to velocity, upward step.
/// Source: ISO 8041-1:2017, 5.6, formulas (1) to (5), table 3.
Complex weighting_factor(Weighting weighting, double frequency);

/// Sampling rate from which a series shows the frequencies with the largest weight, Hz.
double least_rate(Weighting weighting);

/// A series without its mean.
std::vector<double> without_mean(std::vector<double> values);

/// A weighted series. Zeros behind the series keep its end from its begin. time_step: s.
std::vector<double> weighted(const std::vector<double>& values, double time_step, Weighting weighting);

/// Numbers of ISO 2631-1 of a weighted acceleration.
struct Comfort {
  double rms = 0;        ///< weighted acceleration a_w, m/s^2 (6.1)
  double crest = 0;      ///< crest factor (6.2.1); 0 where nothing moves
  double transient = 0;  ///< maximum transient vibration value, m/s^2: largest running rms over 1 s (6.3.1)
  double dose = 0;       ///< fourth power vibration dose value, m/s^1.75 (6.3.2)
};

/// The numbers of an acceleration, whose mean is left out. Requires: at least two points.
Comfort comfort_of(const std::vector<double>& acceleration, double time_step, Weighting weighting);

}  // namespace mbgen
