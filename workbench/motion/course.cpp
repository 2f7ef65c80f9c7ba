#include "workbench/motion/course.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mbgen {
namespace {

/// Overshoot of the end, in parts of the last piece, for which the piece continues: a clock that adds up steps rounds.
constexpr double kOvershoot = 1e-6;
constexpr int kSamples = 32;  // of a piece, for its range

/// Second derivatives of the not-a-knot spline at four or more points; h and slope of the segments.
std::vector<double> spline_moments(const std::vector<double>& h, const std::vector<double>& slope) {
  const std::size_t last = h.size();  // of the points
  std::vector<double> lower(last), diagonal(last), upper(last), right(last), moments(last + 1);
  for (std::size_t i = 1; i < last; ++i) {
    lower[i] = h[i - 1];
    diagonal[i] = 2 * (h[i - 1] + h[i]);
    upper[i] = h[i];
    right[i] = 6 * (slope[i] - slope[i - 1]);
  }
  // The end moments continue their neighbours' on a straight line.
  const double first_ratio = h[0] / h[1], last_ratio = h[last - 1] / h[last - 2];
  diagonal[1] += h[0] * (1 + first_ratio);
  upper[1] -= h[0] * first_ratio;
  diagonal[last - 1] += h[last - 1] * (1 + last_ratio);
  lower[last - 1] -= h[last - 1] * last_ratio;
  for (std::size_t i = 2; i < last; ++i) {
    const double factor = lower[i] / diagonal[i - 1];
    diagonal[i] -= factor * upper[i - 1];
    right[i] -= factor * right[i - 1];
  }
  moments[last - 1] = right[last - 1] / diagonal[last - 1];
  for (std::size_t i = last - 1; i-- > 1;) moments[i] = (right[i] - upper[i] * moments[i + 1]) / diagonal[i];
  moments[0] = moments[1] + first_ratio * (moments[1] - moments[2]);
  moments[last] = moments[last - 1] + last_ratio * (moments[last - 1] - moments[last - 2]);
  return moments;
}

bool same_sign(double a, double b) { return a > 0 ? b > 0 : a < 0 && b < 0; }

/// Slope of PCHIP at an end; h and slope of the segment there and of the next one.
double end_slope(double h, double next_h, double slope, double next_slope) {
  const double parabola = ((2 * h + next_h) * slope - h * next_slope) / (h + next_h);
  if (!same_sign(parabola, slope)) return 0;
  const bool turns = !same_sign(slope, next_slope);
  return turns && std::abs(parabola) > 3 * std::abs(slope) ? 3 * slope : parabola;
}

/// Slopes of PCHIP at three or more points.
std::vector<double> pchip_slopes(const std::vector<double>& h, const std::vector<double>& slope) {
  const std::size_t last = h.size();
  std::vector<double> slopes(last + 1, 0.0);
  for (std::size_t i = 1; i < last; ++i) {
    if (!same_sign(slope[i - 1], slope[i])) continue;
    const double before = 2 * h[i] + h[i - 1], after = h[i] + 2 * h[i - 1];
    slopes[i] = (before + after) / (before / slope[i - 1] + after / slope[i]);
  }
  slopes[0] = end_slope(h[0], h[1], slope[0], slope[1]);
  slopes[last] = end_slope(h[last - 1], h[last - 2], slope[last - 1], slope[last - 2]);
  return slopes;
}

/// Coefficients of the polynomial with these derivatives at 0 and at h, by confluent divided differences.
std::vector<double> hermite_piece(double h, const std::vector<double>& first, const std::vector<double>& second) {
  const std::size_t m = first.size(), n = 2 * m;
  const auto place = [&](std::size_t i) { return i < m ? 0.0 : h; };
  std::vector<double> difference(n), newton(n);
  for (std::size_t i = 0; i < n; ++i) difference[i] = i < m ? first[0] : second[0];
  double factorial = 1;
  for (std::size_t order = 0; order < n; ++order) {
    newton[order] = difference[0];
    factorial *= static_cast<double>(order + 1);
    for (std::size_t i = 0; i + order + 1 < n; ++i) {
      const double width = place(i + order + 1) - place(i);
      difference[i] =
          width > 0 ? (difference[i + 1] - difference[i]) / width : (i < m ? first : second)[order + 1] / factorial;
    }
  }
  std::vector<double> coefficients = {newton[n - 1]};
  for (std::size_t k = n - 1; k-- > 0;) {  // times (s - place(k)), plus newton[k]
    coefficients.insert(coefficients.begin(), 0.0);
    for (std::size_t i = 0; i + 1 < coefficients.size(); ++i) coefficients[i] -= place(k) * coefficients[i + 1];
    coefficients[0] += newton[k];
  }
  return coefficients;
}

/// Width and slope of the segments between points.
void segments(const std::vector<double>& t, const std::vector<double>& y, std::vector<double>& h,
              std::vector<double>& slope) {
  for (std::size_t i = 0; i + 1 < t.size(); ++i) {
    h.push_back(t[i + 1] - t[i]);
    slope.push_back((y[i + 1] - y[i]) / h.back());
  }
}

}  // namespace

double Course::at(double t) const {
  if (t < times.front()) return before;
  if (t > end) return after;
  const auto piece = static_cast<std::size_t>(std::upper_bound(times.begin(), times.end(), t) - times.begin()) - 1;
  double value = 0;
  for (auto c = pieces[piece].rbegin(); c != pieces[piece].rend(); ++c) value = value * (t - times[piece]) + *c;
  return value;
}

Course polynomial(std::vector<double> coefficients) {
  const double start = coefficients.front();
  return {{0}, {std::move(coefficients)}, std::numeric_limits<double>::infinity(), start, 0};
}

Course straight_lines(const std::vector<double>& t, const std::vector<double>& y) {
  Course course{{}, {}, t.back(), y.front(), y.back()};
  if (t.size() > 1) course.end += kOvershoot * (t.back() - t[t.size() - 2]);
  for (std::size_t i = 0; i + 1 < t.size(); ++i) {
    course.times.push_back(t[i]);
    course.pieces.push_back({y[i], (y[i + 1] - y[i]) / (t[i + 1] - t[i])});
  }
  if (t.size() == 1) course.times = t, course.pieces = {{y.front()}};
  return course;
}

Course cubic_spline(const std::vector<double>& t, const std::vector<double>& y) {
  Course course = straight_lines(t, y);
  std::vector<double> h, slope;
  segments(t, y, h, slope);
  std::vector<double> moments(t.size(), 0.0);
  if (t.size() == 3) moments.assign(3, 2 * (slope[1] - slope[0]) / (h[0] + h[1]));
  if (t.size() > 3) moments = spline_moments(h, slope);
  for (std::size_t i = 0; i < h.size(); ++i) {
    course.pieces[i] = {y[i], slope[i] - h[i] * (2 * moments[i] + moments[i + 1]) / 6, moments[i] / 2,
                        (moments[i + 1] - moments[i]) / (6 * h[i])};
  }
  return course;
}

Course pchip(const std::vector<double>& t, const std::vector<double>& y) {
  if (t.size() < 3) return straight_lines(t, y);
  std::vector<double> h, slope;
  segments(t, y, h, slope);
  return hermite(t, {y, pchip_slopes(h, slope)});
}

Course zero_order_hold(const std::vector<double>& t, const std::vector<double>& y) {
  Course course = straight_lines(t, y);
  for (std::vector<double>& piece : course.pieces) piece.resize(1);
  course.end = t.back();
  return course;
}

Course hermite(const std::vector<double>& t, const std::vector<std::vector<double>>& derivatives) {
  Course course = straight_lines(t, derivatives[0]);
  std::vector<double> first(derivatives.size()), second(derivatives.size());
  for (std::size_t i = 0; i + 1 < t.size(); ++i) {
    for (std::size_t k = 0; k < derivatives.size(); ++k) {
      first[k] = derivatives[k][i];
      second[k] = derivatives[k][i + 1];
    }
    course.pieces[i] = hermite_piece(t[i + 1] - t[i], first, second);
  }
  return course;
}

Course derivative(const Course& course) {
  Course result{course.times, {}, course.end, 0, 0};
  for (const std::vector<double>& piece : course.pieces) {
    std::vector<double> rate;
    for (std::size_t k = 1; k < piece.size(); ++k) rate.push_back(static_cast<double>(k) * piece[k]);
    result.pieces.push_back(std::move(rate));
  }
  return result;
}

CourseRange range_of(const Course& course) {
  CourseRange range{course.before, course.before};
  for (std::size_t i = 0; i < course.pieces.size(); ++i) {
    const bool is_last = i + 1 == course.pieces.size();
    const double start = course.times[i], end = is_last ? course.end : course.times[i + 1];
    const int samples = std::isfinite(end) ? kSamples : 0;
    for (int k = 0; k <= samples; ++k) {
      const double value = course.at(k == 0 ? start : start + k * (end - start) / samples);
      range.smallest = std::min(range.smallest, value);
      range.largest = std::max(range.largest, value);
    }
  }
  return range;
}

}  // namespace mbgen
