#include "workbench/optimise/found_designs.hpp"

#include <algorithm>
#include <cmath>

namespace mbgen::optimise {
namespace {

/// Multipliers of the rows of constraints, in the order of the problem's.
class Multipliers {
 public:
  explicit Multipliers(const Optimality& optimality) : optimality_(optimality) {}

  /// Of a constraint's rows, in scaled units of goal and constraint.
  Eigen::VectorXd take(bool is_equal, Eigen::Index rows) {
    Eigen::Index& place = is_equal ? equality_ : inequality_;
    const Eigen::VectorXd& of = is_equal ? optimality_.equalities : optimality_.inequalities;
    place += rows;
    return of.segment(place - rows, rows);
  }

 private:
  const Optimality& optimality_;
  Eigen::Index inequality_ = 0, equality_ = 0;
};

FoundConstraint found_constraint(const DesignProblem& problem, const Constraint& constraint, const Design& start,
                                 const Design& design, Multipliers& multipliers, const std::string& unit) {
  FoundConstraint found{constraint, unit};
  const ConstraintValues values = excess_of(problem, constraint, design),
                         at_start = excess_of(problem, constraint, start);
  const bool is_equal = constraint.kind == Constraint::Kind::equal;
  const double sign = constraint.kind == Constraint::Kind::at_least ? -1 : 1;
  Eigen::Index worst = 0, worst_at_start = 0;
  (is_equal ? values.excess.cwiseAbs().eval() : values.excess).maxCoeff(&worst);
  (is_equal ? at_start.excess.cwiseAbs().eval() : at_start.excess).maxCoeff(&worst_at_start);
  const auto limit_at = [&](Eigen::Index p) {
    return constraint.limit[constraint.limit.size() == 1 ? 0 : static_cast<std::size_t>(p)];
  };
  found.limit = limit_at(worst);
  found.value = found.limit + sign * values.excess[worst] * constraint.scale;
  found.start = limit_at(worst_at_start) + sign * at_start.excess[worst_at_start] * constraint.scale;
  const Eigen::VectorXd rows = multipliers.take(is_equal, values.excess.size());
  found.multiplier = 0.0 - sign * rows.sum() / constraint.scale;
  found.is_broken = is_broken(constraint, values);
  found.is_active = is_equal || values.excess[worst] > -near_part(constraint);
  return found;
}

std::vector<double> at_all_points(const std::vector<double>& list, std::size_t size) {
  return list.size() == 1 ? std::vector<double>(size, list[0]) : list;
}

}  // namespace

FoundDesign found_design(const DesignProblem& problem, const Design& start, const SearchedDesign& found,
                         const std::vector<Response>& before) {
  FoundDesign result{.status = found.status,
                     .ended = found.ended,
                     .keeps_constraints = found.keeps_constraints,
                     .rest = found.optimality.own_rest,
                     .sum = found.point.goal};
  for (std::size_t v = 0; v < problem.variables.size(); ++v)
    result.variables.push_back(
        {problem.variables[v], found.design.values[v], found.optimality.at_bound[v],
         0.0 - found.optimality.bounds[static_cast<Eigen::Index>(v)] / problem.variables[v].scale});
  for (const Goal& goal : problem.wishes.goals)
    result.goals.push_back({goal, before[goal.measure].unit, shown_value(problem, goal, start),
                            shown_value(problem, goal, found.design),
                            cost_of(problem, goal, {found.design.values, found.design.numbers, {}}).cost});
  Multipliers multipliers(found.optimality);
  for (const Constraint& constraint : problem.wishes.constraints)
    result.constraints.push_back(
        found_constraint(problem, constraint, start, found.design, multipliers, before[constraint.measure].unit));
  return result;
}

std::vector<FoundCurve> found_curves(const DesignProblem& problem, const std::vector<Response>& before,
                                     const std::vector<Response>& after) {
  std::vector<FoundCurve> curves;
  for (std::size_t m = 0; m < problem.measures.measures.size(); ++m) {
    const Measure& measure = problem.measures.measures[m];
    if (measure.of != Measure::Of::curve || before[m].at != after[m].at) continue;
    FoundCurve curve{"kc:" + measure.axle + ":" + measure.curve + ":" + measure.part,
                     before[m].unit,
                     before[m].abscissa,
                     before[m].at,
                     before[m].values,
                     after[m].values};
    for (const Goal& goal : problem.wishes.goals)
      if (goal.measure == m) curve.target = at_all_points(goal.target, curve.at.size());
    for (const Constraint& constraint : problem.wishes.constraints) {
      if (constraint.measure != m) continue;
      const std::vector<double> limits = at_all_points(constraint.limit, curve.at.size());
      if (constraint.kind != Constraint::Kind::at_most) curve.least = limits;
      if (constraint.kind != Constraint::Kind::at_least) curve.most = limits;
    }
    curves.push_back(std::move(curve));
  }
  return curves;
}

}  // namespace mbgen::optimise
