#include "workbench/cost/bench_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

#include "compiler/solver/programs.hpp"
#include "compiler/text/json_text.hpp"
#include "workbench/cost/paper_tables.hpp"

namespace mbgen {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kColumn = 11;

/// Name and version of the compiler that built mbgen, "gcc 12.2.0".
std::string compiler_name() {
#if defined(__clang__)
  return fmt::format("clang {}", __clang_version__);
#elif defined(__GNUC__)
  return fmt::format("gcc {}", __VERSION__);
#else
  return "unknown compiler";
#endif
}

/// The paper's table of this vehicle, null when it has none.
const PaperTable* paper_table(const std::string& model) {
  for (const PaperTable& table : kPaperTables) {
    if (table.model == model) return &table;
  }
  return nullptr;
}

/// Name of an engine with its options: "generic eigen qr", "generated x8" for batches of eight.
std::string full_name(const Engine& engine) {
  std::string name = engine.name;
  if (!engine.linear_algebra.empty()) name += " " + engine.linear_algebra;
  if (engine.batch > 1) name += fmt::format(" x{}", engine.batch);
  return name;
}

std::string header_line(const std::vector<Measurement>& columns, const PaperTable* paper) {
  std::string line = fmt::format("  {:<38}", "step");
  for (const Measurement& m : columns) {
    line +=
        fmt::format("{:>{}}", m.engine->linear_algebra.empty() ? m.engine->name : m.engine->linear_algebra, kColumn);
  }
  if (paper != nullptr) {
    line += "  |";
    for (const PaperColumn& column : paper->columns) line += fmt::format("{:>{}}", column.implementation, kColumn);
  }
  return line + "\n";
}

/// Seconds of all steps of the engines that have steps, beside the paper's.
std::string step_table(const BenchRecord& record) {
  const PaperTable* paper = paper_table(record.model);
  std::vector<Measurement> columns;
  for (const Measurement& m : record.measurements) {
    if (m.steps) columns.push_back(m);
  }
  if (columns.empty()) return "";
  const double scale = 1e-6 * static_cast<double>(record.evaluations);
  std::string text = fmt::format("  seconds for {} evaluations{}\n", record.evaluations,
                                 paper == nullptr ? ""
                                                  : fmt::format("; right: the paper's, for {} on its machine of "
                                                                "2011",
                                                                kPaperEvaluations));
  text += header_line(columns, paper);
  for (int step = 0; step < kSteps; ++step) {
    text += fmt::format("  {:<38}", kStepTitles[step]);
    for (const Measurement& m : columns) text += fmt::format("{:>{}.3g}", scale * (*m.steps)[step], kColumn);
    if (paper != nullptr) {
      text += "  |";
      for (const PaperColumn& column : paper->columns) text += fmt::format("{:>{}.3f}", column.seconds[step], kColumn);
    }
    text += "\n";
  }
  text += fmt::format("  {:<38}", "elapsed time");
  for (const Measurement& m : columns) text += fmt::format("{:>{}.3g}", scale * m.microseconds, kColumn);
  if (paper != nullptr) {
    text += "  |";
    for (const PaperColumn& column : paper->columns) text += fmt::format("{:>{}.3f}", column.total, kColumn);
  }
  text += "\n";
  const bool recursive = std::any_of(columns.begin(), columns.end(),
                                     [](const Measurement& m) { return m.engine->form == name_of(Form::recursive); });
  if (recursive) {
    text +=
        "  The recursive form has its inertias in step 7, its elimination to the root in 8, the way back in 9\n"
        "  (docs/method/recursive.md); --form matrix has the paper's steps.\n";
  }
  return text + "\n";
}

std::string engine_table(const BenchRecord& record) {
  std::string text = fmt::format("  {:<22}{:<10}{:>16}{:>14}{:>10}{:>14}{:>16}\n", "engine", "form", "us/evaluation",
                                 "evaluations", "spread", "times first", "largest error");
  const double first = record.measurements.front().microseconds;
  for (const Measurement& m : record.measurements) {
    text +=
        fmt::format("  {:<22}{:<10}{:>16.3f}{:>14}{:>8.1f} %{:>14.1f}{:>16.1e}\n", full_name(*m.engine), m.engine->form,
                    m.microseconds, m.evaluations, 100 * m.spread, m.microseconds / first, m.largest_error);
  }
  return text;
}

}  // namespace

std::string processor_name() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with("model name")) return line.substr(std::min(line.size(), line.find(':') + 2));
  }
  return "unknown processor";
}

std::string bench_text(const BenchRecord& record) {
  return fmt::format("{}: all accelerations of one state; {}, mbgen built by {}\n", record.model, processor_name(),
                     compiler_name()) +
         step_table(record) + engine_table(record);
}

std::string bench_json(const BenchRecord& record) {
  Json engines = Json::array();
  for (const Measurement& m : record.measurements) {
    Json engine = {
        {"name", m.engine->name},   {"form", m.engine->form},       {"linear_algebra", m.engine->linear_algebra},
        {"batch", m.engine->batch}, {"evaluations", m.evaluations}, {"us_per_evaluation", m.microseconds},
        {"spread", m.spread}};
    if (m.steps) engine["steps"] = *m.steps;
    engine["max_relative_error"] = m.largest_error;
    engines.push_back(std::move(engine));
  }
  Json result = {{"model", record.model},
                 {"evaluations", record.evaluations},
                 {"processor", processor_name()},
                 {"compiler", compiler_name()},
                 {"engines", engines}};
  if (const PaperTable* paper = paper_table(record.model)) {
    result["paper"] = Json::array();
    for (const PaperColumn& column : paper->columns) {
      result["paper"].push_back({{"implementation", column.implementation},
                                 {"evaluations", kPaperEvaluations},
                                 {"steps_seconds", column.seconds},
                                 {"total_seconds", column.total}});
    }
  }
  return json_text(result);
}

}  // namespace mbgen
