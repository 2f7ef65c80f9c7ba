#include "workbench/fit/fit_problem.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>

#include "compiler/algebra/dense.hpp"
#include "workbench/search/differences.hpp"

namespace mbgen::fit {
namespace {

/// One evaluation of a work at a distance from the point, for the derivative by an unknown.
struct Evaluation {
  std::size_t work = 0, unknown = 0;
  double steps = 0, weight = 0;     ///< from the point; of this evaluation in the derivative
  std::vector<double> values = {};  ///< of the unknowns
  Outcome outcome = {};
};

/// Step of the entries of an inertia's factor. Along them inertias stay those of bodies.
constexpr double kStepOfFactor = 1e-4;

/// The derivative of a work by an unknown.
struct Slope {
  std::size_t work = 0, unknown = 0;
  std::vector<DifferenceFormula> formulas = {};
  std::vector<Evaluation> evaluations = {};  ///< of the formula that is tried
};

/// The evaluations for the derivative by an unknown: of an inertia by the entry of its factor.
std::vector<Evaluation> evaluations_of(const FitProblem& problem, const Slope& slope, std::size_t attempt,
                                       const std::vector<double>& values) {
  std::size_t entry = 0;
  const FreeInertia* inertia = inertia_of_unknown(problem.inertias, slope.unknown, entry);
  DifferenceFormula formula = slope.formulas[attempt];
  if (inertia != nullptr) formula.step = kStepOfFactor;
  std::vector<Evaluation> list;
  for (const auto& [steps, weight] : formula.terms) {
    Evaluation one{slope.work, slope.unknown, steps, weight / formula.step, values, {}};
    if (inertia != nullptr) {
      std::array<double, 6> factor = factor_of(*inertia, values);
      factor[entry] += steps * formula.step;
      set_inertia(*inertia, factor, one.values);
    } else {
      one.values[slope.unknown] += steps * formula.step;
    }
    list.push_back(std::move(one));
  }
  return list;
}

double value_or(const std::vector<double>& values, int unknown, double without) {
  return unknown < 0 ? without : values[static_cast<std::size_t>(unknown)];
}

const Channel& channel_of(const FitProblem& problem, const MeasuredChannel& measured) {
  return problem.channels[static_cast<std::size_t>(measured.channel)];
}

/// The reason why a work has no result, "" where it has one.
std::string failure_of(const FitProblem& problem, const Work& work, const Outcome& outcome) {
  if (problem.is_stopped && problem.is_stopped()) return "interrupted";
  return outcome.failure.empty() ? "" : fmt::format("{}: {}", work.name, outcome.failure);
}

/// Outcomes of the fitted files; failure: of the first that has none.
std::vector<Outcome> fitted_outcomes(const FitProblem& problem, const std::vector<double>& values, Care care,
                                     std::string& failure) {
  std::vector<Outcome> outcomes =
      outcomes_of(problem, values, care, [](const Work& work) { return !work.is_held_out; });
  for (std::size_t w = 0; w < outcomes.size() && failure.empty(); ++w)
    failure = failure_of(problem, problem.works[w], outcomes[w]);
  return outcomes;
}

/// Calls visit(file, channel of the file, first row) for each block of residuals.
template <class Visit>
void each_block(const FitProblem& problem, bool held, Visit visit) {
  int row = 0;
  for (std::size_t f = 0; f < problem.files.size(); ++f) {
    if (problem.files[f].is_held_out != held) continue;
    for (std::size_t c = 0; c < problem.files[f].channels.size(); ++c) {
      visit(f, c, row);
      row += static_cast<int>(problem.files[f].channels[c].values.size());
    }
  }
}

/// Derivatives by gain, bias and delay.
void add_nuisance_columns(const FitProblem& problem, const std::vector<double>& values, const Series& series,
                          const MeasuredChannel& measured, int row, Eigen::MatrixXd& jacobian) {
  const Channel& channel = channel_of(problem, measured);
  const double gain = value_or(values, channel.gain, 1), delay = value_or(values, channel.delay, 0);
  for (std::size_t k = 0; k < measured.at.size(); ++k) {
    const SeriesPoint point = at(series, measured.at[k] - delay);
    const auto place = row + static_cast<Eigen::Index>(k);
    if (channel.gain >= 0) jacobian(place, channel.gain) = point.value / channel.sigma;
    if (channel.bias >= 0) jacobian(place, channel.bias) = 1 / channel.sigma;
    if (channel.delay >= 0) jacobian(place, channel.delay) = -gain * point.slope / channel.sigma;
  }
}

/// The derivatives that need evaluations beside the point.
std::vector<Slope> slopes_at(const FitProblem& problem, const std::vector<Outcome>& outcomes,
                             const std::vector<double>& values) {
  std::vector<Slope> list;
  for (std::size_t w = 0; w < problem.works.size(); ++w) {
    if (problem.works[w].is_held_out) continue;
    for (std::size_t u = 0; u < problem.unknowns.size(); ++u) {
      const Unknown& unknown = problem.unknowns[u];
      if (!outcomes[w].derivatives.empty() && unknown.kind == Unknown::Kind::parameter) continue;
      if (!unknown.moves_model() || (unknown.run >= 0 && unknown.run != problem.works[w].run)) continue;
      list.push_back({w, u, difference_formulas(unknown, values[u])});
    }
  }
  return list;
}

/// The evaluations beside the point, each derivative by the first of its formulas that has a result. failure: the
/// reason why one has none.
std::vector<Evaluation> evaluations_at(const FitProblem& problem, const std::vector<Outcome>& outcomes,
                                       const std::vector<double>& values, std::string& failure) {
  std::vector<Slope> slopes = slopes_at(problem, outcomes, values);
  const auto evaluate = [&](const std::vector<std::size_t>& places, std::size_t attempt) {
    std::vector<Evaluation*> list;
    for (const std::size_t place : places) {
      slopes[place].evaluations = evaluations_of(problem, slopes[place], attempt, values);
      for (Evaluation& one : slopes[place].evaluations) list.push_back(&one);
    }
    run_tasks(problem, list.size(), [&](std::size_t k) {
      Evaluation& one = *list[k];
      one.outcome =
          one.steps == 0 ? outcomes[one.work] : outcome_of(problem, problem.works[one.work], one.values, Care::quick);
    });
  };
  const auto failure_at = [&](std::size_t place) -> std::string {
    for (const Evaluation& one : slopes[place].evaluations) {
      const std::string reason = failure_of(problem, problem.works[one.work], one.outcome);
      if (!reason.empty()) return fmt::format("{} beside: {}", problem.unknowns[one.unknown].name, reason);
    }
    return "";
  };
  failure = evaluate_by_formulas(slopes.size(), evaluate, failure_at,
                                 [&](std::size_t place) { return slopes[place].formulas.size(); });
  std::vector<Evaluation> list;
  for (Slope& slope : slopes) std::ranges::move(slope.evaluations, std::back_inserter(list));
  return list;
}

}  // namespace

std::string kind_of_derivatives(const FitProblem& problem) {
  const auto is_exact = [&](const Work& work) {
    return work.run >= 0 ? problem.model.tangents != nullptr
                         : problem.measures.sources[static_cast<std::size_t>(work.source)].has_derivatives();
  };
  const auto is_start = [](const Unknown& unknown) { return unknown.kind == Unknown::Kind::start; };
  if (std::ranges::none_of(problem.works, is_exact)) return "central differences";
  const bool are_all = std::ranges::all_of(problem.works, is_exact) && std::ranges::none_of(problem.unknowns, is_start);
  return are_all ? "exact" : "exact of motions by parameters, else central differences";
}

int residual_count(const FitProblem& problem, bool held) {
  int count = 0;
  each_block(problem, held, [&](std::size_t f, std::size_t c, int) {
    count += static_cast<int>(problem.files[f].channels[c].values.size());
  });
  return count;
}

std::vector<double> predictions(const FitProblem& problem, const MeasuredChannel& measured, const Series& series,
                                const std::vector<double>& values) {
  const Channel& channel = channel_of(problem, measured);
  const double gain = value_or(values, channel.gain, 1), bias = value_or(values, channel.bias, 0),
               delay = value_or(values, channel.delay, 0);
  std::vector<double> result;
  for (const double instant : measured.at) result.push_back(gain * at(series, instant - delay).value + bias);
  return result;
}

namespace {

Eigen::VectorXd residuals_of(const FitProblem& problem, const std::vector<Outcome>& outcomes,
                             const std::vector<double>& values) {
  Eigen::VectorXd result(residual_count(problem));
  each_block(problem, false, [&](std::size_t f, std::size_t c, int row) {
    const MeasuredChannel& measured = problem.files[f].channels[c];
    const std::vector<double> predicted = predictions(problem, measured, *series_of(outcomes, measured), values);
    const double sigma = channel_of(problem, measured).sigma;
    for (std::size_t k = 0; k < predicted.size(); ++k)
      result[row + static_cast<Eigen::Index>(k)] = (predicted[k] - measured.values[k]) / sigma;
  });
  return result;
}

/// Columns by the entries of factors become columns by those of inertias.
void chain_to_inertias(const FitProblem& problem, const std::vector<double>& values, Eigen::MatrixXd& columns) {
  for (const FreeInertia& inertia : problem.inertias) {
    const std::vector<int> own = columns_of(inertia);
    const Eigen::MatrixXd slopes = slopes_of_inertia(inertia, factor_of(inertia, values)).transpose();
    const Eigen::MatrixXd by_factor = columns(Eigen::all, own).transpose();
    columns(Eigen::all, own) = solved(slopes, by_factor).transpose();
  }
}

/// Adds the derivatives of a block of residuals by the unknowns that move the model.
void add_differences(const FitProblem& problem, const std::vector<Evaluation>& evaluations,
                     const std::vector<double>& values, const MeasuredChannel& measured, int row,
                     Eigen::MatrixXd& jacobian) {
  const Channel& channel = channel_of(problem, measured);
  const double gain = value_or(values, channel.gain, 1), delay = value_or(values, channel.delay, 0);
  Eigen::MatrixXd columns = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(measured.at.size()), jacobian.cols());
  for (const Evaluation& one : evaluations) {
    if (one.work != measured.work) continue;
    const Series& series = one.outcome.series[measured.place];
    for (std::size_t k = 0; k < measured.at.size(); ++k)
      columns(static_cast<Eigen::Index>(k), static_cast<Eigen::Index>(one.unknown)) +=
          one.weight * gain * at(series, measured.at[k] - delay).value / channel.sigma;
  }
  chain_to_inertias(problem, values, columns);
  jacobian.middleRows(row, columns.rows()) += columns;
}

/// Adds the exact derivatives of a block of residuals by the free parameters.
void add_derivatives(const FitProblem& problem, const Outcome& outcome, const std::vector<double>& values,
                     const MeasuredChannel& measured, int row, Eigen::MatrixXd& jacobian) {
  if (outcome.derivatives.empty()) return;
  const Channel& channel = channel_of(problem, measured);
  const double gain = value_or(values, channel.gain, 1), delay = value_or(values, channel.delay, 0);
  for (std::size_t u = 0, p = 0; u < problem.unknowns.size(); ++u) {
    if (problem.unknowns[u].kind != Unknown::Kind::parameter) continue;
    const Series& series = outcome.derivatives[p++][measured.place];
    for (std::size_t k = 0; k < measured.at.size(); ++k)
      jacobian(row + static_cast<Eigen::Index>(k), static_cast<Eigen::Index>(u)) =
          gain * at(series, measured.at[k] - delay).value / channel.sigma;
  }
}

}  // namespace

Residuals residuals(const FitProblem& problem, const std::vector<double>& values) {
  Residuals result;
  const std::vector<Outcome> outcomes = fitted_outcomes(problem, values, Care::quick, result.failure);
  if (result.failure.empty()) result.values = residuals_of(problem, outcomes, values);
  return result;
}

Jacobian jacobian(const FitProblem& problem, const std::vector<double>& values) {
  Jacobian result;
  const std::vector<Outcome> outcomes = fitted_outcomes(problem, values, Care::exact, result.failure);
  if (!result.failure.empty()) return result;
  result.residuals = residuals_of(problem, outcomes, values);
  const std::vector<Evaluation> evaluations = evaluations_at(problem, outcomes, values, result.failure);
  if (!result.failure.empty()) return result;
  result.values.setZero(residual_count(problem), static_cast<Eigen::Index>(problem.unknowns.size()));
  each_block(problem, false, [&](std::size_t f, std::size_t c, int row) {
    const MeasuredChannel& measured = problem.files[f].channels[c];
    add_nuisance_columns(problem, values, *series_of(outcomes, measured), measured, row, result.values);
    add_derivatives(problem, outcomes[measured.work], values, measured, row, result.values);
    add_differences(problem, evaluations, values, measured, row, result.values);
  });
  return result;
}

}  // namespace mbgen::fit
