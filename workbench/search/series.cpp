#include "workbench/search/series.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace mbgen {
namespace {

/// Slope at point k by the parabola or quartic through its neighbours: of Lagrange's polynomial through all points from
/// first to last.
double slope_at(const Series& series, std::size_t k) {
  const std::size_t count = series.at.size();
  const std::size_t reach = std::min({k, count - 1 - k, std::size_t{2}});
  const std::size_t first = reach > 0 ? k - reach : (k == 0 ? 0 : k - std::min<std::size_t>(2, k));
  const std::size_t last = reach > 0 ? k + reach : std::min(count - 1, first + 2);
  const double x = series.at[k];
  double slope = 0;
  for (std::size_t i = first; i <= last; ++i) {
    double weight = 0;
    if (i == k) {
      for (std::size_t j = first; j <= last; ++j)
        if (j != k) weight += 1 / (x - series.at[j]);
    } else {
      weight = 1 / (series.at[i] - x);
      for (std::size_t j = first; j <= last; ++j)
        if (j != i && j != k) weight *= (x - series.at[j]) / (series.at[i] - series.at[j]);
    }
    slope += weight * series.values[i];
  }
  return slope;
}

SeriesPoint between(const Series& series, std::size_t k, double part) {
  const double width = series.at[k + 1] - series.at[k];
  const double rise = series.values[k + 1] - series.values[k];
  const double first = width * slope_at(series, k) - rise, second = rise - width * slope_at(series, k + 1);
  const double rest = 1 - part;
  return {series.values[k] + part * rise + part * rest * (rest * first + part * second),
          (rise + (1 - 2 * part) * (rest * first + part * second) + part * rest * (second - first)) / width};
}

}  // namespace

SeriesPoint at(const Series& series, double abscissa) {
  const std::size_t count = series.at.size();
  if (count == 1) return {series.values.front(), 0};
  const auto next = std::upper_bound(series.at.begin(), series.at.end(), abscissa);
  const auto place = static_cast<std::size_t>(std::max<std::ptrdiff_t>(next - series.at.begin() - 1, 0));
  const std::size_t k = std::min(place, count - 2);
  const double part = (abscissa - series.at[k]) / (series.at[k + 1] - series.at[k]);
  if (part < -kSamePoint) return {series.values.front(), 0};
  if (part > 1 + kSamePoint) return {series.values.back(), 0};
  if (std::abs(part) <= kSamePoint) return {series.values[k], slope_at(series, k)};
  if (std::abs(part - 1) <= kSamePoint) return {series.values[k + 1], slope_at(series, k + 1)};
  return between(series, k, part);
}

}  // namespace mbgen
