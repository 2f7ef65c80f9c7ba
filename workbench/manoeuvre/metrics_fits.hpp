#pragma once
// Helpers of several metrics: checks, means, fits, crossings and peaks of series.

#include <cstddef>
#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

#include "workbench/manoeuvre/metrics.hpp"

namespace mbgen::manoeuvre {

using Values = std::vector<double>;

/// A vector read by a metric, with its name for messages.
struct Read {
  const char* name;
  const Values* values;
};

/// Reason against the use of a series, "" for a usable one: too few points, unequal steps, a vector of another length
/// or with a value that is not finite.
std::string fault_of(const VehicleSeries& series, std::initializer_list<Read> read);

/// Reason against the use of the loads of its tyres.
std::string fault_of_loads(const VehicleSeries& series);

/// No values, and a note with name and reason.
VehicleMetrics refused(const std::string& of, const std::string& why);

/// Index of the first point at or behind an instant, s.
std::size_t first_point(const VehicleSeries& series, double begin);

/// Time step, s. Requires: at least two points.
double step_of(const VehicleSeries& series);

/// Sideslip angle of the reference point, rad. Requires: speeds of the series' length.
Values sideslip_of(const VehicleSeries& series);

/// Adds a value, or a note if it is not finite.
void add(VehicleMetrics& metrics, const std::string& name, double value, const std::string& unit,
         const std::string& meaning);

/// Range of points, the last excluded.
struct Span {
  std::size_t begin = 0, end = 0;
  std::size_t size() const { return end > begin ? end - begin : 0; }
};

/// Requires: a span that is not empty.
double mean(const Values& values, Span span);

/// Root of the mean square about `about`. Requires: a span that is not empty.
double spread(const Values& values, Span span, double about);

/// Largest absolute value, 0 for none.
double largest(const Values& values, Span span);
double largest(const Values& values);

/// Largest absolute mean over `width` successive points. Requires: 1 <= width <= size.
double largest_mean(const Values& values, std::size_t width);

/// Smoothed values by local parabolas over `reach` points to each side, fewer near the ends: Savitzky and Golay,
/// Analytical Chemistry 36(8), 1964. reach 0: the values.
Values smoothed(const Values& values, std::size_t reach);

/// Coefficients c of the least-squares polynomial sum c[k] x^k. Requires: more points than `degree`, not all at one x.
Values polynomial(const Values& x, const Values& y, int degree);

/// Straight line through points, with its root-mean-square residual.
struct Line {
  double offset = 0, slope = 0, left = 0;
};
Line fitted_line(const Values& x, const Values& y);

/// Value at a place of a rising abscissa, by linear interpolation; NaN outside.
double interpolated(const Values& x, const Values& y, double at);

/// Time of the first upward crossing of a level from a point on, by linear interpolation; NaN without a crossing.
double time_of_rise(const Values& t, const Values& values, double level, std::size_t from);

/// Largest value from a point on, by a parabola through it and its neighbours.
struct Peak {
  double time = 0, value = 0;
};
Peak peak_of(const Values& t, const Values& values, std::size_t from);

/// v / |v|; 1 for 0.
inline double sign_of(double v) { return v < 0 ? -1 : 1; }

}  // namespace mbgen::manoeuvre
