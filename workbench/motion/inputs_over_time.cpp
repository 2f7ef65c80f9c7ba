#include "workbench/motion/inputs_over_time.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "compiler/expressions/overshoot.hpp"
#include "compiler/text/user_error.hpp"
#include "workbench/host/assignments.hpp"
#include "workbench/motion/input_rates.hpp"
#include "workbench/motion/input_table.hpp"

namespace mbgen {
namespace {

/// Source of an input's values: its default, the command line, a column, or the derivative of a column.
enum class Source { none, assigned, column, derived };

/// Overshoot of a column beyond its rows, in parts of its range, that gives a warning.
constexpr double kOvershootTold = 0.01;

/// An input by its derivatives at t = 0.
Course continued(const std::vector<Input>& inputs, const std::vector<double>& values, int input) {
  std::vector<double> coefficients;
  double factor = 1;
  for (int order = 1; input >= 0; ++order) {
    coefficients.push_back(values[input] * factor);
    input = inputs[input].derivative;
    factor /= order;
  }
  return polynomial(std::move(coefficients));
}

std::vector<Source> assigned_inputs(const Model& model, const std::vector<std::string>& assignments) {
  std::vector<Source> sources(model.inputs.size(), Source::none);
  for (std::size_t i = 0; i < sources.size(); ++i) {
    for (const std::string& assignment : assignments) {
      if (assignment.substr(0, assignment.find('=')) == model.inputs[i].name) sources[i] = Source::assigned;
    }
  }
  return sources;
}

/// The courses of a table's columns, and of the derivatives that follow from them.
class TableCourses {
 public:
  TableCourses(const Model& model, const InputTable& table, Interpolation interpolation, std::vector<Source>& sources,
               InputsOverTime& result)
      : model_(model), table_(table), interpolation_(interpolation), sources_(sources), result_(result) {}

  void add() {
    for (const InputColumn& column : table_.columns) take(column.input, Source::column, {});
    for (const InputColumn& column : table_.columns) check_rates(model_, table_, column);
    const bool joins_rates = interpolation_ == Interpolation::pchip || interpolation_ == Interpolation::spline;
    for (const InputColumn& column : table_.columns) {
      if (!joins_rates || !is_rate(column.input)) add_column(column, joins_rates);
    }
    for (const InputColumn& column : table_.columns) warn_of_overshoot(column);
  }

 private:
  /// Whether this input is the derivative of another column.
  bool is_rate(int input) const {
    return std::any_of(table_.columns.begin(), table_.columns.end(),
                       [&](const InputColumn& column) { return model_.inputs[column.input].derivative == input; });
  }

  void take(int input, Source source, Course course) {
    if (sources_[input] == Source::assigned) {
      throw UserError(
          fmt::format("--input {0}: {1}: the table has values of {0}\n", model_.inputs[input].name, table_.header));
    }
    sources_[input] = source;
    result_.courses[input] = std::move(course);
    result_.is_constant = false;
  }

  Course alone(const std::vector<double>& values) const {
    switch (interpolation_) {
      case Interpolation::pchip:
        return pchip(table_.t, values);
      case Interpolation::linear:
        return straight_lines(table_.t, values);
      case Interpolation::spline:
        return cubic_spline(table_.t, values);
      case Interpolation::hold:
        return zero_order_hold(table_.t, values);
    }
    return {};
  }

  /// Adds a column and its derivatives: columns of the derivatives are joined to it, or each is interpolated by itself.
  void add_column(const InputColumn& column, bool joins_rates) {
    std::vector<std::vector<double>> orders = {column.values};
    int rate = model_.inputs[column.input].derivative;
    for (; joins_rates && rate >= 0 && sources_[rate] == Source::column; rate = model_.inputs[rate].derivative) {
      orders.push_back(column_of(table_, rate)->values);
    }
    Course course = orders.size() > 1 ? hermite(table_.t, orders) : alone(column.values);
    int input = column.input;
    for (std::size_t order = 0; order < orders.size(); ++order) {
      if (order > 0) course = derivative(course);
      result_.courses[input] = course;
      rate = model_.inputs[input].derivative;
      if (order + 1 < orders.size()) input = rate;
    }
    for (; rate >= 0 && sources_[rate] != Source::column; rate = model_.inputs[rate].derivative) {
      if (sources_[rate] == Source::derived) {
        throw UserError(fmt::format("{}: \"{}\" is the derivative of several columns, give it a column of its own\n",
                                    table_.header, model_.inputs[rate].name));
      }
      course = derivative(course);
      take(rate, Source::derived, course);
    }
  }

  /// "at t = 0.35 s, between lines 4 and 5 of the file": position of a course's largest deviation from its column's
  /// rows.
  std::string where_farthest(const InputColumn& column, double smallest, double largest) const {
    constexpr int kParts = 64;  // of a row
    const Course& course = result_.courses[column.input];
    const Overshoot farthest =
        farthest_overshoot(table_.t, smallest, largest, kParts, [&](std::size_t, double t) { return course.at(t); });
    return fmt::format("at t = {:.4g} s, between lines {} and {}", farthest.at, table_.lines[farthest.piece],
                       table_.lines[farthest.piece + 1]);
  }

  void warn_of_overshoot(const InputColumn& column) {
    const auto [smallest, largest] = std::minmax_element(column.values.begin(), column.values.end());
    const CourseRange range = range_of(result_.courses[column.input]);
    const double beyond = std::max(*smallest - range.smallest, range.largest - *largest);
    if (!(beyond > kOvershootTold * (*largest - *smallest)) || is_rate(column.input)) return;
    const Input& input = model_.inputs[column.input];
    result_.warnings.push_back(
        fmt::format("{}: warning: {} leaves its column, {:.6g} to {:.6g}, by {:.6g} {}: it is applied from {:.6g} to "
                    "{:.6g} {}\n  hint: {}\n",
                    table_.header, input.name, *smallest, *largest, beyond, where_farthest(column, *smallest, *largest),
                    range.smallest, range.largest, unit_or_one(input.unit),
                    input.derivative >= 0 && sources_[input.derivative] == Source::column
                        ? "the column of its derivative makes it; more rows, or leave that column out"
                        : "--interpolation pchip and linear stay within the rows"));
  }

  const Model& model_;
  const InputTable& table_;
  Interpolation interpolation_;
  std::vector<Source>& sources_;
  InputsOverTime& result_;
};

/// Refuses a column for the derivative of an input without a column.
void check_rows(const Model& model, const InputTable& table) {
  for (const Input& input : model.inputs) {
    const int rate = input.derivative;
    if (rate < 0 || column_of(table, rate) == nullptr) continue;
    if (column_of(table, static_cast<int>(&input - model.inputs.data())) != nullptr) continue;
    throw UserError(fmt::format("{}: \"{}\" is the derivative of \"{}\", which has no column\n", table.header,
                                model.inputs[rate].name, input.name));
  }
}

/// Rows at which a column has another value than before.
std::vector<double> jumps_of(const InputTable& table) {
  std::vector<double> jumps;
  for (std::size_t row = 1; row < table.t.size(); ++row) {
    const auto differs = [row](const InputColumn& column) { return column.values[row] != column.values[row - 1]; };
    if (std::ranges::any_of(table.columns, differs)) jumps.push_back(table.t[row]);
  }
  return jumps;
}

/// Inputs that keep their value, or continue by their derivatives.
InputsOverTime without_table(const Model& model, const std::vector<std::string>& assignments) {
  const std::vector<double> values = input_values(model, assignments);
  InputsOverTime result;
  result.laws = LawInstants(model);
  for (std::size_t i = 0; i < values.size(); ++i) {
    result.courses.push_back(continued(model.inputs, values, static_cast<int>(i)));
    const int rate = model.inputs[i].derivative;
    result.advances.push_back(rate >= 0);
    result.is_constant = result.is_constant && (rate < 0 || values[rate] == 0);
  }
  return result;
}

}  // namespace

bool InputsOverTime::has_row(double start, double end) const {
  const double rounding = 1e-9 * (end - start);
  const auto row = std::upper_bound(rows.begin(), rows.end(), start + rounding);
  return row != rows.end() && *row <= end + rounding;
}

std::vector<double> InputsOverTime::at(double t) const {
  std::vector<double> values;
  for (const Course& course : courses) values.push_back(course.at(t));
  return values;
}

std::vector<double> InputsOverTime::of_step(double t, double h) const {
  std::vector<double> values;
  for (std::size_t i = 0; i < courses.size(); ++i) values.push_back(courses[i].at(advances[i] ? t : t + h / 2));
  return values;
}

InputsOverTime inputs_over_time(const Model& model, const std::vector<std::string>& assignments,
                                const std::string& table_path, Interpolation interpolation) {
  if (table_path.empty()) return without_table(model, assignments);
  input_values(model, assignments);  // which are refused before a table is read
  return inputs_over_time(model, assignments, read_input_table(table_path, model), interpolation);
}

InputsOverTime inputs_over_time(const Model& model, const std::vector<std::string>& assignments,
                                const InputTable& table, Interpolation interpolation) {
  InputsOverTime result = without_table(model, assignments);
  std::vector<Source> sources = assigned_inputs(model, assignments);
  check_rows(model, table);
  result.rows = table.t;
  if (interpolation == Interpolation::hold) result.jumps = jumps_of(table);
  TableCourses(model, table, interpolation, sources, result).add();
  return result;
}

}  // namespace mbgen
