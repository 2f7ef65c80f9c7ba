#include "workbench/sweep/metric_derivatives.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compiler/expressions/evaluate.hpp"
#include "compiler/expressions/jet.hpp"
#include "workbench/signals/weighting.hpp"

namespace mbgen {
namespace {

/// A value and its derivative by the parameter, which stands for time here.
using Number = Jet<double>;
using Numbers = std::vector<Number>;

/// Values of the variables in expressions of metrics, with derivatives.
struct SlopeEnvironment {
  const std::vector<Parameter>& parameters;
  const std::string& moved;
  const double *columns, *slopes;  ///< of one point; null outside of reductions
  const Numbers& results;
  Number parameter(int index) const {
    const Parameter& of = parameters[static_cast<std::size_t>(index)];
    return {of.value, of.name == moved ? 1.0 : 0.0, 0.0};
  }
  Number input(int index) const { return {columns[index], slopes[index], 0.0}; }
  Number local(int index) const { return results[static_cast<std::size_t>(index)]; }
  Number time() const { return 0.0; }
  Number position(const CoordinateReference&) const { return 0.0; }
  Number velocity(const CoordinateReference&) const { return 0.0; }
};

/// Mean over time by the trapezoidal rule.
Number mean_of(const Numbers& x) {
  if (x.size() == 1) return x[0];
  Number sum = 0.0;
  for (std::size_t i = 1; i < x.size(); ++i) sum = sum + (x[i - 1] + x[i]) * 0.5;
  return sum * (1 / static_cast<double>(x.size() - 1));
}

Number root_mean_square(const Numbers& x) {
  Numbers squares;
  for (const Number& one : x) squares.push_back(one * one);
  const Number mean = mean_of(squares);
  const double root = std::sqrt(mean.value);
  return {root, root > 0 ? mean.first / (2 * root) : 0.0, 0.0};
}

Number largest_of(const Numbers& x, double sign) {
  const auto is_less = [&](const Number& a, const Number& b) { return sign * a.value < sign * b.value; };
  return *std::max_element(x.begin(), x.end(), is_less);
}

Number number_at(const Numbers& x, double instant, double step) {
  if (x.size() == 1) return x[0];
  const double place = std::clamp(instant / step, 0.0, static_cast<double>(x.size() - 1));
  const auto before = std::min(static_cast<std::size_t>(place), x.size() - 2);
  return x[before] + (x[before + 1] - x[before]) * (place - static_cast<double>(before));
}

/// The square of the weighted rms is a quadratic form Q: its derivative along dx is (Q(x + dx) - Q(x - dx)) / 2.
Number weighted_rms(const Numbers& x, double step, Weighting weighting) {
  if (x.size() < 2) return 0.0;
  double size = 0, size_of_slope = 0;
  for (const Number& one : x) {
    size = std::max(size, std::abs(one.value));
    size_of_slope = std::max(size_of_slope, std::abs(one.first));
  }
  const auto squared = [&](double along) {
    std::vector<double> values;
    for (const Number& one : x) values.push_back(one.value + along * one.first);
    const double rms = comfort_of(values, step, weighting).rms;
    return rms * rms;
  };
  const double value = std::sqrt(squared(0));
  if (!(value > 0) || size_of_slope == 0) return value;
  const double along = size / size_of_slope;
  return {value, (squared(along) - squared(-along)) / (4 * along * value), 0.0};
}

Number reduced(const Reduction& reduction, const Numbers& x, double step) {
  switch (reduction.kind) {
    case ReductionKind::max:
      return largest_of(x, 1);
    case ReductionKind::min:
      return largest_of(x, -1);
    case ReductionKind::range:
      return largest_of(x, 1) - largest_of(x, -1);
    case ReductionKind::mean:
      return mean_of(x);
    case ReductionKind::rms:
      return root_mean_square(x);
    case ReductionKind::initial:
      return x.front();
    case ReductionKind::final:
      return x.back();
    case ReductionKind::at:
      return number_at(x, reduction.instant, step);
    default:
      break;
  }
  const int letter = static_cast<int>(reduction.kind) - static_cast<int>(ReductionKind::wk);
  return weighted_rms(x, step, static_cast<Weighting>(letter));
}

/// Calls visit(expression) for all expressions of the metrics.
template <class Visit>
void each_expression(const Metrics& metrics, const Visit& visit) {
  for (const Metric& metric : metrics.list) {
    visit(metric.value);
    for (const Reduction& reduction : metric.reductions) visit(reduction.operand);
  }
}

}  // namespace

std::string why_no_derivatives(const Metrics& metrics, const std::vector<Parameter>& parameters) {
  for (const MetricColumn& column : metrics.columns)
    if (column.kind == MetricColumn::Kind::position || column.kind == MetricColumn::Kind::velocity)
      return "a metric reads a coordinate: give the model an output of it";
  std::string reason;
  each_expression(metrics, [&](const Expression& expression) {
    for (const ExpressionNode& node : expression.nodes)
      if (node.kind == ExpressionNode::Kind::parameter &&
          parameters[static_cast<std::size_t>(node.index)].expression >= 0)
        reason = fmt::format("a metric reads the parameter \"{}\", which depends on others",
                             parameters[static_cast<std::size_t>(node.index)].name);
  });
  return reason;
}

std::vector<double> derivatives_by(const Metrics& metrics, const std::string& parameter,
                                   const std::vector<Parameter>& parameters, const MetricPoints& points,
                                   const MetricPoints& slopes) {
  std::vector<double> derivatives;
  const std::size_t width = metrics.columns.size();
  for (const Metric& metric : metrics.list) {
    Numbers results;
    for (const Reduction& reduction : metric.reductions) {
      Numbers course;
      for (std::size_t start = 0; start + width <= points.values.size(); start += width) {
        const SlopeEnvironment at_point{parameters, parameter, points.values.data() + start,
                                        slopes.values.data() + start, results};
        course.push_back(evaluate<Number>(reduction.operand, at_point));
        if (width == 0) break;  // the same at all points
      }
      results.push_back(reduced(reduction, course, points.step));
    }
    derivatives.push_back(
        evaluate<Number>(metric.value, SlopeEnvironment{parameters, parameter, nullptr, nullptr, results}).first);
  }
  return derivatives;
}

}  // namespace mbgen
