#pragma once
// The data of a fit: measured runs and rig curves, channel by channel.

#include <optional>
#include <string>
#include <vector>

#include "workbench/fit/channels.hpp"
#include "workbench/motion/input_table.hpp"
#include "workbench/motion/simulation_arguments.hpp"
#include "workbench/search/measured_table.hpp"

namespace mbgen::fit {

/// Values of one channel in one file, in the units of the model; gaps are left out.
struct MeasuredChannel {
  int channel = -1;
  std::vector<double> at, values;   ///< at: s, or the abscissa of a rig's curve
  std::size_t work = 0, place = 0;  ///< the work of FitProblem that gives its series, and where
};

/// One file: a run, or points of a rig's curve.
struct MeasuredFile {
  std::string path;
  bool is_held_out = false;
  bool is_of_points = false;          ///< single numbers at the start of the model
  std::string axle = {}, curve = {};  ///< of a rig; "" of a run
  std::vector<MeasuredChannel> channels = {};
  std::optional<InputTable> inputs = {};  ///< columns that are inputs of the model
  double end = 0;                         ///< s, of a run: its last row

  bool is_of_rig() const { return !axle.empty(); }
  bool is_run() const { return !is_of_rig() && !is_of_points; }
};

/// Reads a run. notes: lines for standard error on gaps, and on channels that the file lacks. Fails: UserError with
/// file and line: as read_measured_table, times_of, in_unit; no column of a channel, a channel without values or that
/// never moves, an input with a gap.
MeasuredFile read_run(const MeasuredTable& table, const Model& model, const std::vector<Channel>& channels,
                      bool is_held_out, std::vector<std::string>& notes);

/// Takes the values of a column into a channel of a file; at: its abscissas. Fails: UserError, as read_run.
void take_channel(const MeasuredTable& table, const Column& column, const std::vector<double>& at, int channel,
                  const Channel& of, MeasuredFile& file, std::vector<std::string>& notes);

}  // namespace mbgen::fit
