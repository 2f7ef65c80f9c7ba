#pragma once
// Metrics: scalar results of a whole motion, written as expressions.
//
// The grammar is compiler/expressions/expression.hpp. Names are the outputs, z.NAME, zd.NAME, t, inputs and parameters
// of the model. Functions reduce the values x over the motion to one number:
//   max(x) min(x) mean(x) rms(x) initial(x) final(x) range(x) = max(x) - min(x), at(1.5, x) = x at t = 1.5 s
//   wk(x) wd(x) wc(x) we(x) wj(x) wf(x) = rms of x without its mean under a frequency weighting of ISO 2631-1
// mean and rms integrate over time by the trapezoidal rule, at interpolates linearly between two points. Outside these
// functions an expression is one number: "max(abs(roll)) * 57.3", "rms(a - mean(a))".

#include <string>
#include <vector>

#include "compiler/model/model.hpp"

namespace mbgen {

/// A quantity sampled along a motion.
struct MetricColumn {
  enum class Kind { time, output, position, velocity, input };
  Kind kind = Kind::time;
  int index = -1;                  ///< output or input of the model
  CoordinateReference coordinate;  ///< for position and velocity
  bool operator==(const MetricColumn&) const = default;
};

/// The weightings are in the order of Weighting.
enum class ReductionKind { max, min, mean, rms, initial, final, range, at, wk, wd, wc, we, wj, wf };

/// A function over the whole motion.
struct Reduction {
  ReductionKind kind = ReductionKind::max;
  double instant = 0;  ///< s, of `at`
  /// "inputs" index Metrics::columns, "locals" are results of earlier reductions
  Expression operand;
};

struct Metric {
  std::string name;  ///< text before "=", else the whole text
  std::vector<Reduction> reductions;
  Expression value;  ///< "locals" are results of the reductions
};

/// Metrics and their columns.
struct Metrics {
  std::vector<MetricColumn> columns;
  std::vector<Metric> list;
};

/// A motion sampled at equal steps from t = 0 on: values of all columns, point after point.
struct MetricPoints {
  double step = 0;  ///< s
  std::vector<double> values;
};

/// Reads metrics. texts: "expression" or "name=expression". Fails: an error of grammar, an unknown name (with the
/// nearest one), a varying quantity outside a reduction, two metrics of one name. Places name `source` as the file,
/// line k for the k-th metric.
Result<Metrics> read_metrics(const std::vector<std::string>& texts, const Model& model, const std::string& source);

/// Values of all metrics; NaN or infinity where an expression gives it. parameters: all parameters of the model.
/// Requires: at least one point; instants of `at` within the motion (instant_outside).
std::vector<double> evaluate(const Metrics& metrics, const std::vector<Parameter>& parameters,
                             const MetricPoints& points);

/// First instant of an `at` outside a motion from 0 to `end` (s); nothing if all are inside.
std::optional<double> instant_outside(const Metrics& metrics, double end);

}  // namespace mbgen
