#include "workbench/optimise/optimise.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "compiler/text/characters.hpp"
#include "compiler/text/user_error.hpp"
#include "workbench/describe/names.hpp"
#include "workbench/host/assignments.hpp"
#include "workbench/host/blocked_signals.hpp"
#include "workbench/host/message.hpp"
#include "workbench/host/process.hpp"
#include "workbench/optimise/found_designs.hpp"
#include "workbench/optimise/trade_off.hpp"

namespace mbgen::optimise {
namespace {

Method method_of(const std::string& name, const Wishes& wishes) {
  const auto is_equal = [](const Constraint& one) { return one.kind == Constraint::Kind::equal; };
  if (name == "mma" && std::ranges::any_of(wishes.constraints, is_equal))
    throw UserError("--method mma: takes no equalities: leave out --method, or write two inequalities\n");
  return name == "mma" ? Method::mma : name == "cobyla" ? Method::cobyla : Method::slsqp;
}

/// One line that tells a search from others with other evaluations.
std::string description_of(const OptimiseArguments& arguments, const DesignProblem& problem) {
  using Json = nlohmann::ordered_json;
  const ModelArguments& model = arguments.model;
  Json set = Json::object();
  for (const VariedParameter& parameter : problem.model.set) set[parameter.name] = *parameter.value;
  const auto number = [](const std::optional<double>& value) { return value ? Json(*value) : Json(); };
  std::vector<std::string> tables = problem.wishes.files;
  if (!model.simulation.input_table.empty()) tables.push_back(model.simulation.input_table);
  const Json words = {{"mbgen", kMbgenVersion},
                      {"model", problem.model.model.hash},
                      {"set", set},
                      {"free", arguments.free},
                      {"goal", arguments.goals},
                      {"constraint", arguments.constraints},
                      {"tables", hashes_of_files(tables)},
                      {"manoeuvre", hashes_of_files(arguments.manoeuvres)},
                      {"method", arguments.method},
                      {"trade-off", {arguments.trade_off, arguments.points}},
                      {"starts", arguments.starts},
                      {"most", arguments.most_evaluations},
                      {"rig",
                       {number(arguments.rig.travel), number(arguments.rig.steer), number(arguments.rig.force),
                        number(arguments.rig.moment)}},
                      {"engine", problem.model.choice.name},
                      {"integrator", name_of(problem.model.choice.integrator)},
                      {"step", model.simulation.step.value_or(problem.model.model.solver.step)},
                      {"duration", model.simulation.duration.value_or(problem.model.model.solver.duration)},
                      {"input", model.engine.inputs},
                      {"interpolation", model.simulation.interpolation}};
  return words.dump(-1, ' ', false, Json::error_handler_t::replace);
}

/// Kind of the derivatives, in words.
std::string derivatives_of(const DesignProblem& problem) {
  const auto has = [](const MeasureSource& source) { return source.has_derivatives(); };
  if (std::ranges::all_of(problem.measures.sources, has)) return "exact";
  return std::ranges::any_of(problem.measures.sources, has) ? "exact of the motion, else central differences"
                                                            : "central differences";
}

/// The responses at the start values, exact where they can be: a motion without exact derivatives there goes on by
/// differences. Fails: UserError where the model has no result at the start.
Responses start_responses(DesignProblem& problem, const std::vector<double>& start) {
  for (MeasureSource& source : problem.measures.sources) {
    if (!source.has_derivatives()) continue;
    const SourceValues exact =
        evaluate(source, problem.model, problem.variables, problem.measures.measures, start, true, problem.is_stopped);
    if (exact.failure.empty()) continue;
    source.why_differences = first_line(exact.failure);
    source.solver.tangents = nullptr;
  }
  Responses responses = responses_at(problem, start, false);
  if (!responses.failure.empty() && !problem.is_stopped())
    throw UserError(
        fmt::format("optimise: no result at the start values: {}\n  hint: other start values, --free "
                    "NAME=LOW:START:HIGH, or a smaller --step\n",
                    responses.failure));
  for (const MeasureSource& source : problem.measures.sources)
    if (source.solver.table && source.study.manoeuvre.empty() && !source.why_differences.empty())
      print_message("optimise: {}: derivatives by differences: {}\n", source.name, source.why_differences);
  return responses;
}

/// Two goals.
using GoalPair = std::pair<std::size_t, std::size_t>;

/// Goals of --trade-off, none without it. Fails: UserError.
std::optional<GoalPair> goals_of_trade_off(const std::string& text, const Wishes& wishes) {
  if (text.empty()) return {};
  std::vector<std::string> names;
  for (const Goal& goal : wishes.goals) names.push_back(goal.name);
  const std::vector<std::string> typed = split_list({text});
  std::vector<std::size_t> found;
  for (const std::string& name : typed) {
    const auto place = std::ranges::find(names, name);
    if (place == names.end())
      throw UserError(fmt::format("--trade-off: no goal is called {}\n{}", in_quotes(name), nearest_hint(name, names)));
    found.push_back(static_cast<std::size_t>(place - names.begin()));
  }
  if (found.size() != 2 || found[0] == found[1])
    throw UserError(fmt::format("--trade-off: must be GOAL,GOAL, two names of --goal, found {}\n", in_quotes(text)));
  if (wishes.goals.size() > 2)
    throw UserError(
        fmt::format("--trade-off: is of two goals, found {}: write the others as --constraint\n", wishes.goals.size()));
  return GoalPair{found[0], found[1]};
}

void check_arguments(const OptimiseArguments& arguments) {
  if (!has_nlopt())
    throw UserError(
        "optimise: this mbgen is built without NLopt: install it (Debian: apt-get install libnlopt-dev) and build "
        "again\n");
  if (arguments.goals.empty()) throw UserError("optimise: give --goal\n");
  if (!arguments.trade_off.empty() && arguments.starts > 1)
    throw UserError("optimise: --trade-off starts each point from its neighbour: leave out --global\n");
}

/// The whole problem at its start: read, prepared, with numbers for targets and limits.
void read_problem(const OptimiseArguments& arguments, FreeModel& model, DesignProblem& problem) {
  problem.variables = free_parameters(model.model, arguments.free);
  for (const Unknown& variable : problem.variables)
    if (variable.is_physical)
      throw UserError(fmt::format("--free {0}=physical: is of fit alone: give bounds, {0}=LOW:HIGH\n", variable.name));
  RigReports rigs;
  problem.wishes = read_wishes(model, arguments.goals, arguments.constraints, arguments.manoeuvres, rigs);
  problem.method = method_of(arguments.method, problem.wishes);
  problem.jobs = arguments.jobs;
  problem.most_evaluations = arguments.most_evaluations;
  const auto is_mode = [](const Measure& measure) { return measure.of == Measure::Of::mode; };
  prepare(model, problem.variables, {false, std::ranges::any_of(problem.wishes.measures, is_mode)});
  if (!model.is_tuned) print_message("optimise: the model is analysed anew for each value: {}\n", model.why_not_tuned);
  problem.measures =
      with_sources(model, problem.variables, problem.wishes.measures, {arguments.manoeuvres, arguments.rig}, rigs);
  for (const MeasureSource& source : problem.measures.sources)
    if (source.of == MeasureSource::Of::motion) model.choice = source.study.choice;
}

/// A design whose motions are doubted is not ok.
void doubt(const Responses& at, FoundDesign& design, std::vector<std::string>& warnings) {
  for (const std::string& warning : at.warnings) warnings.push_back("at the result: " + warning);
  if (!at.warnings.empty() && design.is_ok()) design.status = "doubted, see the warnings";
}

/// Variables that no goal and no constraint depends on.
void warn_of_idle(const DesignProblem& problem, const Design& start, std::vector<std::string>& warnings) {
  for (std::size_t v = 0; v < problem.variables.size(); ++v)
    if (start.derivatives.col(static_cast<Eigen::Index>(v)).isZero(0.0))
      warnings.push_back(
          fmt::format("{}: no goal and no constraint depends on it at the start", problem.variables[v].name));
}

/// Searches, and takes what was found into the result.
void search_all(const OptimiseArguments& arguments, const DesignProblem& problem, const std::optional<GoalPair>& pair,
                const std::vector<double>& start, const Responses& before, Designs& designs, OptimiseResult& result) {
  Design first;
  if (!designs.evaluate(start, true, first)) {
    if (problem.is_stopped()) return;
    throw UserError(fmt::format("optimise: no derivatives at the start values: {}\n", designs.refused().back().reason));
  }
  warn_of_idle(problem, first, result.warnings);
  if (pair) {
    const auto [one, other] = *pair;
    result.first = problem.wishes.goals[one].name;
    result.second = problem.wishes.goals[other].name;
    for (const SearchedDesign& found : trade_off(problem, one, other, arguments.points, start, designs)) {
      result.trade_off.push_back(found_design(problem, first, found, before.list));
      doubt(responses_at(problem, found.design.values, false), result.trade_off.back(), result.warnings);
    }
    return;
  }
  const std::vector<std::optional<SearchedDesign>> found =
      search_from_starts(problem, {.start = start}, arguments.starts, designs);
  const SearchedDesign* best = nullptr;
  for (const std::optional<SearchedDesign>& one : found) {
    if (one && (best == nullptr || is_better(*one, *best))) best = &*one;
    result.starts.push_back(one ? FoundStart{one->design.values, one->status, one->point.goal}
                                : FoundStart{{}, "the model has no result at this start", 0});
  }
  if (best == nullptr) return;
  result.best = found_design(problem, first, *best, before.list);
  const Responses after = responses_at(problem, best->design.values, false);
  if (after.failure.empty()) result.curves = found_curves(problem, before.list, after.list);
  doubt(after, result.best, result.warnings);
  const auto is_target = [](const Goal& goal) { return goal.kind == Goal::Kind::target; };
  const bool is_met = best->point.goal == 0 && std::ranges::all_of(problem.wishes.goals, is_target);
  if (best->design.values != start || !result.best.is_ok() || is_met) return;
  result.warnings.push_back("the start is stationary: another start tells whether it is the best or a saddle");
  if (best->point.gradient.isZero(0.0)) result.best.status = "doubted, see the warnings";
}

}  // namespace

OptimiseResult optimise_model(const OptimiseArguments& arguments) {
  check_arguments(arguments);
  FreeModel model = read_free_model(arguments.model);
  DesignProblem problem{.model = model};
  read_problem(arguments, model, problem);
  const std::optional<GoalPair> pair = goals_of_trade_off(arguments.trade_off, problem.wishes);
  BlockedSignals signals;
  problem.is_stopped = [&] { return signals.taken() != 0; };
  std::vector<double> start;
  for (const Unknown& variable : problem.variables) start.push_back(variable.start);
  const Responses before = start_responses(problem, start);
  if (signals.taken() != 0) throw Interrupted{signals.taken()};
  set_numbers(before.list, problem.wishes);
  for (const Response& response : before.list) problem.lengths.push_back(response.values.size());
  EvaluationJournal journal(arguments.journal, "optimise", description_of(arguments, problem), arguments.restart);
  if (journal.known() > 0) print_message("optimise: {} evaluations were done before\n", journal.known());
  Designs designs(problem, journal);
  OptimiseResult result{.model = model.model.name,
                        .model_file = arguments.model.path,
                        .engine = model.choice.name,
                        .method = arguments.method,
                        .derivatives = derivatives_of(problem),
                        .set = model.set};
  search_all(arguments, problem, pair, start, before, designs, result);
  if (signals.taken() != 0) throw Interrupted{signals.taken()};
  result.refused = designs.refused();
  result.course = designs.course();
  result.evaluations = designs.count();
  result.with_derivatives = designs.count_with_derivatives();
  result.files = model.model.files;
  result.files.insert(result.files.end(), problem.wishes.files.begin(), problem.wishes.files.end());
  result.files.insert(result.files.end(), arguments.manoeuvres.begin(), arguments.manoeuvres.end());
  return result;
}

}  // namespace mbgen::optimise
