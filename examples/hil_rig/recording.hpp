#pragma once
// Commands over time from a table, as hil_driver --record writes it.

#include <algorithm>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "packet.hpp"

namespace hil_rig {

struct RecordedCommand {
  double time = 0;  ///< s
  Command command;
};

/// The rows of a table with a header and the columns t, steering, drive_torque; times increase. Throws
/// std::runtime_error.
inline std::vector<RecordedCommand> read_recording(const std::string& name) {
  std::ifstream file(name);
  std::string line;
  if (!std::getline(file, line)) throw std::runtime_error("cannot read " + name);
  std::vector<RecordedCommand> rows;
  while (std::getline(file, line)) {
    RecordedCommand row;
    char rest = 0;
    if (std::sscanf(line.c_str(), "%lf,%lf,%lf%c", &row.time, &row.command.steering, &row.command.drive_torque,
                    &rest) != 3 ||
        (!rows.empty() && row.time <= rows.back().time)) {
      throw std::runtime_error(name + ", row " + std::to_string(rows.size() + 1) + ": '" + line + "'");
    }
    rows.push_back(row);
  }
  if (rows.empty()) throw std::runtime_error(name + " has no rows");
  return rows;
}

/// The command at a time, s: straight between rows, constant before the first and after the last.
inline Command recorded_command(const std::vector<RecordedCommand>& rows, double time) {
  const auto after = std::upper_bound(rows.begin(), rows.end(), time,
                                      [](double t, const RecordedCommand& row) { return t < row.time; });
  if (after == rows.begin()) return rows.front().command;
  if (after == rows.end()) return rows.back().command;
  const RecordedCommand &a = *(after - 1), &b = *after;
  const double s = (time - a.time) / (b.time - a.time);
  return {a.command.steering + s * (b.command.steering - a.command.steering),
          a.command.drive_torque + s * (b.command.drive_torque - a.command.drive_torque)};
}

}  // namespace hil_rig
