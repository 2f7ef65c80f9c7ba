#include "workbench/fit/rig_curve.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compiler/text/user_error.hpp"
#include "workbench/host/assignments.hpp"
#include "workbench/search/rig.hpp"

namespace mbgen::fit {
MeasuredFile read_rig(const MeasuredTable& table, const FreeModel& model, std::vector<Channel>& channels,
                      bool is_held_out, std::vector<std::string>& notes) {
  const auto first = std::find_if(channels.begin(), channels.end(), [](const Channel& one) { return one.is_of_rig(); });
  if (first == channels.end())
    throw UserError(fmt::format("{}: needs a column \"t\", or --match kc:AXLE:COLUMN for points of a rig's curve\n",
                                table.header()));
  const Compilation compilation = expect(decide(model.model));
  const KcReport report = rig_report(compilation, model.arguments, first->axle, {});
  const KcTable& curve = curve_of_table(table, report, false);
  MeasuredFile file{.path = table.path,
                    .is_held_out = is_held_out,
                    .axle = first->axle,
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
  throw UserError(fmt::format("{}: has no column of a matched quantity of {}, as \"{}\"\n{}", table.header(),
                              curve.name, first->column, nearest_hint(first->quantity, known)));
}

Outcome rig_curve(const FreeModel& model, const MeasuredFile& file, const std::vector<Channel>& channels,
                  const std::vector<Unknown>& unknowns, const std::vector<double>& values) {
  double amplitude = 0;
  for (const MeasuredChannel& measured : file.channels)
    for (const double at : measured.at) amplitude = std::max(amplitude, std::abs(at));
  KcSettings settings{.points = kPointsOfCurve};
  reach_out_to(file.curve, amplitude, settings);
  try {
    const Compilation compilation = compilation_at(model, unknowns, values);
    // The curves behind the needed one are left out.
    const KcWatch watch = [&](long done, long) {
      return done <= static_cast<long>(kPointsOfCurve) * (file.curve_number + 1);
    };
    const KcReport report = rig_report(compilation, model.arguments, file.axle, settings, watch);
    const KcTable* curve = curve_named(report, file.curve);
    if (curve == nullptr) return {fmt::format("the rig has no curve {}", file.curve), {}, {}};
    const std::vector<double>& at = curve->columns.front().values;
    if (at.size() < kPointsOfCurve) return {fmt::format("the curve {} ends early", file.curve), {}, {}};
    Outcome outcome;
    for (const MeasuredChannel& measured : file.channels) {
      const Channel& channel = channels[static_cast<std::size_t>(measured.channel)];
      outcome.series.push_back({at, column_of(*curve, channel.quantity)->values});
    }
    return outcome;
  } catch (const UserError& error) {
    return {headline(error.what()), {}, {}};
  }
}

}  // namespace mbgen::fit
