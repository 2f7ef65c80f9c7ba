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
#include "workbench/fit/unit_doubts.hpp"
#include "workbench/host/blocked_signals.hpp"
#include "workbench/host/files.hpp"
#include "workbench/host/message.hpp"
#include "workbench/host/process.hpp"
#include "workbench/host/progress.hpp"
#include "workbench/search/evaluation_journal.hpp"

namespace mbgen::fit {
namespace {

/// Rounds in which standard deviations of noise are estimated, and the change that ends them.
constexpr int kMostRounds = 12;
constexpr double kSameSigma = 1e-4;

/// The fit in scaled unknowns, with a journal.
class Search {
 public:
  Search(FitProblem& problem, const Loss& loss, EvaluationJournal& journal)
      : problem_(problem), loss_(loss), journal_(journal) {}

  std::vector<double> unscaled(const Eigen::VectorXd& scaled) const {
    std::vector<double> values;
    for (std::size_t u = 0; u < problem_.unknowns.size(); ++u) {
      const Unknown& unknown = problem_.unknowns[u];
      values.push_back(std::clamp(scaled[static_cast<Eigen::Index>(u)] * unknown.scale, unknown.lower, unknown.upper));
    }
    return values;
  }

  /// Reduced residuals; their derivatives are by the scaled unknowns. Known results are not computed again.
  bool evaluate(const std::vector<double>& values, bool with_jacobian, Reduced& result) {
    const std::string arguments = arguments_of(values, with_jacobian);
    if (const std::vector<double>* numbers = journal_.find(arguments)) {
      result = unpacked(*numbers, with_jacobian);
      return true;
    }
    if (!compute(values, with_jacobian, result)) return false;
    journal_.add(arguments, packed(result));
    return true;
  }

  LeastSquares problem(const Eigen::VectorXd& start, const std::function<bool(int, double)>& goes_on) {
    const auto size = static_cast<Eigen::Index>(problem_.unknowns.size());
    LeastSquares task{start,  Eigen::VectorXd(size), Eigen::VectorXd(size), reduced_rows(static_cast<int>(size)), {},
                      goes_on};
    for (Eigen::Index u = 0; u < size; ++u) {
      const Unknown& unknown = problem_.unknowns[static_cast<std::size_t>(u)];
      task.lower[u] = unknown.lower / unknown.scale;
      task.upper[u] = unknown.upper / unknown.scale;
    }
    task.evaluate = [this](const Eigen::VectorXd& scaled, bool with_jacobian, Reduced& result) {
      return evaluate(unscaled(scaled), with_jacobian, result);
    };
    return task;
  }

  const std::string& failure() const { return failure_; }

 private:
  std::string arguments_of(const std::vector<double>& values, bool with_jacobian) const {
    std::string text = with_jacobian ? "slope" : "cost";
    for (const Channel& channel : problem_.channels) text += fmt::format(" {}", channel.sigma);
    for (const double value : values) text += fmt::format(" {}", value);
    return text;
  }

  bool compute(const std::vector<double>& values, bool with_jacobian, Reduced& result) {
    const auto size = static_cast<Eigen::Index>(problem_.unknowns.size());
    if (!with_jacobian) {
      const Residuals at = residuals(problem_, values);
      failure_ = at.failure;
      if (at.failure.empty()) result = reduced(at.values, Eigen::MatrixXd(0, size), loss_);
    } else {
      Jacobian at = jacobian(problem_, values);
      failure_ = at.failure;
      for (Eigen::Index u = 0; u < size && at.failure.empty(); ++u)
        at.values.col(u) *= problem_.unknowns[static_cast<std::size_t>(u)].scale;
      if (at.failure.empty()) result = reduced(at.residuals, at.values, loss_);
    }
    return failure_.empty() && result.residuals.allFinite() && result.jacobian.allFinite();
  }

  static std::vector<double> packed(const Reduced& result) {
    std::vector<double> numbers(result.residuals.begin(), result.residuals.end());
    for (Eigen::Index r = 0; r < result.jacobian.rows(); ++r)
      for (Eigen::Index c = 0; c < result.jacobian.cols(); ++c) numbers.push_back(result.jacobian(r, c));
    return numbers;
  }

  Reduced unpacked(const std::vector<double>& numbers, bool with_jacobian) const {
    const auto columns = static_cast<Eigen::Index>(problem_.unknowns.size());
    const Eigen::Index rows = reduced_rows(static_cast<int>(columns));
    Reduced result;
    result.residuals = Eigen::Map<const Eigen::VectorXd>(numbers.data(), rows);
    if (!with_jacobian) return result;
    using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    result.jacobian = Eigen::Map<const Rows>(numbers.data() + rows, rows, columns);
    return result;
  }

  FitProblem& problem_;
  Loss loss_;
  EvaluationJournal& journal_;
  std::string failure_;
};

/// Sets noises that were not given to the deviations of the residuals. Result: the largest relative change.
double estimate_sigmas(FitProblem& problem, const std::vector<double>& values) {
  const Residuals at = residuals(problem, values);
  if (!at.failure.empty()) return 0;
  const double freedoms = std::max(1.0, static_cast<double>(at.values.size()) - static_cast<double>(values.size()));
  const double share = static_cast<double>(at.values.size()) / freedoms;
  std::vector<double> squares(problem.channels.size(), 0), counts(problem.channels.size(), 0);
  Eigen::Index row = 0;
  for (const MeasuredFile& file : problem.files) {
    if (file.is_held_out) continue;
    for (const MeasuredChannel& measured : file.channels)
      for (std::size_t k = 0; k < measured.values.size(); ++k, ++row) {
        squares[static_cast<std::size_t>(measured.channel)] += at.values[row] * at.values[row];
        counts[static_cast<std::size_t>(measured.channel)] += 1;
      }
  }
  double change = 0;
  for (std::size_t c = 0; c < problem.channels.size(); ++c) {
    Channel& channel = problem.channels[c];
    if (channel.has_sigma) continue;
    const double least = 1e-9 * size_of(problem.files, static_cast<int>(c));  // data without noise
    const double sigma = std::max(least, channel.sigma * std::sqrt(share * squares[c] / counts[c]));
    change = std::max(change, std::abs(sigma / channel.sigma - 1));
    channel.sigma = sigma;
  }
  return change;
}

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

/// Searches, with rounds for noises that were not given. Fails: UserError where there is no result at the start.
void search(Method method, FitProblem& problem, Search& search, const FitArguments& arguments, BlockedSignals& signals,
            FitResult& result) {
  Eigen::VectorXd at(static_cast<Eigen::Index>(problem.unknowns.size()));
  for (std::size_t u = 0; u < problem.unknowns.size(); ++u)
    at[static_cast<Eigen::Index>(u)] = problem.unknowns[u].start / problem.unknowns[u].scale;
  Reduced first;
  if (!search.evaluate(search.unscaled(at), false, first)) {
    if (signals.taken() != 0) throw Interrupted{signals.taken()};
    throw UserError(
        fmt::format("fit: no result at the start values: {}\n  hint: other start values, --free "
                    "NAME=LOW:START:HIGH, or a smaller --step\n",
                    search.failure().empty() ? "numbers are not finite" : search.failure()));
  }
  result.squares_at_start = first.residuals.squaredNorm();
  for (const std::string& note : unit_doubts(problem, search.unscaled(at))) print_message("{}", note);
  StatusLine line;
  for (int round = 0; round < kMostRounds; ++round) {
    const LeastSquares squares = search.problem(at, [&](int iteration, double cost) {
      if (line.is_due()) line.show(fmt::format("fit: iteration {}, sum of squares {:.6g}", iteration, 2 * cost));
      return signals.taken() == 0;
    });
    LeastSquaresResult found;
    method(squares, arguments.most_iterations, found);
    line.clear();
    if (signals.taken() != 0) throw Interrupted{signals.taken()};
    at = found.unknowns;
    result.squares = 2 * found.cost;
    result.iterations += found.iterations;
    result.converged = found.converged;
    result.message = found.message;
    const bool all_given = std::all_of(problem.channels.begin(), problem.channels.end(),
                                       [](const Channel& channel) { return channel.has_sigma; });
    if (all_given || estimate_sigmas(problem, search.unscaled(at)) < kSameSigma) break;
  }
  result.values = search.unscaled(at);
}

}  // namespace

FitResult fit_model_to_data(const FitArguments& arguments) {
  const Method method = least_squares_method();
  if (arguments.data.empty() != arguments.match.empty() || (arguments.data.empty() && arguments.targets.empty()))
    throw UserError("fit: give --data with --match, or --target, or both\n");
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
  search(method, problem, steps, arguments, signals, result);
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
  if (!result.converged)
    result.warnings.push_back(fmt::format("the search did not come to its end: {}", result.message));
  return result;
}

}  // namespace mbgen::fit
