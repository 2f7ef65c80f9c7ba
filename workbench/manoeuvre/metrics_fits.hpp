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

/// A vector that a metric reads, by its name for people.
struct Read {
  const char* name;
  const Values* values;
};

/// Why a series cannot be used, "" when it can: too few points, unequal steps, a vector that is of another length or
/// holds a number that is not finite.
std::string fault_of(const VehicleSeries& series, std::initializer_list<Read> read);

/// The same for the loads of its tyres.
std::string fault_of_loads(const VehicleSeries& series);

/// No value, and a note that says of what and why.
VehicleMetrics refused(const std::string& of, const std::string& why);

/// Index of the first point at or behind an instant, s.
std::size_t first_point(const VehicleSeries& series, double begin);

/// s between two points. Requires: at least two points.
double step_of(const VehicleSeries& series);

/// rad, of the reference point. Requires: speeds of the series' length.
Values sideslip_of(const VehicleSeries& series);

/// Adds a value; a note instead where it is not finite.
void add(VehicleMetrics& metrics, const std::string& name, double value, const std::string& unit,
         const std::string& meaning);

/// Indices of points, the last excluded.
struct Span {
  std::size_t begin = 0, end = 0;
  std::size_t size() const { return end > begin ? end - begin : 0; }
};

/// Requires: a span that is not empty.
double mean(const Values& values, Span span);

/// Root of the mean square about `about`. Requires: a span that is not empty.
double spread(const Values& values, Span span, double about);

/// The largest size of a value, 0 for none.
double largest(const Values& values, Span span);
double largest(const Values& values);

/// The largest size of a mean over `width` points in a row. Requires: 1 <= width <= size.
double largest_mean(const Values& values, std::size_t width);

/// Each value by the parabola that fits best over `reach` points to each side, fewer near the ends: Savitzky and
/// Golay, Analytical Chemistry 36(8), 1964. reach 0: the values.
Values smoothed(const Values& values, std::size_t reach);

/// Coefficients c of the polynomial sum c[k] x^k with the least squares. Requires: more points than `degree`, not all
/// at one x.
Values polynomial(const Values& x, const Values& y, int degree);

/// A straight line through points, with the root of the mean square of what it leaves.
struct Line {
  double offset = 0, slope = 0, left = 0;
};
Line fitted_line(const Values& x, const Values& y);

/// Time at which values first reach a level from below, from a point on, between points by a straight line; NaN when
/// they do not.
double time_of_rise(const Values& t, const Values& values, double level, std::size_t from);

/// The largest value from a point on: by a parabola through it and its neighbours.
struct Peak {
  double time = 0, value = 0;
};
Peak peak_of(const Values& t, const Values& values, std::size_t from);

/// v / |v|; 1 for 0.
inline double sign_of(double v) { return v < 0 ? -1 : 1; }

}  // namespace mbgen::manoeuvre
