#include "workbench/search/rig.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compiler/text/user_error.hpp"
#include "workbench/operating/operating_point.hpp"

namespace mbgen {

namespace {

/// The report of an axle's rig where the model starts.
KcReport rig_report(const Compilation& compilation, const ModelArguments& arguments, const std::string& axle,
                    const KcSettings& settings, const KcWatch& watch) {
  StateArguments at;
  at.at = "initial";
  at.inputs = arguments.engine.inputs;
  return kinematics_and_compliance(compilation, find_axle(compilation.model, axle),
                                   operating_point(compilation, at).point, settings, watch);
}

}  // namespace

const KcReport& outline_of_rig(const FreeModel& model, const std::string& axle, RigReports& known) {
  constexpr int kFewest = 3;
  if (!known.contains(axle))
    known.emplace(axle, rig_report(expect(decide(model.model)), model.arguments, axle, {.points = kFewest}, {}));
  return known.at(axle);
}

KcReport curves_of_rig(const Compilation& compilation, const ModelArguments& arguments, const std::string& axle,
                       KcSettings settings, int curves, const std::function<bool()>& is_stopped) {
  settings.points = kPointsOfCurve;
  const KcWatch watch = [&](long done, long) {
    return done <= static_cast<long>(kPointsOfCurve) * curves && !(is_stopped && is_stopped());
  };
  return rig_report(compilation, arguments, axle, settings, watch);
}

const KcTable* curve_named(const KcReport& report, const std::string& name) {
  const auto found =
      std::find_if(report.tables.begin(), report.tables.end(), [&](const KcTable& one) { return one.name == name; });
  return found == report.tables.end() ? nullptr : &*found;
}

const Column* column_of(const KcTable& table, const std::string& name) {
  for (const std::string& wanted : {name, name + "_left", name + "_right"})
    for (const Column& column : table.columns)
      if (column.heading.name == wanted) return &column;
  return nullptr;
}

void reach_out_to(const std::string& curve, double amplitude, KcSettings& settings) {
  const auto reach = [&](std::optional<double>& value) { value = std::max(amplitude, value.value_or(0)); };
  if (curve.ends_with("travel")) reach(settings.travel);
  if (curve == "steering") reach(settings.steer);
  if (curve.ends_with("force")) reach(settings.force);
  if (curve == "aligning_moment") reach(settings.moment);
}

const KcTable& curve_of_table(const MeasuredTable& table, const KcReport& report, bool by_column) {
  if (const KcTable* found = curve_named(report, curve_of_file(report, table.path))) return *found;
  std::string known;
  for (const KcTable& one : report.tables) {
    if (by_column && one.columns.front().heading.name == table.columns.front().heading.name) return one;
    known += (known.empty() ? "" : ", ") + one.name;
  }
  throw UserError(
      fmt::format("{}: {}its name tells no curve of a rig\n  hint: call it like its curve, as {}_{}.csv; curves: {}\n",
                  table.path, by_column ? "neither its first column nor " : "has no column \"t\", and ", report.axle,
                  report.tables.front().name, known));
}

std::vector<double> abscissas_of(const MeasuredTable& table, const Heading& heading) {
  for (const Column& column : table.columns) {
    if (column.heading.name != heading.name) continue;
    std::vector<double> values = in_unit(table, column, heading.unit);
    for (std::size_t row = 0; row < values.size(); ++row)
      if (std::isnan(values[row]))
        throw UserError(fmt::format("{}: {} has no value\n", table.place(row), heading.name));
    return values;
  }
  throw UserError(fmt::format("{}: needs the column \"{}\"\n", table.header(), heading.name));
}

}  // namespace mbgen
