#pragma once
// Curves and figures of a rig at values of the free parameters, beside a table of wanted points.

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "workbench/kc/kc.hpp"
#include "workbench/search/free_model.hpp"
#include "workbench/search/measured_table.hpp"

namespace mbgen {

/// Points of a curve: enough for a cubic between them.
constexpr int kPointsOfCurve = 41;

/// The fewest points of a curve, up to kPointsOfCurve, among which are all of these, in parts of its amplitude.
int points_among(const std::vector<double>& parts);

/// Reports of rigs at the model's values in few points, for names and units: by axle.
using RigReports = std::map<std::string, KcReport>;

/// The report of an axle, made where there is none. Fails: UserError.
const KcReport& outline_of_rig(const FreeModel& model, const std::string& axle, RigReports& known);

/// The report of an axle's rig where the model starts. watch: may be empty. Fails: UserError.
KcReport rig_report(const Compilation& compilation, const ModelArguments& arguments, const std::string& axle,
                    const KcSettings& settings, const KcWatch& watch);

/// Decisions about the rig that serve for all values of a model whose free parameters are tunable; null for others.
/// Requires: prepare(model). Fails: UserError.
std::shared_ptr<const kc::RigDecisions> decisions_of_rig(const FreeModel& model, const std::string& axle);

/// A column by its name, or of the left wheel; null without one.
const Column* column_of(const KcTable& table, const std::string& name);

/// The amplitude of a curve's abscissa.
std::optional<double>& reach_of(const std::string& curve, KcSettings& settings);

/// Sets it, where it reaches less far.
void reach_out_to(const std::string& curve, double amplitude, KcSettings& settings);

/// The curve that a table of points holds: by the name of the file, else (by_column) the first over the quantity of the
/// table's first column. Fails: UserError.
const KcTable& curve_of_table(const MeasuredTable& table, const KcReport& report, bool by_column);

/// Abscissas of the points of a curve, in SI units. Fails: UserError with file and line.
std::vector<double> abscissas_of(const MeasuredTable& table, const Heading& heading);

}  // namespace mbgen
