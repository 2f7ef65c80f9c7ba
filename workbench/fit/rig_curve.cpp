#include "workbench/fit/rig_curve.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>

#include "compiler/text/user_error.hpp"
#include "workbench/host/assignments.hpp"
#include "workbench/kc/kc.hpp"
#include "workbench/operating/operating_point.hpp"

namespace mbgen::fit {
namespace {

/// Points of a curve: enough for a cubic between them.
constexpr int kPoints = 41;

/// Curves of the rig at values of the unknowns, out to the data.
KcReport rig_report(const Compilation& compilation, const ModelArguments& arguments, const std::string& axle,
                    KcSettings settings, const KcWatch& watch = {}) {
  settings.points = kPoints;
  StateArguments at;
  at.at = "initial";
  at.inputs = arguments.engine.inputs;
  return kinematics_and_compliance(compilation, find_axle(compilation.model, axle),
                                   operating_point(compilation, at).point, settings, watch);
}

const KcTable* table_named(const KcReport& report, const std::string& name) {
  const auto found =
      std::find_if(report.tables.begin(), report.tables.end(), [&](const KcTable& one) { return one.name == name; });
  return found == report.tables.end() ? nullptr : &*found;
}

/// A column by its name, or of the left wheel.
const Column* column_of(const KcTable& table, const std::string& name) {
  for (const std::string& wanted : {name, name + "_left", name + "_right"})
    for (const Column& column : table.columns)
      if (column.heading.name == wanted) return &column;
  return nullptr;
}

/// The amplitude of a curve's abscissa.
KcSettings settings_out_to(const std::string& curve, double amplitude) {
  KcSettings settings;
  if (curve.ends_with("travel")) settings.travel = amplitude;
  if (curve == "steering") settings.steer = amplitude;
  if (curve.ends_with("force")) settings.force = amplitude;
  if (curve == "aligning_moment") settings.moment = amplitude;
  return settings;
}

/// The curve that a file holds, by its name. Fails: UserError.
const KcTable& curve_in(const MeasuredTable& table, const KcReport& report) {
  const std::string name = curve_of_file(report, table.path);
  if (const KcTable* found = table_named(report, name)) return *found;
  std::string known;
  for (const KcTable& one : report.tables) known += (known.empty() ? "" : ", ") + one.name;
  throw UserError(
      fmt::format("{}: has no column \"t\", and its name tells no curve of a rig\n  hint: call it like its curve, as "
                  "{}_{}.csv; curves: {}\n",
                  table.path, report.axle, report.tables.front().name, known));
}

/// The axle whose curve a file holds: the one in its name, or the only one that is matched. Fails: UserError.
std::string axle_of(const MeasuredTable& table, const Model& model, const std::vector<Channel>& channels) {
  std::set<std::string> matched;
  for (const Channel& channel : channels)
    if (channel.is_of_rig()) matched.insert(channel.axle);
  if (matched.empty())
    throw UserError(fmt::format("{}: needs a column \"t\", or --match kc:AXLE:COLUMN for points of a rig's curve\n",
                                table.header()));
  const std::string stem = std::filesystem::path(table.path).stem().string();
  std::string named;
  for (const Axle& axle : model.axles)
    if (axle.name.size() > named.size() && stem.find(axle.name + "_") != std::string::npos) named = axle.name;
  if (named.empty() && matched.size() == 1) return *matched.begin();
  if (matched.contains(named)) return named;
  throw UserError(
      named.empty() ? fmt::format("{}: its name tells none of the matched axles {}\n  hint: call it like its curve, as "
                                  "{}_parallel_travel.csv\n",
                                  table.path, fmt::join(matched, ", "), *matched.begin())
                    : fmt::format("{}: is of the axle {}, which no --match names\n  hint: --match kc:{}:COLUMN\n",
                                  table.path, named, named));
}

/// Abscissas of the points, in SI units. Fails: UserError with file and line.
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

}  // namespace

MeasuredFile read_rig(const MeasuredTable& table, const FitModel& model, RigReports& reports,
                      std::vector<Channel>& channels, bool is_held_out, std::vector<std::string>& notes) {
  const std::string axle = axle_of(table, model.model, channels);
  if (!reports.contains(axle))
    reports.emplace(axle, rig_report(expect(decide(model.model)), model.arguments, axle, {}));
  const KcReport& report = reports.at(axle);
  const KcTable& curve = curve_in(table, report);
  MeasuredFile file{.path = table.path,
                    .is_held_out = is_held_out,
                    .axle = axle,
                    .curve = curve.name,
                    .curve_number = static_cast<int>(&curve - report.tables.data())};
  const std::vector<double> at = abscissas_of(table, curve.columns.front().heading);
  for (std::size_t c = 0; c < channels.size(); ++c) {
    Channel& channel = channels[c];
    if (!channel.is_of_rig() || channel.axle != file.axle) continue;
    const Column* computed = column_of(curve, channel.quantity);
    if (computed == nullptr) continue;
    channel.unit = computed->heading.unit;
    for (const Column& column : table.columns) {
      if (column.heading.name != channel.column && column.heading.name != computed->heading.name) continue;
      take_channel(table, column, at, static_cast<int>(c), channel, file, notes);
      break;
    }
  }
  if (!file.channels.empty()) return file;
  std::vector<std::string> known;
  for (const Column& column : curve.columns) known.push_back(column.heading.name);
  const Channel& first = *std::ranges::find(channels, axle, &Channel::axle);
  throw UserError(fmt::format("{}: has no column of a matched quantity of {}, as \"{}\"\n{}", table.header(),
                              curve.name, first.column, nearest_hint(first.quantity, known)));
}

Outcome rig_curve(const FitModel& model, const MeasuredFile& file, const std::vector<Channel>& channels,
                  const std::vector<Unknown>& unknowns, const std::vector<double>& values) {
  double amplitude = 0;
  for (const MeasuredChannel& measured : file.channels)
    for (const double at : measured.at) amplitude = std::max(amplitude, std::abs(at));
  try {
    const Compilation compilation = compilation_at(model, unknowns, values);
    // The curves behind the needed one are left out.
    const KcWatch watch = [&](long done, long) { return done <= static_cast<long>(kPoints) * (file.curve_number + 1); };
    const KcReport report =
        rig_report(compilation, model.arguments, file.axle, settings_out_to(file.curve, amplitude), watch);
    const KcTable* curve = table_named(report, file.curve);
    if (curve == nullptr) return {fmt::format("the rig has no curve {}", file.curve), {}, {}};
    const std::vector<double>& at = curve->columns.front().values;
    if (at.size() < kPoints) return {fmt::format("the curve {} ends early", file.curve), {}, {}};
    Outcome outcome;
    for (const MeasuredChannel& measured : file.channels) {
      const Channel& channel = channels[static_cast<std::size_t>(measured.channel)];
      outcome.series.push_back({at, column_of(*curve, channel.quantity)->values});
    }
    return outcome;
  } catch (const UserError& error) {
    const std::string text = error.what();
    return {text.substr(0, text.find('\n')), {}, {}};
  }
}

}  // namespace mbgen::fit
