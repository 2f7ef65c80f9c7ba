#include "workbench/optimise/design_problem.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "compiler/program/in_threads.hpp"
#include "workbench/search/differences.hpp"

namespace mbgen::optimise {
namespace {

/// One evaluation of a source, at the design or beside it.
struct SourceWork {
  std::size_t source = 0, variable = 0;
  double offset = 0, weight = 0;  ///< of the variable; of this evaluation in the derivative
  SourceValues found = {};
};

void run_works(const DesignProblem& problem, const std::vector<double>& values, bool with_derivatives,
               std::vector<SourceWork>& works) {
  const auto run = [&](std::size_t k) {
    SourceWork& work = works[k];
    if (problem.is_stopped && problem.is_stopped()) {
      work.found.failure = "interrupted";
      return;
    }
    std::vector<double> moved = values;
    moved[work.variable] += work.offset;
    work.found = evaluate(problem.measures.sources[work.source], problem.model, problem.variables,
                          problem.measures.measures, moved, with_derivatives, problem.is_stopped);
  };
  in_threads(works.size(), run, static_cast<std::size_t>(problem.jobs));
}

/// Adds the part of an evaluation to derivatives by differences.
void add_work(const DesignProblem& problem, const SourceWork& work, std::vector<Response>& responses) {
  const MeasureSource& source = problem.measures.sources[work.source];
  for (std::size_t k = 0; k < source.measures.size(); ++k) {
    Response& response = responses[source.measures[k]];
    if (response.derivatives.empty())
      response.derivatives.assign(problem.variables.size(), std::vector<double>(response.values.size(), 0.0));
    const std::vector<double>& beside = work.found.responses[k].values;
    for (std::size_t p = 0; p < beside.size(); ++p) response.derivatives[work.variable][p] += work.weight * beside[p];
  }
}

/// The derivative of a source by a variable.
struct SourceSlope {
  std::size_t source = 0, variable = 0;
  std::vector<DifferenceFormula> formulas = {};
  std::vector<SourceWork> works = {};  ///< of the formula that is tried
};

/// Derivatives of sources that have none of their own.
std::vector<SourceSlope> slopes_at(const DesignProblem& problem, const std::vector<double>& values) {
  std::vector<SourceSlope> slopes;
  for (std::size_t s = 0; s < problem.measures.sources.size(); ++s) {
    if (problem.measures.sources[s].has_derivatives()) continue;
    for (std::size_t v = 0; v < problem.variables.size(); ++v)
      slopes.push_back({s, v, difference_formulas(problem.variables[v], values[v])});
  }
  return slopes;
}

/// Evaluates sources beside the design, each derivative by the first of its formulas that has a result. Result: the
/// reason why one has none.
std::string run_beside(const DesignProblem& problem, const std::vector<double>& values,
                       std::vector<SourceSlope>& slopes) {
  const auto evaluate_slopes = [&](const std::vector<std::size_t>& places, std::size_t attempt) {
    std::vector<SourceWork> works;
    for (const std::size_t place : places) {
      const SourceSlope& slope = slopes[place];
      const DifferenceFormula& formula = slope.formulas[attempt];
      for (const auto& [steps, weight] : formula.terms)
        works.push_back({slope.source, slope.variable, steps * formula.step, weight / formula.step});
    }
    run_works(problem, values, false, works);
    auto work = works.begin();
    for (const std::size_t place : places) {
      const auto size = static_cast<std::ptrdiff_t>(slopes[place].formulas[attempt].terms.size());
      slopes[place].works.assign(std::move_iterator(work), std::move_iterator(work + size));
      work += size;
    }
  };
  const auto failure_at = [&](std::size_t place) -> std::string {
    for (const SourceWork& work : slopes[place].works)
      if (!work.found.failure.empty())
        return fmt::format("{}: {} beside: {}", problem.measures.sources[work.source].name,
                           problem.variables[work.variable].name, work.found.failure);
    return "";
  };
  return evaluate_by_formulas(slopes.size(), evaluate_slopes, failure_at,
                              [&](std::size_t place) { return slopes[place].formulas.size(); });
}

/// Adds derivatives by differences to the responses. Result: the reason why there are none.
std::string add_differences(const DesignProblem& problem, const std::vector<double>& values,
                            std::vector<Response>& responses) {
  std::vector<SourceSlope> slopes = slopes_at(problem, values);
  if (std::string failure = run_beside(problem, values, slopes); !failure.empty()) return failure;
  for (const SourceSlope& slope : slopes)
    for (const SourceWork& work : slope.works) add_work(problem, work, responses);
  return "";
}

std::size_t first_number(const DesignProblem& problem, std::size_t measure) {
  std::size_t first = 0;
  for (std::size_t m = 0; m < measure; ++m) first += problem.lengths[m];
  return first;
}

double element(const std::vector<double>& list, Eigen::Index place) {
  return list[list.size() == 1 ? 0 : static_cast<std::size_t>(place)];
}

}  // namespace

Responses responses_at(const DesignProblem& problem, const std::vector<double>& values, bool with_derivatives) {
  Responses result;
  result.list.resize(problem.measures.measures.size());
  std::vector<SourceWork> works(problem.measures.sources.size());
  for (std::size_t s = 0; s < works.size(); ++s) works[s].source = s;
  run_works(problem, values, with_derivatives, works);
  for (SourceWork& work : works) {
    const MeasureSource& source = problem.measures.sources[work.source];
    if (!work.found.failure.empty() && result.failure.empty())
      result.failure = fmt::format("{}: {}", source.name, work.found.failure);
    if (!result.failure.empty()) continue;
    for (std::size_t k = 0; k < source.measures.size(); ++k)
      result.list[source.measures[k]] = std::move(work.found.responses[k]);
    for (const std::string& warning : work.found.warnings)
      result.warnings.push_back(fmt::format("{}: {}", source.name, warning));
  }
  if (with_derivatives && result.failure.empty()) result.failure = add_differences(problem, values, result.list);
  return result;
}

std::vector<double> Designs::unscaled(const Eigen::VectorXd& scaled) const {
  std::vector<double> values;
  for (std::size_t v = 0; v < problem_.variables.size(); ++v) {
    const Unknown& variable = problem_.variables[v];
    values.push_back(std::clamp(scaled[static_cast<Eigen::Index>(v)] * variable.scale, variable.lower, variable.upper));
  }
  return values;
}

Eigen::VectorXd Designs::scaled(const std::vector<double>& values) const {
  Eigen::VectorXd result(static_cast<Eigen::Index>(values.size()));
  for (std::size_t v = 0; v < values.size(); ++v)
    result[static_cast<Eigen::Index>(v)] = values[v] / problem_.variables[v].scale;
  return result;
}

bool Designs::compute(const std::vector<double>& values, bool with_derivatives, Design& design, std::string& failure) {
  const Responses responses = responses_at(problem_, values, with_derivatives);
  failure = responses.failure;
  if (!failure.empty()) return false;
  const auto rows = static_cast<Eigen::Index>(first_number(problem_, problem_.lengths.size()));
  const auto columns = static_cast<Eigen::Index>(problem_.variables.size());
  design.numbers.resize(rows);
  design.derivatives.resize(with_derivatives ? rows : 0, columns);
  Eigen::Index row = 0;
  for (std::size_t m = 0; m < responses.list.size(); ++m) {
    const Response& response = responses.list[m];
    if (response.values.size() != problem_.lengths[m]) {
      failure = fmt::format("{} has {} points, not {}", problem_.measures.measures[m].name, response.values.size(),
                            problem_.lengths[m]);
      return false;
    }
    for (std::size_t p = 0; p < response.values.size(); ++p, ++row) {
      design.numbers[row] = response.values[p];
      for (Eigen::Index v = 0; with_derivatives && v < columns; ++v)
        design.derivatives(row, v) = response.derivatives[static_cast<std::size_t>(v)][p] *
                                     problem_.variables[static_cast<std::size_t>(v)].scale;
    }
  }
  if (!design.derivatives.allFinite()) failure = "derivatives are not finite";
  return failure.empty();
}

bool Designs::take_known(const std::string& key, bool with_derivatives, Design& design) const {
  const std::vector<double>* numbers = journal_.find(key);
  if (numbers == nullptr) return false;
  const auto rows = static_cast<Eigen::Index>(first_number(problem_, problem_.lengths.size()));
  const auto columns = static_cast<Eigen::Index>(problem_.variables.size());
  if (static_cast<Eigen::Index>(numbers->size()) != rows * (with_derivatives ? 1 + columns : 1)) return false;
  design.numbers = Eigen::Map<const Eigen::VectorXd>(numbers->data(), rows);
  design.derivatives = Eigen::Map<const Eigen::MatrixXd>(numbers->data() + rows, with_derivatives ? rows : 0, columns);
  return true;
}

bool Designs::evaluate(const std::vector<double>& values, bool with_derivatives, Design& design) {
  std::string arguments;
  for (const double value : values) arguments += fmt::format(" {}", value);
  const std::string key = (with_derivatives ? "slope" : "value") + arguments;
  design.values = values;
  if (!with_derivatives && seen_.contains("slope" + arguments)) return evaluate(values, true, design);
  if (seen_refusals_.contains(key)) return false;
  if (!take_known(key, with_derivatives, design)) {
    std::string failure;
    if (!compute(values, with_derivatives, design, failure)) {
      if (problem_.is_stopped && problem_.is_stopped()) return false;
      ++count_;
      seen_refusals_.insert(key);
      refused_.push_back({values, failure});
      course_.push_back({0, 0, true});
      return false;
    }
    std::vector<double> numbers(design.numbers.begin(), design.numbers.end());
    numbers.insert(numbers.end(), design.derivatives.data(), design.derivatives.data() + design.derivatives.size());
    journal_.add(key, numbers);
  }
  if (!seen_.insert(key).second) return true;
  ++count_;
  with_derivatives_ += with_derivatives;
  note(design);
  return true;
}

void Designs::note(const Design& design) {
  EvaluatedDesign evaluated;
  for (const Goal& goal : problem_.wishes.goals) evaluated.goal += cost_of(problem_, goal, design).cost;
  bool keeps_all = true;
  for (const Constraint& constraint : problem_.wishes.constraints) {
    const ConstraintValues values = excess_of(problem_, constraint, design);
    evaluated.broken = std::max(evaluated.broken, broken_by(constraint, values));
    keeps_all = keeps_all && !is_broken(constraint, values);
  }
  course_.push_back(evaluated);
  if (line_.is_due())
    line_.show(fmt::format("optimise: evaluation {}, goal {:.6g}{}", count_, evaluated.goal,
                           keeps_all ? "" : ", constraints not kept yet"));
}

GoalValue cost_of(const DesignProblem& problem, const Goal& goal, const Design& design) {
  const auto first = static_cast<Eigen::Index>(first_number(problem, goal.measure));
  const auto size = static_cast<Eigen::Index>(problem.lengths[goal.measure]);
  const bool has_derivatives = design.derivatives.rows() > 0;
  GoalValue result;
  if (goal.kind != Goal::Kind::target) {
    const double factor = (goal.kind == Goal::Kind::least ? 1 : -1) / goal.scale;
    result.cost = factor * design.numbers[first];
    if (has_derivatives) result.gradient = factor * design.derivatives.row(first).transpose();
    return result;
  }
  if (has_derivatives) result.gradient.setZero(design.derivatives.cols());
  const double share = 1 / static_cast<double>(size);
  for (Eigen::Index p = 0; p < size; ++p) {
    const double error = (design.numbers[first + p] - element(goal.target, p)) / goal.scale;
    result.cost += share * error * error;
    if (has_derivatives)
      result.gradient += (2 * share * error / goal.scale) * design.derivatives.row(first + p).transpose();
  }
  return result;
}

double shown_value(const DesignProblem& problem, const Goal& goal, const Design& design) {
  if (goal.kind != Goal::Kind::target)
    return design.numbers[static_cast<Eigen::Index>(first_number(problem, goal.measure))];
  return goal.scale * std::sqrt(cost_of(problem, goal, {design.values, design.numbers, {}}).cost);
}

ConstraintValues excess_of(const DesignProblem& problem, const Constraint& constraint, const Design& design) {
  const auto first = static_cast<Eigen::Index>(first_number(problem, constraint.measure));
  const auto size = static_cast<Eigen::Index>(problem.lengths[constraint.measure]);
  const double sign = constraint.kind == Constraint::Kind::at_least ? -1 : 1;
  ConstraintValues result{Eigen::VectorXd(size), Eigen::MatrixXd(0, design.derivatives.cols())};
  for (Eigen::Index p = 0; p < size; ++p)
    result.excess[p] = sign * (design.numbers[first + p] - element(constraint.limit, p)) / constraint.scale;
  if (design.derivatives.rows() > 0)
    result.derivatives = (sign / constraint.scale) * design.derivatives.middleRows(first, size);
  return result;
}

double broken_by(const Constraint& constraint, const ConstraintValues& values) {
  return constraint.kind == Constraint::Kind::equal ? values.excess.cwiseAbs().maxCoeff()
                                                    : std::max(0.0, values.excess.maxCoeff());
}

double near_part(const Constraint& constraint) {
  return std::min(kPartBroken, constraint.tolerance / constraint.scale);
}

bool is_broken(const Constraint& constraint, const ConstraintValues& values) {
  return broken_by(constraint, values) * constraint.scale > constraint.tolerance;
}

}  // namespace mbgen::optimise
