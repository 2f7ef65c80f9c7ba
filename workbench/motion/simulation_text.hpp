#pragma once
// A motion as text: the table's header and rows, and the summary.

#include <memory>
#include <string>
#include <vector>

#include "workbench/motion/error_control.hpp"
#include "workbench/motion/simulation.hpp"
#include "workbench/motion/step_verdict.hpp"
#include "workbench/results/results.hpp"
#include "workbench/start/initial_state.hpp"

namespace mbgen {

/// Names and units of all columns: t, coordinates, velocities, auxiliary states, outputs, residual.
std::vector<Heading> headings(const Compilation& compilation);

/// The numbers of one point, in the order of the headings. decimals: of the step, and at most so many of the time.
std::vector<double> table_row(const Sample& sample, int decimals);

/// Result of a manoeuvre in words, empty without one.
struct ManoeuvreWords {
  std::string lines;    ///< for people
  std::string members;  ///< of a JSON object, as text
};

/// A finished simulation.
struct SimulationRecord {
  const Compilation& compilation;
  EngineChoice choice;
  SimulationSettings settings;
  const SimulationSummary& summary;
  std::string file;
  long rows = 0, every = 1;  ///< of the table: how many, and how many steps from one to the next
  StepVerdict verdict;
  std::vector<MovedValue> moved;  ///< of the start
  std::vector<std::string> set;   ///< parameters that the command line gave, name=value
  bool are_inputs_constant = true;
  std::shared_ptr<const ErrorControlRecord> control = nullptr;  ///< of a motion with error control
  ManoeuvreWords manoeuvre = {};
};

/// Singular positions that the motion passed, in words behind a status; "" if there are none.
std::string passages_text(const Topology& topology, const SimulationSummary& summary);

/// For people: steps, real-time factor, closure residual, energy balance, ranges of the outputs and of changing inputs.
std::string summary_text(const SimulationRecord& record);

/// The same for programs.
std::string summary_json(const SimulationRecord& record);

/// Text beside or in a table by which `report` finds the model: its file relative to the table's directory, its hash,
/// and the summary without times and other values that change from run to run.
std::string run_json(const SimulationRecord& record);

}  // namespace mbgen
