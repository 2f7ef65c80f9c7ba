#include "workbench/search/rig.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compiler/text/user_error.hpp"
#include "workbench/operating/operating_point.hpp"

namespace mbgen {

namespace {

/// The point at which the model starts.
OperatingPoint start_of(const Compilation& compilation, const ModelArguments& arguments) {
  StateArguments at;
  at.at = "initial";
  at.inputs = arguments.engine.inputs;
  return operating_point(compilation, at).point;
}

}  // namespace

KcReport rig_report(const Compilation& compilation, const ModelArguments& arguments, const std::string& axle,
                    const KcSettings& settings, const KcWatch& watch) {
  return kinematics_and_compliance(compilation, find_axle(compilation.model, axle), start_of(compilation, arguments),
                                   settings, watch);
}

std::shared_ptr<const kc::RigDecisions> decisions_of_rig(const FreeModel& model, const std::string& axle) {
  if (!model.is_tuned) return nullptr;
  return decisions_of_rig(model.compilation, find_axle(model.model, axle),
                          start_of(model.compilation, model.arguments));
}

int points_among(const std::vector<double>& parts) {
  constexpr double kRounding = 1e-9;
  for (int half = 1; half < kPointsOfCurve / 2; ++half) {
    const auto is_among = [half](double part) { return std::abs(part * half - std::round(part * half)) < kRounding; };
    if (std::ranges::all_of(parts, is_among)) return 2 * half + 1;
  }
  return kPointsOfCurve;
}

const KcReport& outline_of_rig(const FreeModel& model, const std::string& axle, RigReports& known) {
  constexpr int kFewest = 3;
  if (!known.contains(axle))
    known.emplace(axle, rig_report(expect(decide(model.model)), model.arguments, axle, {.points = kFewest}, {}));
  return known.at(axle);
}

const Column* column_of(const KcTable& table, const std::string& name) {
  for (const std::string& wanted : {name, name + "_left", name + "_right"})
    for (const Column& column : table.columns)
      if (column.heading.name == wanted) return &column;
  return nullptr;
}

std::optional<double>& reach_of(const std::string& curve, KcSettings& settings) {
  if (curve.ends_with("travel")) return settings.travel;
  if (curve == "steering") return settings.steer;
  return curve.ends_with("force") ? settings.force : settings.moment;
}

void reach_out_to(const std::string& curve, double amplitude, KcSettings& settings) {
  std::optional<double>& reach = reach_of(curve, settings);
  if (amplitude > 0) reach = std::max(amplitude, reach.value_or(0));
}

const KcTable& curve_of_table(const MeasuredTable& table, const KcReport& report, bool by_column) {
  if (const KcTable* found = table_named(report, curve_of_file(report, table.path))) return *found;
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
