#include "bench/compare/comparison.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "bench/compare/agreement.hpp"
#include "compiler/reader/read_model.hpp"
#include "compiler/text/user_error.hpp"
#include "workbench/cost/bench_states.hpp"

namespace mbgen::compare {
namespace {

const Contestant& find(const std::vector<Contestant>& contestants, const std::string& key) {
  for (const Contestant& contestant : contestants)
    if (contestant.key == key) return contestant;
  return contestants.front();
}

/// Whose accelerations count where states bring none: not those of mbgen, if somebody else has any.
const Contestant& reference_of(const std::vector<Contestant>& contestants) {
  const Contestant& foreign = find(contestants, "straightforward");
  return foreign.absent.empty() ? foreign : find(contestants, "generic");
}

/// "coach" of coach_mechanism: the name of the file of states.
std::string states_file(const std::string& model, const std::string& directory) {
  if (directory.empty()) return "";
  const std::string stem = model.substr(0, model.find("_mechanism"));
  const std::filesystem::path path = std::filesystem::path(directory) / (stem + "_states.json");
  return std::filesystem::exists(path) ? path.string() : "";
}

std::vector<FileState> at_rest(std::vector<FileState> states, const Contestant& reference) {
  for (FileState& state : states) {
    state.at.state.zd.assign(state.at.state.zd.size(), 0.0);
    GenericDerivative derivative;
    reference.engine.accelerations(state.at, derivative);
    state.zdd = derivative.zdd;
  }
  return states;
}

Row row_of(const Contestant& contestant, const Contestant& reference, const std::vector<FileState>& states) {
  Row row{contestant.key, contestant.name, contestant.remark, contestant.absent, contestant.exact, 0, {}, {}};
  if (!contestant.absent.empty()) return row;
  row.deviation = deviation(contestant, states);
  if (!contestant.exact) row.deviation_at_rest = deviation(contestant, at_rest(states, reference));
  return row;
}

Model model_of(const std::string& path, bool rods_are_massless) {
  Model model = expect(read_model_file(path));
  std::size_t forces = model.motions.size();
  each_element(model, [&](const auto&) { ++forces; });
  if (forces > 0)
    throw UserError(fmt::format("{}: has force elements or motions, which other solvers do not get\n", path));
  if (!rods_are_massless) return model;
  for (Rod& rod : model.rods) rod.mass = 0.0;
  model.name += "_massless_rods";
  model.file.clear();
  return model;
}

std::optional<double> least(const Comparison& comparison, const std::string& key) {
  for (const Row& row : comparison.rows)
    if (row.key == key && row.timing.evaluations > 0) return row.timing.microseconds.least;
  return {};
}

std::optional<double> ratio(const std::optional<double>& over, const std::optional<double>& under) {
  return over && under ? std::optional(*over / *under) : std::nullopt;
}

std::optional<double> value_of(const Comparison& c, Figure figure) {
  const std::optional<double> single = least(c, "generated");
  switch (figure) {
    case Figure::single_microseconds:
      return single;
    case Figure::lane_microseconds:
      return least(c, "batch8");
    case Figure::times_straightforward:
      return ratio(least(c, "straightforward"), single);
    case Figure::times_mujoco:
      return ratio(least(c, "mujoco"), single);
    case Figure::times_simbody:
      return ratio(least(c, "simbody"), single);
    default:
      break;
  }
  if (!c.code) return {};
  if (figure == Figure::operations) return static_cast<double>(c.code->operations.total());
  if (figure == Figure::hot_bytes) return static_cast<double>(c.code->hot_bytes);
  return figure == Figure::compile_seconds ? c.code->compile_seconds : c.code->generation_seconds;
}

}  // namespace

Comparison compare_on(const std::string& model_path, const Settings& settings) {
  const Model model = model_of(model_path, settings.rods_are_massless);
  const std::string mechanism = model.name.substr(0, model.name.find("_massless_rods"));
  const Compilation compilation = expect(compile(model));
  const std::vector<Contestant> all = contestants(compilation);
  const Contestant& reference = reference_of(all);
  const StatesInUse in_use = states_in_use(compilation, states_file(mechanism, settings.states_directory),
                                           settings.rods_are_massless, find(all, "generic").engine, reference);
  Comparison comparison{mechanism,
                        in_use.source,
                        settings.rods_are_massless,
                        compilation.topology.size(),
                        0,
                        compilation.analysis.degrees_of_freedom,
                        {},
                        {},
                        {}};
  for (const LoopBlock& block : compilation.topology.blocks) comparison.closure_equations += block.equations;
  for (const Contestant& contestant : all) {
    comparison.rows.push_back(row_of(contestant, reference, in_use.states));
    const Row& row = comparison.rows.back();
    if (row.exact && !(row.deviation < kAgreement)) comparison.disagreeing.push_back(row.name);
  }
  if (!comparison.disagreeing.empty()) return comparison;
  const std::vector<LoadedState> at = timed_states(in_use.states, kLanes);
  const std::vector<Timing> timings = time_in_turns(all, at, settings.rounds, settings.seconds);
  for (std::size_t k = 0; k < timings.size(); ++k) comparison.rows[k].timing = timings[k];
  if (settings.counts_code) comparison.code = code_facts(model, at);
  return comparison;
}

std::vector<Verdict> verdicts(const Comparison& comparison) {
  std::vector<Verdict> list;
  for (const Target& target : kTargets)
    if (target.model == comparison.model) list.push_back({target, value_of(comparison, target.figure)});
  return list;
}

}  // namespace mbgen::compare
