#include "workbench/fit/unit_doubts.hpp"

#include <fmt/format.h>

#include <cmath>

namespace mbgen::fit {
namespace {

/// A factor between units, or signs, and the words for it.
struct UsualFactor {
  double factor;
  const char* words;
};

constexpr UsualFactor kUsual[] = {{57.29577951308232, "are they in degrees?"},
                                  {0.017453292519943295, "is the model's output in degrees, and they are in radians?"},
                                  {1000, "are they in a thousandth of the unit, as mm?"},
                                  {0.001, "are they in a thousand of the unit, as kN?"},
                                  {3.6, "are they in km/h?"},
                                  {1 / 9.80665, "are they in g?"},
                                  {-1, "is their sign another one?"}};
/// Correlation from which data follow the model, and relative distance from a usual factor.
constexpr double kFollows = 0.9, kNearFactor = 0.15;

/// Factor of the data to the model, by the ratio of their deviations; 0 where they do not follow it.
double factor_of(const std::vector<double>& data, const std::vector<double>& model) {
  const double count = static_cast<double>(data.size());
  double mean_data = 0, mean_model = 0, xx = 0, yy = 0, xy = 0;
  for (std::size_t k = 0; k < data.size(); ++k) {
    mean_data += data[k] / count;
    mean_model += model[k] / count;
  }
  for (std::size_t k = 0; k < data.size(); ++k) {
    const double x = model[k] - mean_model, y = data[k] - mean_data;
    xx += x * x;
    yy += y * y;
    xy += x * y;
  }
  if (!(xx > 0 && yy > 0) || std::abs(xy) < kFollows * std::sqrt(xx * yy)) return 0;
  return std::copysign(std::sqrt(yy / xx), xy);
}

}  // namespace

std::vector<std::string> unit_doubts(const FitProblem& problem, const std::vector<double>& values) {
  std::vector<std::string> notes;
  std::vector<bool> is_series(problem.works.size(), false);
  for (const MeasuredFile& file : problem.files)
    for (const MeasuredChannel& measured : file.channels)
      if (!file.is_of_points) is_series[measured.work] = true;
  const std::vector<Outcome> outcomes = outcomes_of(problem, values, Care::quick, [&](const Work& work) {
    return is_series[static_cast<std::size_t>(&work - problem.works.data())];
  });
  for (const MeasuredFile& file : problem.files) {
    if (file.is_of_points) continue;
    for (const MeasuredChannel& measured : file.channels) {
      const Series* series = series_of(outcomes, measured);
      if (series == nullptr) continue;
      const double factor = factor_of(measured.values, predictions(problem, measured, *series, values));
      for (const UsualFactor& usual : kUsual)
        if (std::abs(factor / usual.factor - 1) < kNearFactor)
          notes.push_back(
              fmt::format("{}: note: {} is {:.3g} times the model's at the start values: {} Give the column its unit, "
                          "or the channel "
                          "a gain (--nuisance)\n",
                          file.path + ":1", problem.channels[static_cast<std::size_t>(measured.channel)].column, factor,
                          usual.words));
    }
  }
  return notes;
}

}  // namespace mbgen::fit
