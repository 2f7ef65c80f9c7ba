#include "workbench/sweep/metric.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compiler/expressions/evaluate.hpp"
#include "compiler/expressions/parse_expression.hpp"
#include "compiler/text/document.hpp"
#include "workbench/signals/weighting.hpp"

namespace mbgen {
namespace {

using Kind = ExpressionNode::Kind;

/// In the order of ReductionKind.
constexpr reading::ReductionName kReductions[] = {{"max", 1},   {"min", 1},   {"mean", 1}, {"rms", 1}, {"initial", 1},
                                                  {"final", 1}, {"range", 1}, {"at", 2},   {"wk", 1},  {"wd", 1},
                                                  {"wc", 1},    {"we", 1},    {"wj", 1},   {"wf", 1}};

/// Names in metrics and their meaning.
struct MetricScope {
  std::vector<std::string_view> outputs;
  std::vector<Parameter> parameters;  ///< all as tunable: no constant folding
  reading::Names names;
  reading::Visibility visible = {{0, {}, {}}};
};

MetricScope scope_of(const Model& model) {
  MetricScope scope;
  for (const Output& output : model.outputs) scope.outputs.push_back(output.name);
  const auto is_output = [&](const std::string& name) {
    return std::find(scope.outputs.begin(), scope.outputs.end(), name) != scope.outputs.end();
  };
  for (const Parameter& parameter : model.parameters) {
    if (!is_output(parameter.name)) {
      scope.names.parameters.emplace(parameter.name, static_cast<int>(scope.parameters.size()));
    }
    scope.parameters.push_back(parameter);
    scope.parameters.back().tunable = true;
    scope.parameters.back().expression = -1;
  }
  for (std::size_t i = 0; i < model.inputs.size(); ++i) {
    if (!is_output(model.inputs[i].name)) scope.names.inputs.emplace(model.inputs[i].name, static_cast<int>(i));
  }
  reading::NameMap<CoordinateReference>& coordinates = scope.names.coordinates.emplace_back();
  for (std::size_t j = 0; j < model.joints.size(); ++j) {
    const std::vector<Freedom>& freedoms = model.joints[j].freedoms;
    for (std::size_t f = 0; f < freedoms.size(); ++f) {
      coordinates.emplace(freedoms[f].name, CoordinateReference{static_cast<int>(j), static_cast<int>(f)});
    }
  }
  return scope;
}

/// Column of a node; nothing for other nodes.
std::optional<MetricColumn> column_of(const ExpressionNode& node, int outputs) {
  using Of = MetricColumn::Kind;
  switch (node.kind) {
    case Kind::time:
      return MetricColumn{Of::time, -1, {}};
    case Kind::input:
      return MetricColumn{Of::input, node.index, {}};
    case Kind::position:
      return MetricColumn{Of::position, -1, node.coordinate};
    case Kind::velocity:
      return MetricColumn{Of::velocity, -1, node.coordinate};
    case Kind::local:
      if (node.index < outputs) return MetricColumn{Of::output, node.index, {}};
      return std::nullopt;
    default:
      return std::nullopt;
  }
}

/// Turns column nodes into inputs and results of reductions into local variables.
void resolve(Expression& expression, int outputs, std::vector<MetricColumn>& columns) {
  for (ExpressionNode& node : expression.nodes) {
    if (const std::optional<MetricColumn> column = column_of(node, outputs)) {
      auto found = std::find(columns.begin(), columns.end(), *column);
      if (found == columns.end()) found = columns.insert(columns.end(), *column);
      node.kind = Kind::input;
      node.index = static_cast<int>(found - columns.begin());
    } else if (node.kind == Kind::local) {
      node.index -= outputs;
    }
  }
}

std::string name_of(const MetricColumn& column, const Model& model) {
  using Of = MetricColumn::Kind;
  const auto coordinate = [&] { return freedom_of(model, column.coordinate).name; };
  switch (column.kind) {
    case Of::time:
      return "t";
    case Of::output:
      return model.outputs[static_cast<std::size_t>(column.index)].name;
    case Of::input:
      return model.inputs[static_cast<std::size_t>(column.index)].name;
    case Of::position:
      return "z." + coordinate();
    case Of::velocity:
      return "zd." + coordinate();
  }
  return {};
}

/// Text of one metric and its origin.
struct MetricText {
  std::string whole;
  std::string name;
  std::size_t start = 0;  ///< of the expression
};

/// Splits "name=expression".
MetricText split(const std::string& text) {
  const std::size_t sign = text.find('=');
  if (sign == std::string::npos) return {text, text, 0};
  return {text, text.substr(0, sign), sign + 1};
}

/// Reads one metric; adds its columns and its problems.
void read_metric(const MetricText& text, const Where& where, const Model& model, const MetricScope& scope,
                 Metrics& metrics, Diagnostics& problems) {
  const auto complain = [&](std::size_t offset, std::string message, std::string hint) {
    Where place = where;
    place.column = static_cast<int>(offset) + 1;
    problems.push_back({place, std::move(message), std::move(hint), ""});
  };
  if (text.start > 0 && !reading::is_valid_name(text.name)) {
    complain(0, "invalid name " + quoted(text.name), reading::kNameRule);
  }
  const reading::ExpressionScope of_metric{.names = scope.names,
                                           .visible = scope.visible,
                                           .parameters = scope.parameters,
                                           .expressions = {},
                                           .locals = scope.outputs,
                                           .reductions = kReductions};
  const std::string_view expression = std::string_view(text.whole).substr(text.start);
  reading::ParsedExpression parsed = reading::parse_expression(expression, of_metric);
  for (reading::ExpressionProblem& problem : parsed.problems) {
    complain(text.start + problem.offset, std::move(problem.message), std::move(problem.hint));
  }
  if (!parsed.problems.empty()) return;
  Metric metric;
  metric.name = text.name;
  const int outputs = static_cast<int>(scope.outputs.size());
  for (const ExpressionNode& node : parsed.expression.nodes) {
    const std::optional<MetricColumn> column = column_of(node, outputs);
    if (!column) continue;
    const std::string name = name_of(*column, model);
    complain(text.start, quoted(name) + " changes along the motion, a metric is one number",
             fmt::format("take for example max({0}), mean({0}), final({0}) or at(1.5, {0})", name));
    return;
  }
  for (reading::ReductionCall& call : parsed.reductions) {
    resolve(call.operand, outputs, metrics.columns);
    metric.reductions.push_back({static_cast<ReductionKind>(call.reduction), call.constant, std::move(call.operand)});
  }
  resolve(parsed.expression, outputs, metrics.columns);
  metric.value = std::move(parsed.expression);
  metrics.list.push_back(std::move(metric));
}

/// Values of the variables in expressions of metrics.
struct MetricEnvironment {
  const std::vector<Parameter>& parameters;
  const double* columns;  ///< of one point; null outside of reductions
  const std::vector<double>& results;
  double parameter(int index) const { return parameters[static_cast<std::size_t>(index)].value; }
  double input(int index) const { return columns[index]; }
  double local(int index) const { return results[static_cast<std::size_t>(index)]; }
  double time() const { return 0; }
  double position(const CoordinateReference&) const { return 0; }
  double velocity(const CoordinateReference&) const { return 0; }
};

/// Mean over time by the trapezoidal rule.
double mean(const std::vector<double>& x) {
  if (x.size() == 1) return x[0];
  double sum = 0;
  for (std::size_t i = 1; i < x.size(); ++i) sum += (x[i - 1] + x[i]) / 2;
  return sum / static_cast<double>(x.size() - 1);
}

/// Value at an instant by linear interpolation.
double value_at(const std::vector<double>& x, double instant, double step) {
  if (x.size() == 1) return x[0];
  const double place = std::clamp(instant / step, 0.0, static_cast<double>(x.size() - 1));
  const auto before = std::min(static_cast<std::size_t>(place), x.size() - 2);
  const double part = place - static_cast<double>(before);
  return x[before] + part * (x[before + 1] - x[before]);
}

/// The best of all values, NaN if any is NaN.
template <class Better>
double extreme(const std::vector<double>& x, Better better) {
  double result = x[0];
  for (const double value : x) {
    if (std::isnan(value)) return value;
    if (better(value, result)) result = value;
  }
  return result;
}

double reduce(const Reduction& reduction, std::vector<double> x, double step) {
  switch (reduction.kind) {
    case ReductionKind::max:
      return extreme(x, std::greater<double>());
    case ReductionKind::min:
      return extreme(x, std::less<double>());
    case ReductionKind::range:
      return extreme(x, std::greater<double>()) - extreme(x, std::less<double>());
    case ReductionKind::mean:
      return mean(x);
    case ReductionKind::rms:
      for (double& value : x) value *= value;
      return std::sqrt(mean(x));
    case ReductionKind::initial:
      return x.front();
    case ReductionKind::final:
      return x.back();
    case ReductionKind::at:
      return value_at(x, reduction.instant, step);
    default:
      break;
  }
  const int letter = static_cast<int>(reduction.kind) - static_cast<int>(ReductionKind::wk);
  return x.size() < 2 ? 0 : comfort_of(x, step, static_cast<Weighting>(letter)).rms;
}

}  // namespace

Result<Metrics> read_metrics(const std::vector<std::string>& texts, const Model& model, const std::string& source) {
  const MetricScope scope = scope_of(model);
  Metrics metrics;
  Diagnostics problems;
  int line = 0;
  for (const std::string& whole : texts) {
    const MetricText text = split(whole);
    const Where where{source, ++line, 1, "", whole};
    const auto has_its_name = [&](const Metric& metric) { return metric.name == text.name; };
    if (std::any_of(metrics.list.begin(), metrics.list.end(), has_its_name)) {
      problems.push_back({where, "metric " + quoted(text.name) + " is there twice", "", ""});
      continue;
    }
    read_metric(text, where, model, scope, metrics, problems);
  }
  if (!problems.empty()) return problems;
  return metrics;
}

std::vector<double> evaluate(const Metrics& metrics, const std::vector<Parameter>& parameters,
                             const MetricPoints& points) {
  std::vector<double> values;
  const std::size_t width = metrics.columns.size();
  for (const Metric& metric : metrics.list) {
    std::vector<double> results;
    for (const Reduction& reduction : metric.reductions) {
      std::vector<double> course;
      for (std::size_t start = 0; start + width <= points.values.size(); start += width) {
        const MetricEnvironment at_point{parameters, points.values.data() + start, results};
        course.push_back(evaluate<double>(reduction.operand, at_point));
        if (width == 0) break;  // the same at all points
      }
      results.push_back(reduce(reduction, std::move(course), points.step));
    }
    values.push_back(evaluate<double>(metric.value, MetricEnvironment{parameters, nullptr, results}));
  }
  return values;
}

std::optional<double> instant_outside(const Metrics& metrics, double end) {
  for (const Metric& metric : metrics.list) {
    for (const Reduction& reduction : metric.reductions) {
      const bool is_inside = reduction.instant >= 0 && reduction.instant <= end;
      if (reduction.kind == ReductionKind::at && !is_inside) return reduction.instant;
    }
  }
  return std::nullopt;
}

}  // namespace mbgen
