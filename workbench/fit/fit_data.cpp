#include "workbench/fit/fit_data.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compiler/text/user_error.hpp"
#include "workbench/host/assignments.hpp"

namespace mbgen::fit {
namespace {

/// A pause in the rows that is told, in parts of their median distance.
constexpr double kToldPause = 5.5;

std::vector<std::string> names_of(const MeasuredTable& table) {
  std::vector<std::string> names;
  for (const Column& column : table.columns) names.push_back(column.heading.name);
  return names;
}

int column_named(const MeasuredTable& table, const std::string& name) {
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    const Heading& heading = table.columns[c].heading;
    if (heading.name == name || heading_text(heading) == name) return static_cast<int>(c);
  }
  return -1;
}

/// Notes on pauses between rows.
void tell_pauses(const MeasuredTable& table, const std::vector<double>& times, std::vector<std::string>& notes) {
  std::vector<double> distances;
  for (std::size_t row = 1; row < times.size(); ++row) distances.push_back(times[row] - times[row - 1]);
  if (distances.size() < 3) return;
  std::vector<double> sorted = distances;
  std::nth_element(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2), sorted.end());
  const double usual = sorted[sorted.size() / 2];
  const auto longest = std::max_element(distances.begin(), distances.end());
  if (*longest <= kToldPause * usual) return;
  const auto row = static_cast<std::size_t>(longest - distances.begin());
  notes.push_back(fmt::format("{}: note: a pause of {:.4g} s before this row, rows are {:.4g} s apart elsewhere\n",
                              table.place(row + 1), *longest, usual));
}

/// Columns that are inputs of the model.
std::optional<InputTable> inputs_in(const MeasuredTable& table, const Model& model, const std::vector<double>& times) {
  InputTable inputs{table.path, table.header(), times, table.lines, {}, {}};
  for (std::size_t i = 0; i < model.inputs.size(); ++i) {
    const int column = column_named(table, model.inputs[i].name);
    if (column < 0) continue;
    InputColumn of_input{static_cast<int>(i),
                         in_unit(table, table.columns[static_cast<std::size_t>(column)], model.inputs[i].unit)};
    const auto gap =
        std::find_if(of_input.values.begin(), of_input.values.end(), [](double x) { return std::isnan(x); });
    if (gap != of_input.values.end())
      throw UserError(fmt::format("{}: {} has no value, and the motion needs its inputs in every row\n",
                                  table.place(static_cast<std::size_t>(gap - of_input.values.begin())),
                                  model.inputs[i].name));
    inputs.columns.push_back(std::move(of_input));
  }
  if (inputs.columns.empty()) return {};
  return inputs;
}

/// Fails: UserError for a channel without values, or that never moves.
void require_motion(const MeasuredTable& table, const Column& column, const MeasuredChannel& measured,
                    std::size_t first_row) {
  if (measured.values.empty())
    throw UserError(fmt::format("{}: {} has no value in any of its {} rows\n", table.header(), column.heading.name,
                                table.lines.size()));
  const auto [smallest, largest] = std::minmax_element(measured.values.begin(), measured.values.end());
  if (measured.values.size() < 2 || *smallest < *largest) return;
  throw UserError(
      fmt::format("{}: {} never moves: it is {:g} in all {} rows from here on\n  hint: a dead channel would pull the "
                  "parameters: leave it out of --match\n",
                  table.place(first_row), column.heading.name, measured.values.front(), measured.values.size()));
}

}  // namespace

void take_channel(const MeasuredTable& table, const Column& column, const std::vector<double>& at, int channel,
                  const Channel& of, MeasuredFile& file, std::vector<std::string>& notes) {
  const std::vector<double> values = in_unit(table, column, of.unit);
  MeasuredChannel measured{channel, {}, {}};
  std::size_t gaps = 0, first_gap = 0, first_row = values.size();
  for (std::size_t row = 0; row < values.size(); ++row) {
    if (std::isnan(values[row])) {
      if (gaps++ == 0) first_gap = row;
      continue;
    }
    first_row = std::min(first_row, row);
    measured.at.push_back(at[row]);
    measured.values.push_back(values[row]);
  }
  require_motion(table, column, measured, first_row);
  if (gaps > 0)
    notes.push_back(fmt::format("{}: note: {} has no value here{}: left out\n", table.place(first_gap),
                                column.heading.name, gaps == 1 ? "" : fmt::format(", nor in {} other rows", gaps - 1)));
  file.channels.push_back(std::move(measured));
}

MeasuredFile read_run(const MeasuredTable& table, const Model& model, const std::vector<Channel>& channels,
                      bool is_held_out, std::vector<std::string>& notes) {
  MeasuredFile file{.path = table.path, .is_held_out = is_held_out};
  const std::vector<double> times = times_of(table);
  file.end = times.back();
  tell_pauses(table, times, notes);
  std::vector<std::string> missing;
  for (std::size_t c = 0; c < channels.size(); ++c) {
    if (channels[c].is_of_rig() || channels[c].is_of_point()) continue;
    const int column = column_named(table, channels[c].column);
    if (column < 0) {
      missing.push_back(channels[c].column);
    } else {
      take_channel(table, table.columns[static_cast<std::size_t>(column)], times, static_cast<int>(c), channels[c],
                   file, notes);
    }
  }
  if (file.channels.empty())
    throw UserError(fmt::format("{}: has no column of a matched output{}\n{}", table.header(),
                                missing.empty() ? "" : fmt::format(", as \"{}\"", missing.front()),
                                missing.empty() ? "" : nearest_hint(missing.front(), names_of(table))));
  for (const std::string& name : missing)
    notes.push_back(fmt::format("{}: note: no column \"{}\": the run is fitted without it\n", table.header(), name));
  file.inputs = inputs_in(table, model, times);
  return file;
}

}  // namespace mbgen::fit
