#pragma once
// A motion as text: the table's header and rows, and the summary.

#include <string>

#include "compiler/cli/simulation.hpp"

namespace mbgen::cli {

/// A field of a CSV file, quoted where it has to be (RFC 4180).
std::string csv_field(const std::string& text);

/// Names and units of all columns, `name [unit]`, with a line end: t, coordinates, velocities, outputs, residual.
std::string csv_header(const Compilation& compilation);

/// The numbers of one point, shortest form that reads back the same, with a line end.
std::string csv_row(const Sample& sample);

/// A finished simulation.
struct SimulationRecord {
  const Compilation& compilation;
  EngineChoice choice;
  SimulationSettings settings;
  const SimulationSummary& summary;
  std::string file;
  long rows = 0;
};

/// For people: steps, real-time factor, closure residual, energy balance, ranges of the outputs.
std::string summary_text(const SimulationRecord& record);

/// The same for machines.
std::string summary_json(const SimulationRecord& record);

}  // namespace mbgen::cli
