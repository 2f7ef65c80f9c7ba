#include "workbench/fit/fit_search.hpp"

#include <fmt/format.h>

#include <cmath>

#include "compiler/text/user_error.hpp"
#include "workbench/fit/certainty.hpp"
#include "workbench/fit/fit_reading.hpp"
#include "workbench/fit/unit_doubts.hpp"
#include "workbench/host/message.hpp"
#include "workbench/host/process.hpp"
#include "workbench/host/progress.hpp"

namespace mbgen::fit {
namespace {

/// Rounds in which standard deviations of noise are estimated, and the change that ends them.
constexpr int kMostRounds = 12;
constexpr double kSameSigma = 1e-4;

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

bool is_low(const LeastSquares& task, const Eigen::VectorXd& at, int u) { return at[u] <= task.lower[u] + kAtBound; }
bool is_high(const LeastSquares& task, const Eigen::VectorXd& at, int u) { return at[u] >= task.upper[u] - kAtBound; }
bool is_at_bound(const LeastSquares& task, const Eigen::VectorXd& at) {
  for (int u = 0; u < static_cast<int>(at.size()); ++u)
    if (is_low(task, at, u) || is_high(task, at, u)) return true;
  return false;
}

/// Variables of a method that no bound holds at a point, where the sum of squares would fall across it.
std::vector<int> free_at(const LeastSquares& task, const Eigen::VectorXd& at, const Reduced& reduced) {
  std::vector<int> free;
  const Eigen::VectorXd gradient = reduced.jacobian.transpose() * reduced.residuals;
  for (int u = 0; u < static_cast<int>(at.size()); ++u)
    if (!(is_low(task, at, u) && gradient[u] > 0) && !(is_high(task, at, u) && gradient[u] < 0)) free.push_back(u);
  return free;
}

/// Whether the sum of squares would fall along variables by more than rounding and errors of differences.
bool still_falls(const Reduced& at, const std::vector<int>& free) {
  constexpr double kFalls = 1e-3, kPartFalls = 1e-6;  // of the sum of squares: less moves no value by its error
  return promised_fall(at, free) > kFalls + kPartFalls * at.residuals.squaredNorm();
}

/// Runs the method, and from its end again with the variables held that a bound stops: it cuts its steps at bounds, and
/// then hardly moves along them.
LeastSquaresResult run_method(Method method, Search& search, const FitArguments& arguments,
                              const Eigen::VectorXd& start, const std::function<bool(int, double)>& goes_on) {
  constexpr int kMostRuns = 6;
  LeastSquaresResult found;
  method(search.problem(start, goes_on), arguments.most_iterations, found);
  for (int run = 1; run < kMostRuns; ++run) {
    LeastSquares task = search.problem(found.unknowns, goes_on);
    Reduced end;
    if (!is_at_bound(task, found.unknowns) || !task.evaluate(found.unknowns, true, end)) break;
    const std::vector<int> free = free_at(task, found.unknowns, end);
    if (free.size() == static_cast<std::size_t>(found.unknowns.size()) || !still_falls(end, free)) break;
    LeastSquaresResult next;
    const auto evaluate = task.evaluate;
    task.evaluate = [&](const Eigen::VectorXd& at, bool with_jacobian, Reduced& result) {
      if (!evaluate(at, with_jacobian, result)) return false;
      for (int u = 0; u < static_cast<int>(at.size()) && with_jacobian; ++u)
        if (!std::ranges::binary_search(free, u)) result.jacobian.col(u).setZero();
      return true;
    };
    method(task, arguments.most_iterations, next);
    next.iterations += found.iterations;
    found = std::move(next);
  }
  return found;
}

/// Says of a search that stopped where the sum of squares still falls that it is at no end: steps that the model
/// refuses look like an end to the method. refusal: the reason of the last one.
void judge_end(const LeastSquares& task, const Eigen::VectorXd& at, const std::string& refusal, SearchEnd& result) {
  Reduced end;
  if (!result.converged || !task.evaluate(at, true, end)) return;
  const std::vector<int> free = free_at(task, at, end);
  if (!still_falls(end, free)) return;
  result.converged = false;
  const std::string reason =
      refusal.empty() ? "a body without a physical inertia, a loop that does not close" : refusal;
  result.message = fmt::format("the sum of squares would fall by {:.3g} more; the model may have no result beyond ({})",
                               promised_fall(end, free), reason);
}

}  // namespace

SearchEnd search_values(Method method, FitProblem& problem, Search& search, const FitArguments& arguments,
                        BlockedSignals& signals) {
  SearchEnd result;
  std::vector<double> starts;
  for (const Unknown& unknown : problem.unknowns) starts.push_back(unknown.start);
  Eigen::VectorXd at = search.scaled(starts);
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
    const LeastSquaresResult found = run_method(method, search, arguments, at, [&](int iteration, double cost) {
      if (line.is_due()) line.show(fmt::format("fit: iteration {}, sum of squares {:.6g}", iteration, 2 * cost));
      return signals.taken() == 0;
    });
    line.clear();
    if (signals.taken() != 0) throw Interrupted{signals.taken()};
    at = found.unknowns;
    result.squares = 2 * found.cost;
    result.iterations += found.iterations;
    result.converged = found.converged;
    result.message = found.message;
    if (!found.converged && !search.failure().empty()) result.message += " " + search.failure();
    const bool all_given = std::all_of(problem.channels.begin(), problem.channels.end(),
                                       [](const Channel& channel) { return channel.has_sigma; });
    if (all_given || estimate_sigmas(problem, search.unscaled(at)) < kSameSigma) break;
  }
  judge_end(search.problem(at, {}), at, search.refusal(), result);
  result.values = search.unscaled(at);
  return result;
}

}  // namespace mbgen::fit
