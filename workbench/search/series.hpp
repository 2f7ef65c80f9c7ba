#pragma once
// A quantity of the model over time, or over the abscissa of a curve, and its values between the points.

#include <vector>

namespace mbgen {

/// One quantity at increasing abscissas; a single value has one point, at any abscissa.
struct Series {
  std::vector<double> at, values;
};

/// Value and slope at an abscissa.
struct SeriesPoint {
  double value = 0, slope = 0;
};

/// Distance to a point, in parts of the interval, that is rounding.
constexpr double kSamePoint = 1e-6;

/// The series at an abscissa: a point itself where the abscissa is one but for rounding, else the cubic between two
/// points with slopes of fourth order (of second order next to the ends), so that the error falls with the fourth
/// power of the distance of points. Outside, the value at the end, without slope. Requires: at least one point.
SeriesPoint at(const Series& series, double abscissa);

}  // namespace mbgen
