#include "workbench/fit/rig_curve.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>

#include "compiler/text/user_error.hpp"
#include "workbench/host/assignments.hpp"
#include "workbench/host/message.hpp"
#include "workbench/search/rig.hpp"

namespace mbgen::fit {
namespace {

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

}  // namespace

MeasuredFile read_rig(const MeasuredTable& table, const FreeModel& model, RigReports& reports,
                      std::vector<Channel>& channels, bool is_held_out, std::vector<std::string>& notes) {
  const std::string axle = axle_of(table, model.model, channels);
  const KcReport& report = outline_of_rig(model, axle, reports);
  const KcTable& curve = curve_of_table(table, report, false);
  MeasuredFile file{.path = table.path, .is_held_out = is_held_out, .axle = axle, .curve = curve.name};
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

Measure measure_of(const MeasuredFile& file, const MeasuredChannel& measured, const Channel& channel) {
  if (channel.measure) return *channel.measure;
  return {.of = Measure::Of::curve,
          .name = channel.name,
          .unit = channel.unit,
          .axle = file.axle,
          .curve = file.curve,
          .part = channel.quantity,
          .at = measured.at};
}

}  // namespace mbgen::fit
