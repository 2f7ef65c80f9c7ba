// Frequency response to the steering angle, ISO 7401.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "workbench/manoeuvre/metrics_spectra.hpp"

namespace mbgen {
namespace {

using namespace manoeuvre;

constexpr double kLeastPower = 1e-3;   ///< of the strongest line of the steer angle
constexpr double kLongestWindow = 20;  ///< s, of a default window
constexpr double kShortestWindow = 8;  ///< s
constexpr double kSlow = 0.5;          ///< Hz: range of the extrapolation of the gain to zero frequency
constexpr double kLeastCoherence = 0.9;
constexpr double kLatestStart = 0.25;  ///< Hz: no extrapolation to zero frequency from a higher lowest line
constexpr double kLeastPeak = 1.01;    ///< of the steady gain
constexpr double kWorstFit = 0.05;     ///< of the response: residual of the second-order model
constexpr double kAtRest = 0.02;       ///< of the spread of values: largest first value of a series from rest
constexpr double kRestAtEnd = 0.5;     ///< s at the end, all of which are as small
constexpr double kHighestOfFit = 3;    ///< Hz: roll and tyres make the response of higher order beyond

/// A response over its frequencies.
struct FrequencyResponse {
  Values frequency, gain, phase;  ///< Hz; output per rad; rad, without jumps
  std::vector<Complex> value;
  double sign = 1;  ///< -1: slow steering to the left turns to the right; gain and phase have the opposite sign
};

/// Whether values are small all over a span of their begin or end.
bool is_at_rest(const Values& values, Span span) {
  return largest(values, span) <= kAtRest * spread(values, {0, values.size()}, 0);
}

bool begins_at_rest(const Values& values) { return is_at_rest(values, {0, 1}); }

bool ends_at_rest(const Values& values, double time_step) {
  const auto count = static_cast<std::size_t>(kRestAtEnd / time_step) + 1;
  return is_at_rest(values, {values.size() - std::min(count, values.size()), values.size()});
}

/// Spectra of two series. Where both begin or end at rest, rest is added, so that all windows cover it: a sweep is slow
/// at its begin, and its fastest sines are those of its end.
Spectra spectra_with_rest(const Values& input, const Values& output, double time_step, std::size_t width) {
  const std::size_t before = begins_at_rest(input) && begins_at_rest(output) ? width : 0;
  const std::size_t behind = ends_at_rest(input, time_step) && ends_at_rest(output, time_step) ? width : 0;
  const auto with_rest = [&](const Values& values) {
    Values longer(before, 0.0);
    longer.insert(longer.end(), values.begin(), values.end());
    longer.resize(longer.size() + behind, 0.0);
    return longer;
  };
  return spectra_of(with_rest(input), with_rest(output), time_step, width);
}

/// Lines within the band of the steer angle.
Span excited_lines(const Spectra& spectra, const SineSweep& asked, double segment) {
  const double strongest = *std::max_element(spectra.input.begin(), spectra.input.end());
  // At least two lines from zero: the window's main lobe then does not reach negative frequencies.
  const double lowest = std::max(asked.lowest, 2 / segment) * (1 - 1e-9);
  const auto frequency = [&](std::size_t k) { return spectra.step * static_cast<double>(k); };
  const auto is_excited = [&](std::size_t k) { return spectra.input[k] >= kLeastPower * strongest; };
  Span lines;
  while (lines.begin < spectra.input.size() && (frequency(lines.begin) < lowest || !is_excited(lines.begin)))
    ++lines.begin;
  lines.end = lines.begin;
  while (lines.end < spectra.input.size() && is_excited(lines.end) &&
         (asked.highest <= 0 || frequency(lines.end) <= asked.highest))
    ++lines.end;
  return lines;
}

/// Response at the lines of the steer angle, up to the first line without coherence.
FrequencyResponse followed_response(VehicleMetrics& metrics, const std::string& name, const Spectra& spectra,
                                    Span lines) {
  FrequencyResponse response;
  if (lines.size() == 0) metrics.notes.push_back(name + ": the steer angle holds no frequency of the range");
  for (std::size_t k = lines.begin; k < lines.end; ++k) {
    const double frequency = spectra.step * static_cast<double>(k), coherence = spectra.coherence(k);
    if (coherence < kLeastCoherence) {
      metrics.notes.push_back(fmt::format(
          "{}: its coherence with the steer angle is {:.2f} at {:.3g} Hz, below {:.2g}; {}", name, coherence, frequency,
          kLeastCoherence,
          response.value.empty() ? "no frequency response"
                                 : fmt::format("the response ends at {:.3g} Hz", response.frequency.back())));
      break;
    }
    if (response.value.empty()) response.sign = sign_of(spectra.response(k).real());
    response.frequency.push_back(frequency);
    response.value.push_back(response.sign * spectra.response(k));
    response.gain.push_back(std::abs(response.value.back()));
    double phase = std::arg(response.value.back());
    const double turn = 2 * std::numbers::pi;
    if (!response.phase.empty()) phase += turn * std::round((response.phase.back() - phase) / turn);
    response.phase.push_back(phase);
  }
  return response;
}

/// Gain at zero frequency, extrapolated from slow lines by a + b f^2 + c f^4.
std::optional<double> steady_gain(const FrequencyResponse& response) {
  Values squares, gains;
  for (std::size_t i = 0; i < response.gain.size() && response.frequency[i] <= kSlow; ++i) {
    squares.push_back(response.frequency[i] * response.frequency[i]);
    gains.push_back(response.gain[i]);
  }
  if (gains.size() < 4 || response.frequency.front() > kLatestStart) return std::nullopt;
  return polynomial(squares, gains, 2).front();
}

/// First frequency beyond which the gain is below a value; none if it does not fall so far.
std::optional<double> fall_below(const FrequencyResponse& response, double gain) {
  for (std::size_t i = 1; i < response.gain.size(); ++i) {
    const double before = response.gain[i - 1], after = response.gain[i];
    if (before < gain || after >= gain) continue;
    return response.frequency[i - 1] +
           (response.frequency[i] - response.frequency[i - 1]) * (before - gain) / (before - after);
  }
  return std::nullopt;
}

void add_gains(VehicleMetrics& metrics, const std::string& name, const std::string& words, const std::string& unit,
               const FrequencyResponse& response) {
  const std::optional<double> steady = steady_gain(response);
  if (!steady) {
    metrics.notes.push_back(
        fmt::format("{}_gain: the response begins at {:.3g} Hz with {} lines, too high to tell of "
                    "slow steering; so bandwidth and peak are not known either",
                    name, response.frequency.front(), response.frequency.size()));
    return;
  }
  add(metrics, name + "_gain", response.sign * *steady, unit, words + " over steer angle at slow steering (ISO 7401)");
  const double limit = *steady / std::numbers::sqrt2;
  if (const std::optional<double> bandwidth = fall_below(response, limit)) {
    add(metrics, name + "_bandwidth", *bandwidth, "Hz", "where the gain is 3 dB below the gain of slow steering");
  } else {
    metrics.notes.push_back(
        fmt::format("{}_bandwidth: the gain is not 3 dB below the gain of slow steering up to {:.3g} Hz", name,
                    response.frequency.back()));
  }
  const Peak peak = peak_of(response.frequency, response.gain, 0);
  const bool is_inside = peak.time < response.frequency.back();
  if (peak.value > kLeastPeak * *steady && is_inside) {
    add(metrics, name + "_peak_ratio", peak.value / *steady, "1", "largest gain, divided by the gain of slow steering");
    add(metrics, name + "_peak_frequency", peak.time, "Hz", "of the largest gain");
  } else {
    metrics.notes.push_back(fmt::format("{}_peak_ratio: {}", name,
                                        is_inside ? "no gain is 1 % above the gain of slow steering"
                                                  : fmt::format("the gain still grows at {:.3g} Hz", peak.time)));
  }
}

void add_phase(VehicleMetrics& metrics, const std::string& name, const std::string& words,
               const FrequencyResponse& response) {
  const double phase = interpolated(response.frequency, response.phase, 1);
  if (std::isnan(phase)) {
    metrics.notes.push_back(fmt::format("{}_phase_1hz: the response goes from {:.3g} to {:.3g} Hz", name,
                                        response.frequency.front(), response.frequency.back()));
    return;
  }
  add(metrics, name + "_phase_1hz", phase, "rad", "phase of " + words + " to steer angle at 1 Hz (ISO 7401)");
  add(metrics, name + "_delay_1hz", -phase / (2 * std::numbers::pi), "s", "delay that gives this phase at 1 Hz");
}

void add_damping(VehicleMetrics& metrics, const FrequencyResponse& response) {
  Values omega;
  for (const double frequency : response.frequency)
    if (frequency <= kHighestOfFit) omega.push_back(2 * std::numbers::pi * frequency);
  if (omega.size() < 6) return metrics.notes.push_back("yaw_damping: fewer than six lines of the yaw rate's response");
  const SecondOrder fit =
      second_order(omega, {response.value.begin(), response.value.begin() + static_cast<std::ptrdiff_t>(omega.size())});
  if (!(fit.left < kWorstFit) || !(fit.a2 > 0)) {
    metrics.notes.push_back(fmt::format(
        "yaw_damping: a second order leaves {:.2g} of the yaw rate's response: no damping to speak of", fit.left));
    return;
  }
  add(metrics, "yaw_damping", fit.damping(), "1", "ratio of the second order that fits the yaw rate's response");
  add(metrics, "yaw_natural_frequency", fit.natural_frequency() / (2 * std::numbers::pi), "Hz",
      "undamped, of the same second order");
}

void add_response_diagrams(VehicleMetrics& metrics, const FrequencyResponse& yaw, const FrequencyResponse& lateral) {
  const Heading across{"frequency", "Hz"};
  const auto picture = [&](const std::string& title, const Heading& up, const FrequencyResponse& of,
                           const Values& values) {
    metrics.diagrams.push_back({title, across, up, {{title, of.frequency, values}}});
  };
  picture("Gain of the yaw rate", {"gain", "1/s"}, yaw, yaw.gain);
  picture("Gain of the lateral acceleration", {"gain", "(m/s^2)/rad"}, lateral, lateral.gain);
  metrics.diagrams.push_back(
      {"Phase to the steer angle",
       across,
       {"phase", "rad"},
       {{"yaw rate", yaw.frequency, yaw.phase}, {"lateral acceleration", lateral.frequency, lateral.phase}}});
}

}  // namespace

VehicleMetrics sine_sweep_metrics(const VehicleSeries& s, const SineSweep& asked) {
  std::string fault = fault_of(s, {{"speed", &s.speed},
                                   {"lateral acceleration", &s.lateral_acceleration},
                                   {"yaw rate", &s.yaw_rate},
                                   {"steer angle", &s.steer}});
  const double duration = fault.empty() ? s.t.back() - s.t.front() : 0;
  const double segment = asked.segment > 0 ? asked.segment : std::min(kLongestWindow, duration / 3);
  if (fault.empty() && (segment < kShortestWindow || 2 * segment > duration)) {
    fault =
        fmt::format("the series lasts {:.4g} s; windows of {:.4g} s are too short or too few: drive {:.4g} s at least",
                    duration, segment, std::max(3 * kShortestWindow, 2 * asked.segment));
  }
  if (fault.empty() && !(largest(s.steer) > 0)) fault = "the steer angle is zero";
  if (!fault.empty()) return refused("frequency response", fault);
  VehicleMetrics metrics;
  const auto width = static_cast<std::size_t>(segment / step_of(s));
  const auto response = [&](const std::string& name, const Values& values) {
    const Spectra spectra = spectra_with_rest(s.steer, values, step_of(s), width);
    if (begins_at_rest(s.steer) && begins_at_rest(values) &&
        !(ends_at_rest(s.steer, step_of(s)) && ends_at_rest(values, step_of(s))))
      metrics.notes.push_back(
          name +
          ": the series ends before its response dies out: numbers of the frequencies at its end, such as a "
          "bandwidth there, are not exact");
    return followed_response(metrics, name, spectra, excited_lines(spectra, asked, segment));
  };
  add(metrics, "speed", mean(s.speed, {0, s.t.size()}), "m/s", "mean");
  const FrequencyResponse yaw = response("yaw_rate", s.yaw_rate);
  const FrequencyResponse lateral = response("lateral_acceleration", s.lateral_acceleration);
  if (!yaw.value.empty()) {
    add_gains(metrics, "yaw_rate", "yaw rate", "1/s", yaw);
    add_phase(metrics, "yaw_rate", "yaw rate", yaw);
    add_damping(metrics, yaw);
  }
  if (!lateral.value.empty()) {
    add_gains(metrics, "lateral_acceleration", "lateral acceleration", "(m/s^2)/rad", lateral);
    add_phase(metrics, "lateral_acceleration", "lateral acceleration", lateral);
  }
  if (!yaw.value.empty() && !lateral.value.empty()) add_response_diagrams(metrics, yaw, lateral);
  return metrics;
}

}  // namespace mbgen
