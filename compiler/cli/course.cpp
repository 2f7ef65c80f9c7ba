#include "compiler/cli/course.hpp"

#include <algorithm>
#include <limits>

namespace mbgen::cli {
namespace {

/// The last piece holds on for this part of it: a clock that adds up steps rounds.
constexpr double kOvershoot = 1e-6;

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
  for (std::size_t i = 0; i + 1 < t.size(); ++i) {
    h.push_back(t[i + 1] - t[i]);
    slope.push_back(course.pieces[i][1]);
  }
  std::vector<double> moments(t.size(), 0.0);
  if (t.size() == 3) moments.assign(3, 2 * (slope[1] - slope[0]) / (h[0] + h[1]));
  if (t.size() > 3) moments = spline_moments(h, slope);
  for (std::size_t i = 0; i < h.size(); ++i) {
    course.pieces[i] = {y[i], slope[i] - h[i] * (2 * moments[i] + moments[i + 1]) / 6, moments[i] / 2,
                        (moments[i + 1] - moments[i]) / (6 * h[i])};
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

}  // namespace mbgen::cli
