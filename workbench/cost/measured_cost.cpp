#include "workbench/cost/measured_cost.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "workbench/cost/bench_text.hpp"
#include "workbench/host/files.hpp"
#include "workbench/host/own_directory.hpp"
#include "workbench/host/temporary_directory.hpp"

namespace mbgen {
namespace {

using MeasuredJson = nlohmann::ordered_json;

constexpr std::size_t kDeepest = 8;  // functions in the text

const char* words_of(StackCount count) {
  return count == StackCount::deepest_path ? "deepest call path" : "sum of all frames";
}

std::string footprint_text(const Footprint& footprint) {
  std::string text = "\n  Bytes\n";
  const std::pair<const char*, long> rows[] = {{"code", footprint.code},
                                               {"read-only data", footprint.read_only},
                                               {"writable data", footprint.writable},
                                               {"unwind tables", footprint.unwind_tables}};
  for (const auto& [title, bytes] : rows) text += fmt::format("  {:<58}{:>12}\n", title, bytes);
  text += fmt::format("\n  Stack, bytes, {}\n", words_of(footprint.stack_count));
  for (std::size_t i = 0; i < footprint.stack.size() && i < kDeepest; ++i) {
    text += fmt::format("  {:<58}{:>12}\n", footprint.stack[i].function, footprint.stack[i].bytes);
  }
  if (footprint.outside.empty()) return text;
  return text + fmt::format("  On top: the frames of {}\n", fmt::join(footprint.outside, ", "));
}

std::string step_text(const StepTime& step) {
  std::string text = fmt::format("\n  Microseconds of a step: {}, {} s, {} evaluations of the accelerations\n",
                                 step.integrator, step.h, step.evaluations);
  for (const SectionTime& section : step.sections) {
    text += fmt::format("  {:<58}{:>12.3f}\n", section.title, section.microseconds);
  }
  text += fmt::format("  {:<58}{:>12.3f}\n", "whole, median", step.median);
  return text + fmt::format("  {:<58}{:>12.3f}\n",
                            fmt::format("whole, slowest of {} steps from the initial state", step.steps), step.slowest);
}

}  // namespace

MeasuredCost measure_cost(const Compilation& compilation, EmitOptions options, std::optional<double> budget) {
  options.runtime_headers = true;
  MeasuredCost cost;
  cost.solver = solver_name(compilation.model);
  const TemporaryDirectory scratch(temporary_parent());
  const HostCompiler compiler = find_compiler(scratch.path(), "-march=native", options.lanes);
  cost.compiler = compiler.version.substr(0, compiler.version.find('\n'));
  cost.flags = fmt::format("{}", fmt::join(compiler.flags, " "));
  cost.processor = processor_name();
  cost.footprint = measure_footprint(emit(compilation, options), cost.solver, compiler, scratch.path());
  cost.step = measure_step(compilation);
  cost.budget = budget;
  return cost;
}

MeasuredJson measured_json(const MeasuredCost& cost, const Compilation& compilation) {
  const Footprint& footprint = cost.footprint;
  MeasuredJson stack = MeasuredJson::array(), sections = MeasuredJson::array();
  for (const StackUse& use : footprint.stack) {
    stack.push_back({{"function", use.function}, {"bytes", use.bytes}, {"path", use.path}});
  }
  for (const SectionTime& section : cost.step.sections) {
    sections.push_back({{"title", section.title}, {"microseconds", section.microseconds}});
  }
  MeasuredJson json = {
      {"mbgen", kMbgenVersion},
      {"model", compilation.model.name},
      {"hash", compilation.model.hash},
      {"form", name_of(compilation.form())},
      {"compiler", cost.compiler},
      {"flags", cost.flags},
      {"processor", cost.processor},
      {"bytes",
       {{"code", footprint.code},
        {"read_only", footprint.read_only},
        {"writable", footprint.writable},
        {"unwind_tables", footprint.unwind_tables}}},
      {"stack", {{"count", words_of(footprint.stack_count)}, {"functions", stack}, {"outside", footprint.outside}}},
      {"step",
       {{"integrator", cost.step.integrator},
        {"seconds", cost.step.h},
        {"steps", cost.step.steps},
        {"evaluations", cost.step.evaluations},
        {"median_us", cost.step.median},
        {"slowest_us", cost.step.slowest},
        {"sections", sections},
        {"leading_section", leading_section(cost.step).title}}}};
  if (cost.budget) json["budget"] = {{"us", *cost.budget}, {"margin_us", *cost.budget - cost.step.slowest}};
  return json;
}

std::string measured_text(const MeasuredCost& cost, const Compilation& compilation) {
  std::string text = fmt::format("# {}, content hash {}, mbgen {}\n# {}\n# {}\n# {}\n", cost.solver,
                                 compilation.model.hash, kMbgenVersion, cost.processor, cost.compiler, cost.flags);
  text += footprint_text(cost.footprint) + step_text(cost.step);
  return cost.budget ? text + "\n  " + budget_text(cost) : text;
}

bool exceeds_budget(const MeasuredCost& cost) { return cost.budget && cost.step.slowest > *cost.budget; }

std::string budget_text(const MeasuredCost& cost) {
  const SectionTime& leading = leading_section(cost.step);
  const std::string step = fmt::format("{}: the slowest step takes {:.3f} us (median {:.3f} us)", cost.solver,
                                       cost.step.slowest, cost.step.median);
  const std::string lead = fmt::format("of the median {:.3f} us are \"{}\"", leading.microseconds, leading.title);
  if (!cost.budget) return fmt::format("{}; {}\n", step, lead);
  const double margin = *cost.budget - cost.step.slowest;
  return fmt::format("{}, {:.3f} us ({:.3g} %) {} the budget of {} us; {}\n", step, std::abs(margin),
                     100 * std::abs(margin) / *cost.budget, margin < 0 ? "over" : "under", *cost.budget, lead);
}

}  // namespace mbgen
