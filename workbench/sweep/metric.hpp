#pragma once
// Metrics: numbers that say something of a whole motion, written as expressions.
//
// The grammar of compiler/expressions/expression.hpp with the outputs, z.NAME, zd.NAME, t, inputs and parameters of
// the model as names, and functions of the course of a value x over the motion:
//   max(x) min(x) mean(x) rms(x) initial(x) final(x) range(x) = max(x) - min(x), at(1.5, x) = x at t = 1.5 s
// mean and rms are integrals over time by the trapezoidal rule, at is on the straight line between two points. An
// expression outside of these functions is one number: "max(abs(roll)) * 57.3", "rms(a - mean(a))".

#include <string>
#include <vector>

#include "compiler/model/model.hpp"

namespace mbgen {

/// A value that changes along a motion.
struct MetricColumn {
  enum class Kind { time, output, position, velocity, input };
  Kind kind = Kind::time;
  int index = -1;                  ///< output or input of the model
  CoordinateReference coordinate;  ///< for position and velocity
  bool operator==(const MetricColumn&) const = default;
};

enum class ReductionKind { max, min, mean, rms, initial, final, range, at };

/// One of the functions over the motion.
struct Reduction {
  ReductionKind kind = ReductionKind::max;
  double instant = 0;  ///< s, of `at`
  /// "inputs" are MetricMetrics' columns, "locals" are results of reductions before this one
  Expression operand;
};

struct Metric {
  std::string name;  ///< the text before "=", else the whole text
  std::vector<Reduction> reductions;
  Expression value;  ///< "locals" are results of the reductions
};

/// Metrics and the columns that they need.
struct Metrics {
  std::vector<MetricColumn> columns;
  std::vector<Metric> list;
};

/// The points of a motion at equal steps: values of the columns, point after point, from t = 0 on.
struct MetricPoints {
  double step = 0;  ///< s
  std::vector<double> values;
};

/// Reads metrics. texts: "expression" or "name=expression".
/// Fails: an error of grammar, an unknown name (with the nearest one), a value over the motion of which no number is
/// taken, two metrics of one name. Places name `source` as the file, line k for the k-th metric.
Result<Metrics> read_metrics(const std::vector<std::string>& texts, const Model& model, const std::string& source);

/// Values of all metrics; NaN or infinity where an expression gives it. parameters: of all of the model.
/// Requires: at least one point; instants of `at` inside the motion (instant_outside).
std::vector<double> evaluate(const Metrics& metrics, const std::vector<Parameter>& parameters,
                             const MetricPoints& points);

/// The first instant that a metric asks for which is not in a motion from 0 to `end` (s), nothing when there is none.
std::optional<double> instant_outside(const Metrics& metrics, double end);

}  // namespace mbgen
