#include "workbench/fit/fit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "compiler/reader/read_model.hpp"
#include "compiler/text/hash.hpp"
#include "compiler/text/user_error.hpp"
#include "workbench/describe/names.hpp"
#include "workbench/fit/fit_reading.hpp"
#include "workbench/fit/fit_search.hpp"
#include "workbench/host/files.hpp"
#include "workbench/host/message.hpp"
#include "workbench/host/process.hpp"

namespace mbgen::fit {
namespace {

/// Data, predictions and their differences of a channel.
ChannelFit fit_of(const FitProblem& problem, const MeasuredFile& file, const MeasuredChannel& measured,
                  const Series& series, const std::vector<double>& values) {
  const Channel& channel = problem.channels[static_cast<std::size_t>(measured.channel)];
  ChannelFit of{.file = file.path,
                .channel = channel.name,
                .unit = channel.unit,
                .is_held_out = file.is_held_out,
                .is_of_rig = file.is_of_rig(),
                .sigma = channel.sigma,
                .is_sigma_estimated = !channel.has_sigma,
                .at = measured.at,
                .data = measured.values};
  of.model = predictions(problem, measured, series, values);
  std::vector<double> errors;
  double squares = 0;
  for (std::size_t k = 0; k < of.data.size(); ++k) {
    errors.push_back(of.model[k] - of.data[k]);
    squares += errors.back() * errors.back();
  }
  of.rms = std::sqrt(squares / static_cast<double>(errors.size()));
  const double of_data = deviation_of(of.data), of_errors = deviation_of(errors);
  of.explained = of_data > 0 ? 1 - of_errors * of_errors / (of_data * of_data) : 0;
  of.whiteness = whiteness_of(errors);
  return of;
}

/// Every channel of every file at the result; warnings of the judged motions.
void add_channels(const FitProblem& problem, FitResult& result) {
  const std::vector<Outcome> outcomes =
      outcomes_of(problem, result.values, Care::judged, [](const Work&) { return true; });
  for (std::size_t w = 0; w < outcomes.size(); ++w) {
    const auto warn = [&](const std::string& text) {
      result.warnings.push_back(fmt::format("{}: at the result: {}", problem.works[w].name, text));
    };
    for (const std::string& warning : outcomes[w].warnings) warn(warning);
    if (!outcomes[w].failure.empty()) warn(outcomes[w].failure);
  }
  for (const MeasuredFile& file : problem.files)
    for (const MeasuredChannel& measured : file.channels)
      if (const Series* series = series_of(outcomes, measured))
        result.channels.push_back(fit_of(problem, file, measured, *series, result.values));
}

/// One line that tells a fit from others.
std::string description_of(const FitArguments& arguments, const FitProblem& problem) {
  using Json = nlohmann::ordered_json;
  std::vector<std::string> files = arguments.data;
  files.insert(files.end(), arguments.held_out.begin(), arguments.held_out.end());
  Json set = Json::object();
  for (const VariedParameter& parameter : problem.model.set) set[parameter.name] = *parameter.value;
  const ModelArguments& model = arguments.model;
  const Json words = {{"mbgen", kMbgenVersion},
                      {"model", problem.model.model.hash},
                      {"set", set},
                      {"data", hashes_of_files(files)},
                      {"held", arguments.held_out.size()},
                      {"match", arguments.match},
                      {"target", arguments.targets},
                      {"manoeuvre", hashes_of_files(arguments.manoeuvres)},
                      {"free", arguments.free},
                      {"free-start", arguments.free_start},
                      {"nuisance", arguments.nuisance},
                      {"loss", arguments.loss},
                      {"engine", problem.model.choice.name},
                      {"integrator", name_of(problem.model.choice.integrator)},
                      {"step", model.simulation.step.value_or(problem.model.model.solver.step)},
                      {"input", model.engine.inputs},
                      {"interpolation", model.simulation.interpolation}};
  return words.dump(-1, ' ', false, Json::error_handler_t::replace);
}

/// Fails: UserError for measured data that are given twice: they would count twice, or test themselves.
void require_given_once(const FitArguments& arguments) {
  std::vector<std::string> files = arguments.data;
  files.insert(files.end(), arguments.held_out.begin(), arguments.held_out.end());
  for (std::size_t i = 0; i < files.size(); ++i)
    for (std::size_t j = i + 1; j < files.size(); ++j) {
      if (!is_same_file(files[i], files[j])) continue;
      const bool is_data = j < arguments.data.size(), is_test = i >= arguments.data.size();
      throw UserError(is_data || is_test
                          ? fmt::format("{}: \"{}\" stands twice\n", is_data ? "--data" : "--hold-out", files[j])
                          : fmt::format("--hold-out: \"{}\" is one of --data: it would test nothing\n", files[j]));
    }
}

}  // namespace

FitResult fit_model_to_data(const FitArguments& arguments) {
  const Method method = least_squares_method();
  if (arguments.data.empty() != arguments.match.empty() || (arguments.data.empty() && arguments.targets.empty()))
    throw UserError("fit: give --data with --match, or --target, or both\n");
  require_given_once(arguments);
  const Loss loss = loss_of(arguments.loss);
  FreeModel model = read_free_model(arguments.model);
  FitProblem problem = read_problem(arguments, model);
  BlockedSignals signals;
  problem.is_stopped = [&] { return signals.taken() != 0; };
  EvaluationJournal journal(arguments.journal, "fit", description_of(arguments, problem), arguments.restart);
  if (journal.known() > 0) print_message("fit: {} evaluations were done before\n", journal.known());
  FitResult result{.model = model.model.name,
                   .model_file = arguments.model.path,
                   .engine = model.choice.name,
                   .derivatives = kind_of_derivatives(problem)};
  for (const MeasureSource& source : problem.measures.sources)
    if (source.of == MeasureSource::Of::motion) result.engine = source.study.choice.name;
  if (!model.why_differences.empty()) print_message("fit: derivatives by differences: {}\n", model.why_differences);
  Search steps(problem, loss, journal);
  const SearchEnd end = search_values(method, problem, steps, arguments, signals);
  result.values = end.values;
  result.squares_at_start = end.squares_at_start;
  result.iterations = end.iterations;
  result.converged = end.converged;
  result.message = end.message;
  Reduced last;
  if (!steps.evaluate(result.values, true, last)) {
    if (signals.taken() != 0) throw Interrupted{signals.taken()};
    throw UserError(fmt::format("fit: no derivatives at the result: {}\n", steps.failure()));
  }
  Eigen::MatrixXd unscaled = last.jacobian;
  for (std::size_t u = 0; u < problem.unknowns.size(); ++u)
    unscaled.col(static_cast<Eigen::Index>(u)) /= problem.unknowns[u].scale;
  result.squares = last.residuals.squaredNorm();
  result.residuals = residual_count(problem);
  result.certainty = certainty_of(unscaled, problem.unknowns, result.values,
                                  compilation_at(model, problem.unknowns, result.values).model.parameters);
  result.unknowns = problem.unknowns;
  result.loss = loss.kind == Loss::Kind::squares ? "" : arguments.loss;
  result.set = model.set;
  result.files = model.model.files;
  result.files.insert(result.files.end(), arguments.data.begin(), arguments.data.end());
  result.files.insert(result.files.end(), arguments.held_out.begin(), arguments.held_out.end());
  add_channels(problem, result);
  for (const FreeInertia& inertia : problem.inertias)
    if (is_at_limit(inertia, result.values))
      result.warnings.push_back(fmt::format(
          "the inertia of {} is at the limit of bodies, where a principal moment is the sum "
          "of the two others: the data pull it beyond; standard errors of its entries are without this limit",
          inertia.body));
  if (!result.converged)
    result.warnings.push_back(fmt::format("the search did not come to its end: {}", result.message));
  return result;
}

}  // namespace mbgen::fit
