#pragma once
// The search of a fit: its evaluations in the variables of the method, with a journal, and its rounds.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>
#include <string>
#include <vector>

#include "workbench/fit/fit_arguments.hpp"
#include "workbench/fit/fit_problem.hpp"
#include "workbench/fit/least_squares.hpp"
#include "workbench/fit/reduction.hpp"
#include "workbench/host/blocked_signals.hpp"
#include "workbench/search/evaluation_journal.hpp"

namespace mbgen::fit {

/// The fit in scaled unknowns, with a journal.
class Search {
 public:
  Search(FitProblem& problem, const Loss& loss, EvaluationJournal& journal)
      : problem_(problem), loss_(loss), journal_(journal) {}

  /// Values of the unknowns at the variables of the method: these are scaled, and entries of factors for inertias.
  std::vector<double> unscaled(const Eigen::VectorXd& scaled) const {
    std::vector<double> values;
    for (std::size_t u = 0; u < problem_.unknowns.size(); ++u) {
      const Unknown& unknown = problem_.unknowns[u];
      values.push_back(std::clamp(scaled[static_cast<Eigen::Index>(u)] * unknown.scale, unknown.lower, unknown.upper));
    }
    for (const FreeInertia& inertia : problem_.inertias) set_inertia(inertia, factor_at(inertia, scaled), values);
    return values;
  }

  Eigen::VectorXd scaled(const std::vector<double>& values) const {
    Eigen::VectorXd result(static_cast<Eigen::Index>(values.size()));
    for (std::size_t u = 0; u < values.size(); ++u)
      result[static_cast<Eigen::Index>(u)] = values[u] / problem_.unknowns[u].scale;
    for (const FreeInertia& inertia : problem_.inertias) {
      const std::array<double, 6> factor = factor_of(inertia, values);
      for (std::size_t i = 0; i < factor.size(); ++i)
        if (inertia.unknowns[i] >= 0) result[inertia.unknowns[i]] = factor[i];
    }
    return result;
  }

  /// Reduced residuals; their derivatives are by the scaled unknowns. Known results are not computed again.
  bool evaluate(const std::vector<double>& values, bool with_jacobian, Reduced& result) {
    const std::string arguments = arguments_of(values, with_jacobian);
    if (const std::vector<double>* numbers = journal_.find(arguments)) {
      result = unpacked(*numbers, with_jacobian);
      failure_.clear();
      return true;
    }
    if (!compute(values, with_jacobian, result)) {
      if (!failure_.empty()) refusal_ = failure_;
      return false;
    }
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
    for (const FreeInertia& inertia : problem_.inertias)
      for (std::size_t i = 0; i < 3; ++i) task.lower[inertia.unknowns[i]] = kLeastOfFactor;
    task.evaluate = [this](const Eigen::VectorXd& scaled, bool with_jacobian, Reduced& result) {
      if (!evaluate(unscaled(scaled), with_jacobian, result)) return false;
      if (with_jacobian) chain_to_factors(scaled, result.jacobian);
      return true;
    };
    return task;
  }

  const std::string& failure() const { return failure_; }  ///< of the last evaluation
  const std::string& refusal() const { return refusal_; }  ///< of the last values without a result

 private:
  static std::array<double, 6> factor_at(const FreeInertia& inertia, const Eigen::VectorXd& scaled) {
    std::array<double, 6> factor{};
    for (std::size_t i = 0; i < factor.size(); ++i)
      if (inertia.unknowns[i] >= 0) factor[i] = scaled[inertia.unknowns[i]];
    return factor;
  }

  /// Columns by entries of inertias become columns by those of their factors.
  void chain_to_factors(const Eigen::VectorXd& scaled, Eigen::MatrixXd& jacobian) const {
    for (const FreeInertia& inertia : problem_.inertias) {
      const std::vector<int> columns = columns_of(inertia);
      const Eigen::MatrixXd by_factor = jacobian(Eigen::all, columns) *
                                        slopes_of_inertia(inertia, factor_at(inertia, scaled)) /
                                        problem_.unknowns[static_cast<std::size_t>(columns.front())].scale;
      jacobian(Eigen::all, columns) = by_factor;
    }
  }

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
  std::string failure_, refusal_;
};

/// The end of a search.
struct SearchEnd {
  std::vector<double> values;
  double squares = 0, squares_at_start = 0;  ///< weighted sums of squares
  int iterations = 0;
  bool converged = false;
  std::string message;  ///< of the method
};

/// Searches, with rounds for noises that were not given. Fails: UserError where there is no result at the start;
/// Interrupted.
SearchEnd search_values(Method method, FitProblem& problem, Search& search, const FitArguments& arguments,
                        BlockedSignals& signals);

}  // namespace mbgen::fit
