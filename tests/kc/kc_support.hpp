#pragma once
// Rigs of models in text or in files.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "compiler/reader/read_model.hpp"
#include "compiler/text/user_error.hpp"
#include "workbench/kc/kc.hpp"
#include "workbench/operating/operating_point.hpp"

namespace mbgen::kc_test {

inline std::string source_path(const std::string& name) { return std::string(MBGEN_SOURCE_DIR) + "/" + name; }

/// The report of an axle at the initial state of its model.
inline KcReport report_of(Model model, const KcSettings& options, const std::string& axle = "") {
  const Compilation compilation = expect(decide(std::move(model)));
  StateArguments at;
  at.at = "initial";
  return kinematics_and_compliance(compilation, find_axle(compilation.model, axle),
                                   operating_point(compilation, at).point, options);
}

inline KcReport report_of_text(const std::string& text, const KcSettings& options) {
  return report_of(expect(read_model(text, "axle.json")), options);
}

inline KcReport report_of_file(const std::string& name, const KcSettings& options, const std::string& axle = "") {
  return report_of(expect(read_model_file(source_path(name))), options, axle);
}

/// A value at the start; which: 0 of the axle or the left wheel, 1 of the right one.
inline double figure(const KcReport& report, const std::string& name, std::size_t which = 0) {
  for (const KcFigure& one : report.figures) {
    if (one.name == name) return one.values.at(which);
  }
  throw std::out_of_range("no figure " + name);
}

inline const KcTable& table(const KcReport& report, const std::string& name) {
  for (const KcTable& one : report.tables) {
    if (one.name == name) return one;
  }
  throw std::out_of_range("no table " + name);
}

inline const std::vector<double>& values(const KcTable& table, const std::string& name) {
  for (const Column& column : table.columns) {
    if (column.heading.name == name) return column.values;
  }
  throw std::out_of_range("no column " + name);
}

/// The value of a column in the row whose imposed value is this one.
inline double value_at(const KcReport& report, const std::string& curve, const std::string& column, double imposed) {
  const KcTable& of = table(report, curve);
  const std::vector<double>& rows = of.columns.front().values;
  const auto row = std::find(rows.begin(), rows.end(), imposed);
  if (row == rows.end()) throw std::out_of_range("no such row");
  return values(of, column)[static_cast<std::size_t>(row - rows.begin())];
}

}  // namespace mbgen::kc_test
