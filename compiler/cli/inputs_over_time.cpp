#include "compiler/cli/inputs_over_time.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "compiler/cli/input_table.hpp"
#include "compiler/cli/options.hpp"
#include "compiler/cli/user_error.hpp"

namespace mbgen::cli {
namespace {

/// Who gives an input its values: nobody (its default), the command line, a column, or the spline of a column.
enum class Source { none, assigned, column, spline };

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

/// Columns, and the derivatives that their splines give.
void add_columns(const Model& model, const InputTable& table, std::vector<Source>& sources, InputsOverTime& result) {
  const auto take = [&](int input, Source source, Course course) {
    if (sources[input] == Source::assigned) {
      throw UserError(
          fmt::format("--input {0}: {1}: the table has values of {0}\n", model.inputs[input].name, table.header));
    }
    sources[input] = source;
    result.courses[input] = std::move(course);
    result.is_constant = false;
  };
  for (const InputColumn& column : table.columns) {
    take(column.input, Source::column, straight_lines(table.t, column.values));
  }
  for (const InputColumn& column : table.columns) {
    int rate = model.inputs[column.input].derivative;
    if (rate < 0 || sources[rate] == Source::column) continue;
    result.courses[column.input] = cubic_spline(table.t, column.values);
    for (int input = column.input; rate >= 0 && sources[rate] != Source::column; rate = model.inputs[rate].derivative) {
      if (sources[rate] == Source::spline) {
        throw UserError(fmt::format("{}: \"{}\" is the derivative of several columns, give it a column of its own\n",
                                    table.header, model.inputs[rate].name));
      }
      take(rate, Source::spline, derivative(result.courses[input]));
      input = rate;
    }
  }
}

/// Refuses a table that moves the derivative of an input that it does not move.
void check_rows(const Model& model, const InputTable& table, const std::vector<Source>& sources) {
  for (std::size_t i = 0; i < sources.size(); ++i) {
    const int rate = model.inputs[i].derivative;
    if (sources[i] >= Source::column || rate < 0 || sources[rate] < Source::column) continue;
    throw UserError(fmt::format("{}: \"{}\" is the derivative of \"{}\", which has no column\n", table.header,
                                model.inputs[rate].name, model.inputs[i].name));
  }
}

}  // namespace

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
                                const std::string& table_path) {
  const std::vector<double> values = input_values(model, assignments);
  InputsOverTime result;
  for (std::size_t i = 0; i < values.size(); ++i) {
    result.courses.push_back(continued(model.inputs, values, static_cast<int>(i)));
    const int rate = model.inputs[i].derivative;
    result.advances.push_back(rate >= 0);
    result.is_constant = result.is_constant && (rate < 0 || values[rate] == 0);
  }
  if (table_path.empty()) return result;
  const InputTable table = read_input_table(table_path, model);
  std::vector<Source> sources = assigned_inputs(model, assignments);
  add_columns(model, table, sources, result);
  check_rows(model, table, sources);
  return result;
}

}  // namespace mbgen::cli
