#include "workbench/search/start_values.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "compiler/linearisation/linearisation.hpp"
#include "compiler/text/user_error.hpp"
#include "workbench/operating/operating_point.hpp"

namespace mbgen {
namespace {

/// Oscillations by increasing frequency.
std::vector<Mode> oscillations(const FreeModel& model, Compilation& compilation, const OperatingPoint& at) {
  if (model.is_tuned) {
    compilation.whole = model.compilation.whole;
    compilation.emitted = model.compilation.emitted;
    compilation.spelling = model.compilation.spelling;
  }
  if (!compilation.has_programs()) add_programs(compilation);
  std::vector<Mode> list = modes(expect(linearise_by_any_choice(compilation, at)));
  put_slowest_first(list);
  std::erase_if(list, [](const Mode& mode) { return !mode.oscillates(); });
  return list;
}

double value_of(const Measure& measure, const std::vector<Mode>& list, const std::vector<double>& outputs) {
  if (measure.of == Measure::Of::start) return outputs[static_cast<std::size_t>(measure.output)];
  if (static_cast<std::size_t>(measure.mode) > list.size())
    throw UserError(
        fmt::format("{}: the model has {} oscillation{}\n", measure.name, list.size(), list.size() == 1 ? "" : "s"));
  const Mode& mode = list[static_cast<std::size_t>(measure.mode) - 1];
  return measure.part == "frequency" ? mode.undamped_frequency() : mode.damping_ratio();
}

}  // namespace

std::vector<double> start_values(const FreeModel& model, const std::vector<Measure>& measures,
                                 const std::vector<Unknown>& unknowns, const std::vector<double>& values) {
  Compilation compilation = compilation_at(model, unknowns, values);
  StateArguments start;
  start.at = "initial";
  start.inputs = model.arguments.engine.inputs;
  const OperatingPoint at = operating_point(compilation, start).point;
  const std::vector<double> outputs = outputs_at(compilation, at, "at the start");
  const bool needs_modes =
      std::ranges::any_of(measures, [](const Measure& one) { return one.of == Measure::Of::mode; });
  const std::vector<Mode> list = needs_modes ? oscillations(model, compilation, at) : std::vector<Mode>();
  std::vector<double> result;
  for (const Measure& measure : measures) result.push_back(value_of(measure, list, outputs));
  return result;
}

}  // namespace mbgen
