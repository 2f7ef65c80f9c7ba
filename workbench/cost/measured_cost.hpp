#pragma once
// The measured part of a cost sheet: the cost of a solver on this machine.

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "workbench/cost/footprint.hpp"
#include "workbench/cost/step_time.hpp"

namespace mbgen {

struct MeasuredCost {
  std::string solver;     ///< name of its files
  std::string compiler;   ///< first line of its own version text
  std::string flags;      ///< that the solver was compiled with
  std::string processor;  ///< that the step was timed on
  Footprint footprint;
  StepTime step;
  std::optional<double> budget;  ///< microseconds that a step may take
};

/// Compiles, counts and times the solver with the additions of `options`.
/// Fails: UserError, see measure_step and find_compiler.
MeasuredCost measure_cost(const Compilation& compilation, EmitOptions options, std::optional<double> budget);

/// `<model>_measured.json`; see docs/use/cost_sheet.md.
nlohmann::ordered_json measured_json(const MeasuredCost& cost, const Compilation& compilation);

/// `<model>_measured.txt`: the same for people.
std::string measured_text(const MeasuredCost& cost, const Compilation& compilation);

/// Whether the slowest step takes longer than the budget.
bool exceeds_budget(const MeasuredCost& cost);

/// One line: the step, by how much it keeps or exceeds the budget, and the section that leads.
std::string budget_text(const MeasuredCost& cost);

}  // namespace mbgen
