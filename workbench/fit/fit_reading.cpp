#include "workbench/fit/fit_reading.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compiler/text/user_error.hpp"
#include "workbench/fit/point_targets.hpp"
#include "workbench/fit/rig_curve.hpp"
#include "workbench/host/message.hpp"

namespace mbgen::fit {
namespace {

/// First guess of a noise without a given one, in parts of the standard deviation of its data.
constexpr double kFirstNoise = 0.1;

/// Reads the data files. Fails: UserError.
std::vector<MeasuredFile> read_files(const FitArguments& arguments, const FreeModel& model,
                                     std::vector<Channel>& channels, RigReports& rigs) {
  std::vector<MeasuredFile> files;
  std::vector<std::string> notes;
  const auto read = [&](const std::vector<std::string>& paths, bool is_held_out) {
    for (const std::string& path : paths) {
      const MeasuredTable table = read_measured_table(path);
      files.push_back(time_column(table) < 0 ? read_rig(table, model, rigs, channels, is_held_out, notes)
                                             : read_run(table, model.model, channels, is_held_out, notes));
    }
  };
  read(arguments.data, false);
  read(arguments.held_out, true);
  for (const std::string& note : notes) print_message("{}", note);
  if (!arguments.targets.empty())
    files.push_back(point_targets(model.model, arguments.targets, arguments.manoeuvres, channels));
  for (std::size_t c = 0; c < channels.size(); ++c) {
    const auto has_it = [&](const MeasuredFile& file) {
      return !file.is_held_out && std::any_of(file.channels.begin(), file.channels.end(), [&](const auto& measured) {
        return measured.channel == static_cast<int>(c);
      });
    };
    if (std::none_of(files.begin(), files.end(), has_it))
      throw UserError(
          fmt::format("--match {}: no file of --data has a column \"{}\"\n", channels[c].name, channels[c].column));
  }
  return files;
}

/// Bounds and scale of biases, and first guesses of noises, by the sizes of the data.
void set_sizes(FitProblem& problem) {
  for (std::size_t c = 0; c < problem.channels.size(); ++c) {
    Channel& channel = problem.channels[c];
    const double size = size_of(problem.files, static_cast<int>(c));
    if (!channel.has_sigma) channel.sigma = kFirstNoise * size;
    if (channel.bias < 0) continue;
    Unknown& bias = problem.unknowns[static_cast<std::size_t>(channel.bias)];
    bias.lower = -kMostBias * size;
    bias.upper = kMostBias * size;
    bias.scale = size;
    bias.unit = channel.unit;
  }
}

/// Units of figures of rigs and numbers of manoeuvres, which their first evaluation tells.
void take_units(FitProblem& problem) {
  std::vector<double> start;
  for (const Unknown& unknown : problem.unknowns) start.push_back(unknown.start);
  const MeasureSet& set = problem.measures;
  for (const MeasureSource& source : set.sources) {
    const auto has_unit = [&](std::size_t m) {
      return set.measures[m].of != Measure::Of::figure && set.measures[m].of != Measure::Of::manoeuvre;
    };
    if (std::ranges::all_of(source.measures, has_unit)) continue;
    const SourceValues found =
        evaluate(source, problem.model, problem.unknowns, set.measures, start, false, problem.is_stopped);
    for (std::size_t k = 0; k < found.responses.size(); ++k)
      for (Channel& channel : problem.channels)
        if (channel.measure && channel.measure->name == set.measures[source.measures[k]].name)
          channel.unit = found.responses[k].unit;
  }
}

}  // namespace

double deviation_of(const std::vector<double>& values) {
  double sum = 0, squares = 0;
  for (const double value : values) sum += value;
  const double mean = sum / static_cast<double>(values.size());
  for (const double value : values) squares += (value - mean) * (value - mean);
  return std::sqrt(squares / static_cast<double>(values.size()));
}

double size_of(const std::vector<MeasuredFile>& files, int channel) {
  double size = 0;
  for (const MeasuredFile& file : files)
    for (const MeasuredChannel& measured : file.channels)
      if (measured.channel == channel) size = std::max({size, deviation_of(measured.values)});
  return size > 0 ? size : 1;
}

FitProblem read_problem(const FitArguments& arguments, FreeModel& model) {
  std::vector<Channel> channels = matched_channels(model.model, arguments.match);
  std::vector<Unknown> unknowns = free_parameters(model.model, arguments.free);
  RigReports rigs;
  std::vector<MeasuredFile> files = read_files(arguments, model, channels, rigs);
  std::vector<int> runs;
  for (std::size_t f = 0; f < files.size(); ++f)
    if (files[f].is_run() && !files[f].is_held_out) runs.push_back(static_cast<int>(f));
  for (Unknown& unknown : free_starts(model.model, arguments.free_start, runs)) unknowns.push_back(std::move(unknown));
  add_nuisances(arguments.nuisance, channels, unknowns);
  const auto is_run = [](const MeasuredFile& file) { return file.is_run(); };
  const auto is_mode = [](const Channel& channel) {
    return channel.measure && channel.measure->of == Measure::Of::mode;
  };
  prepare(model, unknowns, {std::ranges::any_of(files, is_run), std::ranges::any_of(channels, is_mode)});
  if (!model.is_tuned) print_message("fit: the model is analysed anew for each value: {}\n", model.why_not_tuned);
  std::vector<FreeInertia> inertias = free_inertias(model.model, unknowns);
  FitProblem problem{.model = model,
                     .channels = std::move(channels),
                     .unknowns = std::move(unknowns),
                     .inertias = std::move(inertias),
                     .files = std::move(files),
                     .jobs = arguments.jobs};
  set_sizes(problem);
  plan_work(arguments.manoeuvres, rigs, problem);
  take_units(problem);
  return problem;
}

}  // namespace mbgen::fit
