#include "compiler/cli/simulation_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>

#include "compiler/cli/json_text.hpp"
#include "compiler/cli/names.hpp"

namespace mbgen::cli {
namespace {

std::string unit_or_one(const std::string& unit) { return unit.empty() ? "1" : unit; }

double relative(const EnergyBalance& energy) { return energy.scale > 0 ? energy.error() / energy.scale : 0; }

/// Simulated time over `seconds`.
double real_time_factor(const SimulationRecord& record, double seconds) {
  const double simulated = static_cast<double>(record.summary.steps) * record.settings.step;
  return seconds > 0 ? simulated / seconds : 0;
}

std::vector<std::string> loop_names(const Compilation& compilation, std::size_t block) {
  std::vector<std::string> names;
  for (const int loop : compilation.topology.blocks[block].loops) {
    names.push_back(compilation.topology.loops[loop].name);
  }
  return names;
}

bool met_something(const BlockEvents& block) { return block.chosen_again > 0 || block.near_singular > 0; }

/// What was met at the loop blocks, a line or two for each of them.
std::string blocks_text(const SimulationRecord& record) {
  std::string text;
  for (std::size_t b = 0; b < record.summary.blocks.size(); ++b) {
    const BlockEvents& block = record.summary.blocks[b];
    if (!met_something(block)) continue;
    text += fmt::format("  loops {}: coordinates chosen again in {} steps, near a singular position in {} steps\n",
                        fmt::join(loop_names(record.compilation, b), ", "), block.chosen_again, block.near_singular);
    if (block.singular_met == 0) continue;
    text += fmt::format("    singular positions passed: {}, at t = {:.6g}{} s\n", block.singular_met,
                        fmt::join(block.singular_times, ", "),
                        block.singular_met > static_cast<long>(block.singular_times.size()) ? ", ..." : "");
  }
  return text;
}

nlohmann::ordered_json blocks_json(const SimulationRecord& record) {
  nlohmann::ordered_json blocks = nlohmann::ordered_json::array();
  for (std::size_t b = 0; b < record.summary.blocks.size(); ++b) {
    const BlockEvents& block = record.summary.blocks[b];
    if (!met_something(block)) continue;
    blocks.push_back({{"loops", loop_names(record.compilation, b)},
                      {"chosen_again_steps", block.chosen_again},
                      {"near_singular_steps", block.near_singular},
                      {"singular_positions", block.singular_met},
                      {"singular_times", block.singular_times}});
  }
  return blocks;
}

}  // namespace

std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char letter : text) {
    if (letter == '"') quoted += '"';
    quoted += letter;
  }
  return quoted + "\"";
}

std::string csv_header(const Compilation& compilation) {
  std::string line = "t [s]";
  for (const TreeBody& body : compilation.topology.bodies) {
    line += fmt::format(",z.{} [{}]", body.coordinate, unit_of(body.kind));
  }
  for (const TreeBody& body : compilation.topology.bodies) {
    line += fmt::format(",zd.{} [{}]", body.coordinate, body.kind == FreedomKind::revolute ? "rad/s" : "m/s");
  }
  for (const Output& output : compilation.model.outputs) {
    line += ',';
    line += csv_field(fmt::format("{} [{}]", output.name, unit_or_one(output.unit)));
  }
  return line + ",residual [m]\n";
}

std::string csv_row(const Sample& sample) {
  std::string line = fmt::format("{}", sample.state.t);
  const auto append = [&line](double value) { fmt::format_to(std::back_inserter(line), ",{}", value); };
  for (const double value : sample.state.z) append(value);
  for (const double value : sample.state.zd) append(value);
  for (const double value : sample.outputs.y) append(value);
  append(sample.residuals.position);
  return line + "\n";
}

std::string summary_text(const SimulationRecord& record) {
  const SimulationSummary& summary = record.summary;
  const EnergyBalance& energy = summary.energy;
  std::string text = fmt::format("{}: {} steps of {:.6g} s, engine {}, integrator {}, {}\n",
                                 record.compilation.model.name, summary.steps, record.settings.step, record.choice.name,
                                 name_of(record.choice.integrator), name_of(record.choice.stabilisation));
  text += fmt::format("  real-time factor          {:.4g} (simulated time over {:.4g} s in the steps)\n",
                      real_time_factor(record, summary.solver_seconds), summary.solver_seconds);
  text += fmt::format("    with outputs and table  {:.4g} (over {:.4g} s from start to end)\n",
                      real_time_factor(record, summary.wall_seconds), summary.wall_seconds);
  text += fmt::format("  largest closure residual  {:.2e} m, {:.2e} m/s\n", summary.largest.position,
                      summary.largest.velocity);
  text +=
      fmt::format("  energy                    changed by {:.6g} J, work {:.6g} J, error {:.2e} J ({:.1e} relative)\n",
                  energy.change, energy.work, energy.error(), relative(energy));
  text += fmt::format("  status                    {} at t = {:.6g} s\n", describe(record.compilation, summary.status),
                      summary.end_time);
  text += blocks_text(record);
  const std::vector<Output>& outputs = record.compilation.model.outputs;
  std::size_t width = 0;
  for (const Output& output : outputs)
    width = std::max(width, output.name.size() + unit_or_one(output.unit).size() + 3);
  if (!summary.outputs.empty()) {
    text += fmt::format("  {:<{}}{:>14}{:>14}{:>14}\n", "output", width, "smallest", "largest", "last");
  }
  for (std::size_t i = 0; i < summary.outputs.size(); ++i) {
    const Range& range = summary.outputs[i];
    text += fmt::format("  {:<{}}{:>14.6g}{:>14.6g}{:>14.6g}\n",
                        fmt::format("{} [{}]", outputs[i].name, unit_or_one(outputs[i].unit)), width, range.smallest,
                        range.largest, range.last);
  }
  return text + fmt::format("  table                     {} ({} rows)\n", record.file, record.rows);
}

std::string summary_json(const SimulationRecord& record) {
  using Json = nlohmann::ordered_json;
  const SimulationSummary& summary = record.summary;
  Json outputs = Json::object();
  for (std::size_t i = 0; i < summary.outputs.size(); ++i) {
    const Range& range = summary.outputs[i];
    outputs[record.compilation.model.outputs[i].name] = {
        {"smallest", range.smallest}, {"largest", range.largest}, {"last", range.last}};
  }
  const Json report = {{"model", record.compilation.model.name},
                       {"engine", record.choice.name},
                       {"integrator", name_of(record.choice.integrator)},
                       {"stabilisation", name_of(record.choice.stabilisation)},
                       {"steps", summary.steps},
                       {"step", record.settings.step},
                       {"end_time", summary.end_time},
                       {"status", describe(record.compilation, summary.status)},
                       {"blocks", blocks_json(record)},
                       {"solver_seconds", summary.solver_seconds},
                       {"wall_seconds", summary.wall_seconds},
                       {"real_time_factor", real_time_factor(record, summary.solver_seconds)},
                       {"real_time_factor_with_outputs", real_time_factor(record, summary.wall_seconds)},
                       {"position_residual", summary.largest.position},
                       {"velocity_residual", summary.largest.velocity},
                       {"energy_change", summary.energy.change},
                       {"work", summary.energy.work},
                       {"energy_error", summary.energy.error()},
                       {"relative_energy_error", relative(summary.energy)},
                       {"outputs", outputs},
                       {"file", record.file},
                       {"rows", record.rows}};
  return json_text(report);
}

}  // namespace mbgen::cli
