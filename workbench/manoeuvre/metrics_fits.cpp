#include "workbench/manoeuvre/metrics_fits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "compiler/algebra/dense.hpp"

namespace mbgen::manoeuvre {

std::string fault_of(const VehicleSeries& series, std::initializer_list<Read> read) {
  const Values& t = series.t;
  if (t.size() < 3) return fmt::format("the series has {} points", t.size());
  const double step = step_of(series);
  for (std::size_t i = 1; i < t.size(); ++i) {
    // The negated form also fails for NaN.
    if (!(step > 0 && std::abs(t[i] - t[i - 1] - step) <= 1e-6 * step)) return "the steps of time are not equal";
  }
  for (const Read& one : read) {
    if (one.values->size() != t.size()) {
      return fmt::format("{}: {} values for {} points of time", one.name, one.values->size(), t.size());
    }
    for (std::size_t i = 0; i < t.size(); ++i) {
      if (!std::isfinite((*one.values)[i])) return fmt::format("{}: not finite at {:.6g} s", one.name, t[i]);
    }
  }
  return "";
}

std::string fault_of_loads(const VehicleSeries& series) {
  if (series.loads.size() != series.wheels.size()) return "loads of other wheels than the wheels of the series";
  for (const Values& load : series.loads)
    if (const std::string fault = fault_of(series, {{"load of a tyre", &load}}); !fault.empty()) return fault;
  return "";
}

VehicleMetrics refused(const std::string& of, const std::string& why) { return {.notes = {of + ": " + why}}; }

std::size_t first_point(const VehicleSeries& series, double begin) {
  constexpr double kRounding = 1e-9;  // s
  std::size_t i = 0;
  while (i < series.t.size() && series.t[i] < begin - kRounding) ++i;
  return i;
}

double step_of(const VehicleSeries& series) {
  return (series.t.back() - series.t.front()) / static_cast<double>(series.t.size() - 1);
}

Values sideslip_of(const VehicleSeries& series) {
  Values sideslip;
  for (std::size_t i = 0; i < series.t.size(); ++i)
    sideslip.push_back(std::atan2(series.lateral_speed[i], series.speed[i]));
  return sideslip;
}

void add(VehicleMetrics& metrics, const std::string& name, double value, const std::string& unit,
         const std::string& meaning) {
  if (std::isfinite(value)) {
    metrics.values.push_back({name, value, unit, meaning});
  } else {
    metrics.notes.push_back(name + ": no finite number");
  }
}

double mean(const Values& values, Span span) {
  double sum = 0;
  for (std::size_t i = span.begin; i < span.end; ++i) sum += values[i];
  return sum / static_cast<double>(span.size());
}

double spread(const Values& values, Span span, double about) {
  double sum = 0;
  for (std::size_t i = span.begin; i < span.end; ++i) sum += (values[i] - about) * (values[i] - about);
  return std::sqrt(sum / static_cast<double>(span.size()));
}

double largest(const Values& values, Span span) {
  double result = 0;
  for (std::size_t i = span.begin; i < span.end; ++i) result = std::max(result, std::abs(values[i]));
  return result;
}

double largest(const Values& values) { return largest(values, {0, values.size()}); }

double largest_mean(const Values& values, std::size_t width) {
  Values sums{0};
  for (const double value : values) sums.push_back(sums.back() + value);
  double result = 0;
  for (std::size_t i = 0; i + width < sums.size(); ++i) result = std::max(result, std::abs(sums[i + width] - sums[i]));
  return result / static_cast<double>(width);
}

Values smoothed(const Values& values, std::size_t reach) {
  Values result = values;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::size_t near = std::min({reach, i, values.size() - 1 - i});
    if (near < 2) continue;
    // Sums of squares and of fourth powers of -near..near give the parabola's value in the middle.
    double count = 0, squares = 0, fourths = 0, sum = 0, moment = 0;
    for (std::size_t k = i - near; k <= i + near; ++k) {
      const double place = static_cast<double>(k) - static_cast<double>(i), square = place * place;
      count += 1, squares += square, fourths += square * square;
      sum += values[k], moment += square * values[k];
    }
    result[i] = (fourths * sum - squares * moment) / (count * fourths - squares * squares);
  }
  return result;
}

Values polynomial(const Values& x, const Values& y, int degree) {
  const auto rows = static_cast<Eigen::Index>(x.size());
  const double scale = std::max(largest(x), std::numeric_limits<double>::min());
  Eigen::MatrixXd powers(rows, degree + 1);
  Eigen::MatrixXd right(rows, 1);
  for (Eigen::Index i = 0; i < rows; ++i) {
    right(i, 0) = y[static_cast<std::size_t>(i)];
    powers(i, 0) = 1;
    for (int k = 1; k <= degree; ++k) powers(i, k) = powers(i, k - 1) * x[static_cast<std::size_t>(i)] / scale;
  }
  const Eigen::MatrixXd solution = overdetermined_solution(powers, right);
  Values coefficients;
  double unit = 1;
  for (int k = 0; k <= degree; ++k, unit *= scale) coefficients.push_back(solution(k, 0) / unit);
  return coefficients;
}

Line fitted_line(const Values& x, const Values& y) {
  const Values c = polynomial(x, y, 1);
  Values left;
  for (std::size_t i = 0; i < x.size(); ++i) left.push_back(y[i] - c[0] - c[1] * x[i]);
  return {c[0], c[1], spread(left, {0, left.size()}, 0)};
}

double interpolated(const Values& x, const Values& y, double at) {
  const auto i = static_cast<std::size_t>(std::upper_bound(x.begin(), x.end(), at) - x.begin());
  if (i == 0 || i == x.size()) return at == x.back() ? y.back() : std::nan("");
  return y[i - 1] + (y[i] - y[i - 1]) * (at - x[i - 1]) / (x[i] - x[i - 1]);
}

double time_of_rise(const Values& t, const Values& values, double level, std::size_t from) {
  for (std::size_t i = from; i < values.size(); ++i) {
    if (values[i] < level) continue;
    if (i == from) return t[i];
    return t[i - 1] + (t[i] - t[i - 1]) * (level - values[i - 1]) / (values[i] - values[i - 1]);
  }
  return std::numeric_limits<double>::quiet_NaN();
}

Peak peak_of(const Values& t, const Values& values, std::size_t from) {
  const auto begin = values.begin() + static_cast<std::ptrdiff_t>(from);
  const auto i = static_cast<std::size_t>(std::max_element(begin, values.end()) - values.begin());
  if (i == from || i + 1 == values.size()) return {t[i], values[i]};
  const double slope = (values[i + 1] - values[i - 1]) / 2, bend = values[i + 1] - 2 * values[i] + values[i - 1];
  if (bend == 0) return {t[i], values[i]};
  return {t[i] - (t[i + 1] - t[i]) * slope / bend, values[i] - slope * slope / (2 * bend)};
}

}  // namespace mbgen::manoeuvre
