#include "workbench/motion/simulation_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "compiler/model/auxiliary_states.hpp"
#include "compiler/text/json_text.hpp"
#include "compiler/text/number.hpp"
#include "workbench/describe/names.hpp"
#include "workbench/host/files.hpp"
#include "workbench/motion/input_table.hpp"

namespace mbgen {
namespace {

using Json = nlohmann::ordered_json;

/// End of the run, in words.
std::string status_text(const SimulationRecord& record) {
  const SimulationSummary& summary = record.summary;
  const StepVerdict& verdict = record.verdict;
  if (!summary.status.ok()) return describe(record.compilation, summary.status);
  if (!verdict.failure.empty()) return verdict.outcome;
  if (summary.is_stopped) return "interrupted";
  const std::size_t warnings = verdict.warnings.size();
  return (warnings == 0   ? "ok"
          : warnings == 1 ? "1 warning"
                          : fmt::format("{} warnings", warnings)) +
         passages_text(record.compilation.topology, summary);
}

Json ranges_json(const std::vector<Range>& ranges, const auto& named) {
  Json list = Json::object();
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    list[named[i].name] = {{"smallest", ranges[i].smallest}, {"largest", ranges[i].largest}, {"last", ranges[i].last}};
  }
  return list;
}

/// Smallest, largest and last value of outputs or inputs, a line each below a heading.
std::string ranges_text(const char* heading, const std::vector<Range>& ranges, const auto& named) {
  std::size_t width = 0;
  for (const auto& one : named) width = std::max(width, one.name.size() + unit_or_one(one.unit).size() + 3);
  std::string text;
  if (!ranges.empty()) {
    text += fmt::format("  {:<{}}{:>14}{:>14}{:>14}\n", heading, width, "smallest", "largest", "last");
  }
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    const Range& range = ranges[i];
    text += fmt::format("  {:<{}}{:>14.6g}{:>14.6g}{:>14.6g}\n",
                        fmt::format("{} [{}]", named[i].name, unit_or_one(named[i].unit)), width, range.smallest,
                        range.largest, range.last);
  }
  return text;
}

/// Number of the motion's points in the table.
std::string rows_text(const SimulationRecord& record) {
  return record.every == 1 ? fmt::format("{} rows, every step", record.rows)
                           : fmt::format("{} rows, every {} steps and the last", record.rows, record.every);
}

Json known_or_null(double value) { return value > 0 ? Json(value) : Json(nullptr); }

/// Simulated time over `seconds`.
double real_time_factor(const SimulationRecord& record, double seconds) {
  const double simulated = static_cast<double>(record.summary.steps) * record.settings.step;
  return seconds > 0 ? simulated / seconds : 0;
}

/// Name of the integrator on the command line.
const char* integrator_name(const SimulationRecord& record) {
  return record.control ? name_of(record.control->control.method) : name_of(record.choice.integrator);
}

/// Steps of a motion with error control.
std::string control_text(const ErrorControlRecord& control) {
  return fmt::format(
      "  error control             tolerance {:.3g}: {} steps of {:.3g} to {:.3g} s, order up to {}, {} rejected, "
      "{} not solved,\n                            {} evaluations, {} Jacobians, {} restarts, {} at corners\n",
      control.control.tolerance, control.steps, control.shortest, control.longest, control.largest_order,
      control.rejected, control.not_solved, control.evaluations, control.jacobians, control.restarts, control.corners);
}

Json control_json(const ErrorControlRecord& control) {
  return {{"tolerance", control.control.tolerance},
          {"steps", control.steps},
          {"shortest_step", known_or_null(control.shortest)},
          {"longest_step", known_or_null(control.longest)},
          {"largest_order", control.largest_order},
          {"rejected", control.rejected},
          {"not_solved", control.not_solved},
          {"evaluations", control.evaluations},
          {"jacobians", control.jacobians},
          {"restarts", control.restarts},
          {"corners", control.corners}};
}

bool met_something(const BlockEvents& block) { return block.chosen_again > 0 || block.near_singular > 0; }

/// Notices of the loop blocks, a line or two for each of them.
std::string blocks_text(const SimulationRecord& record) {
  std::string text;
  for (std::size_t b = 0; b < record.summary.blocks.size(); ++b) {
    const BlockEvents& block = record.summary.blocks[b];
    if (!met_something(block)) continue;
    text += fmt::format("  loops {}: coordinates chosen again in {} steps, near a singular position in {} steps\n",
                        fmt::join(loop_names(record.compilation.topology, record.compilation.topology.blocks[b]), ", "),
                        block.chosen_again, block.near_singular);
    if (block.singular_met == 0) continue;
    text += fmt::format("    singular positions passed: {}, at t = {:.6g}{} s\n", block.singular_met,
                        fmt::join(block.singular_times, ", "),
                        block.singular_met > static_cast<long>(block.singular_times.size()) ? ", ..." : "");
  }
  return text;
}

/// Steps that were made in parts: an embedded solver makes them as a whole.
std::string parts_text(const SimulationSummary& summary) {
  if (summary.parted_steps == 0) return "";
  return fmt::format("  {} in parts, {}at t = {:.6g} s: laws of t or held inputs change there\n",
                     summary.parted_steps == 1 ? "a step" : fmt::format("{} steps", summary.parted_steps),
                     summary.parted_steps == 1 ? "" : "the first ", summary.first_parted);
}

Json blocks_json(const SimulationRecord& record) {
  Json blocks = Json::array();
  for (std::size_t b = 0; b < record.summary.blocks.size(); ++b) {
    const BlockEvents& block = record.summary.blocks[b];
    if (!met_something(block)) continue;
    blocks.push_back({{"loops", loop_names(record.compilation.topology, record.compilation.topology.blocks[b])},
                      {"chosen_again_steps", block.chosen_again},
                      {"near_singular_steps", block.near_singular},
                      {"singular_positions", block.singular_met},
                      {"singular_times", block.singular_times}});
  }
  return blocks;
}

/// Notes on a result, first the reason for a wrong one.
Json warnings_json(const SimulationRecord& record) {
  Json list = record.verdict.warnings;
  if (!record.verdict.failure.empty()) list.insert(list.begin(), record.verdict.failure);
  return list;
}

/// Results of a run that are the same on every machine and at every time.
Json results_json(const SimulationRecord& record) {
  const SimulationSummary& summary = record.summary;
  Json results = {
      {"model", record.compilation.model.name},
      {"engine", record.choice.name},
      {"integrator", integrator_name(record)},
      {"stabilisation", name_of(record.choice.stabilisation)},
      {"moved_start", moved_json(record.compilation, record.moved)},
      {"steps", summary.steps},
      {"step", record.settings.step},
      {"end_time", summary.end_time},
      {"status", status_text(record)},
      {"steps_in_parts", summary.parted_steps},
      {"blocks", blocks_json(record)},
      {"position_residual", summary.largest.position},
      {"velocity_residual", summary.largest.velocity},
      {"energy_change", summary.energy.change},
      {"work", summary.energy.work},
      {"energy_error", summary.energy.error()},
      {"relative_energy_error", summary.exchanges_energy() ? Json(summary.energy.relative_error()) : Json(nullptr)},
      {"stable_step", known_or_null(record.verdict.stable_step)},
      {"fitting_step", known_or_null(record.verdict.fitting_step)},
      {"warnings", warnings_json(record)},
      {"outputs", ranges_json(summary.outputs, record.compilation.model.outputs)},
      {"inputs", ranges_json(summary.inputs, record.compilation.model.inputs)},
      {"every", record.every},
      {"rows", record.rows}};
  if (!record.manoeuvre.members.empty()) results.update(Json::parse(record.manoeuvre.members));
  if (record.control) results["error_control"] = control_json(*record.control);
  return results;
}

}  // namespace

std::string passages_text(const Topology& topology, const SimulationSummary& summary) {
  long count = 0;
  double first = 0;
  std::size_t where = 0;
  for (std::size_t b = 0; b < summary.blocks.size(); ++b) {
    const BlockEvents& block = summary.blocks[b];
    if (block.singular_met == 0) continue;
    if (count == 0 || block.singular_times.front() < first) first = block.singular_times.front(), where = b;
    count += block.singular_met;
  }
  if (count == 0) return "";
  return fmt::format(", {} singular position{} passed, {}loops {} at t = {:.6g} s", count, count == 1 ? "" : "s",
                     count == 1 ? "" : "first by ", fmt::join(loop_names(topology, topology.blocks[where]), ", "),
                     first);
}

std::vector<Heading> headings(const Compilation& compilation) {
  std::vector<Heading> result = {{"t", "s"}};
  for (const TreeBody& body : compilation.topology.bodies) {
    result.push_back({"z." + body.coordinate, unit_of(body.kind)});
  }
  for (const TreeBody& body : compilation.topology.bodies) {
    result.push_back({"zd." + body.coordinate, fmt::format("{}/s", unit_of(body.kind))});
  }
  for (const AuxiliaryState& state : auxiliary_states(compilation.model))
    result.push_back({"x." + state.name, state.unit});
  for (const Output& output : compilation.model.outputs) result.push_back({output.name, unit_or_one(output.unit)});
  result.push_back({"residual", "m"});
  return result;
}

std::vector<double> table_row(const Sample& sample, int decimals) {
  std::vector<double> row = {on_decimals(sample.state.t, decimals)};
  for (const auto* values : {&sample.state.z, &sample.state.zd, &sample.state.x, &sample.outputs.y}) {
    row.insert(row.end(), values->begin(), values->end());
  }
  row.push_back(sample.residuals.position);
  return row;
}

std::string summary_text(const SimulationRecord& record) {
  const SimulationSummary& summary = record.summary;
  const EnergyBalance& energy = summary.energy;
  std::string text = fmt::format("{}: {} steps of {:.6g} s, engine {}, integrator {}, {}\n",
                                 record.compilation.model.name, summary.steps, record.settings.step, record.choice.name,
                                 integrator_name(record), name_of(record.choice.stabilisation));
  if (record.control) text += control_text(*record.control);
  text += fmt::format("  real-time factor          {:.4g} (simulated time over {:.4g} s in the steps)\n",
                      real_time_factor(record, summary.solver_seconds), summary.solver_seconds);
  text += fmt::format("    with outputs and table  {:.4g} (over {:.4g} s from start to end)\n",
                      real_time_factor(record, summary.wall_seconds), summary.wall_seconds);
  text += fmt::format("  largest closure residual  {:.2e} m, {:.2e} m/s\n", summary.largest.position,
                      summary.largest.velocity);
  text +=
      fmt::format("  energy                    changed by {:.6g} J, work {:.6g} J, error {:.2e} J ({})\n",
                  energy.change, energy.work, energy.error(),
                  summary.exchanges_energy() ? fmt::format("{:.1e} relative", energy.relative_error()) : "rounding");
  text += fmt::format("  status                    {} at t = {:.6g} s\n", status_text(record), summary.end_time);
  text += parts_text(summary);
  text += blocks_text(record);
  text += record.manoeuvre.lines;
  if (!record.are_inputs_constant) text += ranges_text("input", summary.inputs, record.compilation.model.inputs);
  text += ranges_text("output", summary.outputs, record.compilation.model.outputs);
  return text + fmt::format("  table                     {} ({})\n", shown_name(record.file), rows_text(record));
}

std::string summary_json(const SimulationRecord& record) {
  Json report = results_json(record);
  const SimulationSummary& summary = record.summary;
  report.update({{"solver_seconds", summary.solver_seconds},
                 {"wall_seconds", summary.wall_seconds},
                 {"real_time_factor", real_time_factor(record, summary.solver_seconds)},
                 {"real_time_factor_with_outputs", real_time_factor(record, summary.wall_seconds)},
                 {"file", record.file}});
  return json_text(report);
}

std::string run_json(const SimulationRecord& record) {
  const Model& model = record.compilation.model;
  const std::filesystem::path directory = std::filesystem::path(record.file).parent_path();
  Json run = {{"mbgen_run", 1},
              {"model_file", std::filesystem::proximate(model.file, directory.empty() ? "." : directory).string()},
              {"model_hash", model.hash},
              {"set", record.set}};
  run.update(results_json(record));
  return json_text(run);
}

}  // namespace mbgen
