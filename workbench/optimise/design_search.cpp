#include "workbench/optimise/design_search.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "workbench/optimise/corners.hpp"
#include "workbench/optimise/probes.hpp"

namespace mbgen::optimise {
namespace {

/// Searches from where the last one ended, while the conditions of first order do not hold.
constexpr int kMostRounds = 4;

/// Rows of a constraint, below the others.
void append(const ConstraintValues& values, Eigen::VectorXd& excess, Eigen::MatrixXd& derivatives) {
  const Eigen::Index before = excess.size();
  excess.conservativeResize(before + values.excess.size());
  excess.tail(values.excess.size()) = values.excess;
  if (values.derivatives.rows() == 0) return;
  derivatives.conservativeResize(excess.size(), values.derivatives.cols());
  derivatives.bottomRows(values.excess.size()) = values.derivatives;
}

void append_same(double value, Eigen::Index count, Eigen::VectorXd& list) {
  list.conservativeResize(list.size() + count);
  list.tail(count).setConstant(value);
}

int count_of(const DesignProblem& problem, bool equal) {
  std::size_t count = 0;
  for (const Constraint& constraint : problem.wishes.constraints)
    if ((constraint.kind == Constraint::Kind::equal) == equal) count += problem.lengths[constraint.measure];
  return static_cast<int>(count);
}

/// Size of the goal and its gradient at a point, above 0. The goal alone tells little of the gradient: a thousandth.
double size_at(const ProgrammePoint& point) {
  constexpr double kPartOfGoal = 1e-3;
  const double size = std::max(point.gradient.cwiseAbs().maxCoeff(), kPartOfGoal * std::abs(point.goal));
  return size > 0 ? size : 1;
}

/// Rows of equalities that repeat none before them at a point; all where none has a gradient.
std::vector<int> independent_rows(const ProgrammePoint& point) {
  constexpr double kSame = 1e-6;  // above the errors of differences
  const Eigen::MatrixXd& rows = point.of_equalities;
  std::vector<int> all(static_cast<std::size_t>(rows.rows())), list;
  std::iota(all.begin(), all.end(), 0);
  Eigen::MatrixXd basis(rows.cols(), 0);
  for (const int k : all) {
    Eigen::VectorXd row = rows.row(k).transpose();
    if (row.norm() == 0) continue;
    row.normalize();
    row -= basis * (basis.transpose() * row).eval();
    if (row.norm() <= kSame) continue;
    list.push_back(k);
    basis.conservativeResize(Eigen::NoChange, basis.cols() + 1);
    basis.rightCols(1) = row.normalized();
  }
  return list.empty() ? all : list;
}

void keep_equalities(const std::vector<int>& kept, ProgrammePoint& point) {
  Eigen::Index row = 0;
  for (const int from : kept) {
    point.equalities[row] = point.equalities[from];
    if (point.of_equalities.rows() > 0) point.of_equalities.row(row) = point.of_equalities.row(from);
    ++row;
  }
  point.equalities.conservativeResize(row);
  if (point.of_equalities.rows() > 0) point.of_equalities.conservativeResize(row, Eigen::NoChange);
}

/// size: by which the goal is divided; equalities: the rows that are told.
Programme programme_of(const DesignProblem& problem, const DesignTask& task, double size,
                       const std::vector<int>& equalities, Designs& designs) {
  Programme programme;
  std::vector<double> lower, upper;
  for (const Unknown& variable : problem.variables) {
    lower.push_back(variable.lower);
    upper.push_back(variable.upper);
  }
  programme.start = designs.scaled(task.start);
  programme.lower = designs.scaled(lower);
  programme.upper = designs.scaled(upper);
  programme.inequalities = count_of(problem, false) + (task.bounded ? 1 : 0);
  programme.equalities = static_cast<int>(equalities.size());
  programme.goes_on = [&problem] { return !problem.is_stopped || !problem.is_stopped(); };
  programme.evaluate = [&, size, equalities](const Eigen::VectorXd& variables, bool with_derivatives,
                                             ProgrammePoint& point) {
    Design design;
    if (!designs.evaluate(designs.unscaled(variables), with_derivatives, design)) return false;
    point = point_of(problem, task, design);
    point.goal /= size;
    point.gradient /= size;
    keep_equalities(equalities, point);
    return true;
  };
  return programme;
}

/// The first broken constraint in words, "" where all are kept.
std::string broken_words(const DesignProblem& problem, const Design& design) {
  for (const Constraint& constraint : problem.wishes.constraints) {
    const ConstraintValues values = excess_of(problem, constraint, design);
    if (is_broken(constraint, values))
      return fmt::format("{} is broken by {:.4g}", constraint.name, broken_by(constraint, values) * constraint.scale);
  }
  return "";
}

std::string status_of(const DesignProblem& problem, const DesignTask& task, const SearchedDesign& found) {
  const std::string broken = broken_words(problem, found.design);
  if (!broken.empty()) return broken;
  if (task.bounded && found.point.inequalities[found.point.inequalities.size() - 1] > kPartBroken)
    return "the bounded goal is not reached";
  if (found.optimality.rest <= kSmallRest) return "ok";
  return fmt::format("not at its end: the conditions of first order are left by {:.2g}", found.optimality.rest);
}

/// Takes a design with derivatives as the one that is found.
void take(const DesignProblem& problem, const DesignTask& task, const Programme& programme,
          const Eigen::VectorXd& variables, double size, Design design, SearchedDesign& found) {
  found.design = std::move(design);
  found.point = point_of(problem, task, found.design);
  found.optimality =
      optimality_at(found.point, variables, programme.lower, programme.upper, std::max(size, size_at(found.point)));
  found.status = status_of(problem, task, found);
  found.keeps_constraints = broken_words(problem, found.design).empty();
}

/// Size of the goal in the search, and evaluations that are left.
struct Limits {
  double size = 1;
  int evaluations = 0;
};

/// Goes on to a corner of the goal, which is an end where no probe beside it is lower.
void end_at_corner(const DesignProblem& problem, const DesignTask& task, const Limits& limits,
                   const std::vector<int>& equalities, Designs& designs, SearchedDesign& found) {
  const double own = size_at(found.point);
  const Programme programme = programme_of(problem, task, own, equalities, designs);
  constexpr double kShortestExact = 1e-7, kShortestOfDifferences = 1e-4;
  const auto is_exact = [](const MeasureSource& source) { return source.has_derivatives(); };
  const double shortest =
      std::ranges::all_of(problem.measures.sources, is_exact) ? kShortestExact : kShortestOfDifferences;
  const std::optional<CornerEnd> corner =
      corner_near(programme, designs.scaled(found.design.values), 1, limits.evaluations, shortest);
  Design design;
  if (!corner || !designs.evaluate(designs.unscaled(corner->variables), true, design)) return;
  // Along its slopes the corner is known up to the shortest step.
  const std::optional<BetterPoint> lower = better_beside(programme, corner->variables, corner->optimality, 1, false);
  if (lower && lower->gain > shortest) return;
  std::optional<Optimality> told = corner->optimality;
  if (shortest != kShortestExact) told = multipliers_around(programme, corner->variables, 1);
  if (problem.is_stopped && problem.is_stopped()) return;
  take(problem, task, programme, corner->variables, limits.size, std::move(design), found);
  const double more = own / std::max(limits.size, size_at(found.point));
  found.optimality = told.value_or(corner->optimality);
  for (Eigen::VectorXd* list : {&found.optimality.inequalities, &found.optimality.equalities, &found.optimality.bounds})
    // Of the goal, not of the goal over its size.
    *list *= told ? own : std::numeric_limits<double>::quiet_NaN();
  found.optimality.rest = more * corner->optimality.rest;
  found.status = status_of(problem, task, found);
  found.ended += "; at a corner of the goal, where its gradients cancel";
}

/// Element `index` of Halton's sequence of a base, in (0, 1). Source: J. H. Halton, Numer. Math. 2, 1960.
double halton(int index, int base) {
  double value = 0, part = 1;
  for (int rest = index; rest > 0; rest /= base) {
    part /= base;
    value += part * (rest % base);
  }
  return value;
}

/// The base of a variable: a prime number.
int base_of(std::size_t variable) {
  int candidate = 1;
  for (std::size_t found = 0; found <= variable;) {
    ++candidate;
    bool is_prime = true;
    for (int divisor = 2; divisor * divisor <= candidate; ++divisor) is_prime = is_prime && candidate % divisor != 0;
    found += is_prime ? 1 : 0;
  }
  return candidate;
}

}  // namespace

ProgrammePoint point_of(const DesignProblem& problem, const DesignTask& task, const Design& design) {
  ProgrammePoint point;
  const Eigen::Index columns = design.derivatives.cols();
  const bool has_derivatives = design.derivatives.rows() > 0;
  point.of_inequalities.resize(0, columns);
  point.of_equalities.resize(0, columns);
  if (has_derivatives) point.gradient.setZero(columns);
  for (std::size_t g = 0; g < problem.wishes.goals.size(); ++g) {
    if (task.goal && *task.goal != g) continue;
    const GoalValue value = cost_of(problem, problem.wishes.goals[g], design);
    point.goal += value.cost;
    if (has_derivatives) point.gradient += value.gradient;
  }
  for (const Constraint& constraint : problem.wishes.constraints) {
    const ConstraintValues values = excess_of(problem, constraint, design);
    const bool is_equal = constraint.kind == Constraint::Kind::equal;
    append(values, is_equal ? point.equalities : point.inequalities,
           is_equal ? point.of_equalities : point.of_inequalities);
    if (!is_equal) append_same(near_part(constraint), values.excess.size(), point.near);
  }
  if (!task.bounded) return point;
  append_same(kActivePart, 1, point.near);
  const GoalValue bounded = cost_of(problem, problem.wishes.goals[*task.bounded], design);
  ConstraintValues values{Eigen::VectorXd::Constant(1, (bounded.cost - task.most) / task.bounded_size),
                          Eigen::MatrixXd(0, columns)};
  if (has_derivatives) values.derivatives = bounded.gradient.transpose() / task.bounded_size;
  append(values, point.inequalities, point.of_inequalities);
  return point;
}

double size_of(const DesignProblem& problem, std::optional<std::size_t> goal, const Design& design) {
  return size_at(point_of(problem, {.goal = goal}, design));
}

std::optional<SearchedDesign> search_design(const DesignProblem& problem, const DesignTask& task, Designs& designs) {
  SearchedDesign found;
  Design design;
  if (!designs.evaluate(task.start, true, design)) return {};
  const double size = task.size > 0 ? task.size : size_of(problem, task.goal, design);
  std::vector<int> all(static_cast<std::size_t>(count_of(problem, true)));
  std::iota(all.begin(), all.end(), 0);
  std::vector<int> told = all;
  Programme programme = programme_of(problem, task, size, told, designs);
  Method method = problem.method;
  take(problem, task, programme, programme.start, size, design, found);
  double divisor = size;
  long spent = designs.count();  // probes are beyond the number of evaluations
  std::optional<BetterPoint> better;
  for (int round = 0; round < kMostRounds; ++round) {
    const int most = problem.most_evaluations - static_cast<int>(designs.count() - spent);
    if (most <= 0) break;
    const ProgrammeEnd end = solve(programme, method, most);
    if (problem.is_stopped && problem.is_stopped()) return {};
    found.ended = (method != problem.method ? "cobyla, as slsqp found no step: " : "") + end.words;
    if (!designs.evaluate(designs.unscaled(end.variables), true, design)) {
      found.ended += "; there the model has no derivatives";
      break;
    }
    const bool has_moved = design.values != found.design.values;
    take(problem, task, programme, end.variables, size, design, found);
    programme.start = end.variables;
    if (found.status != "ok" && has_moved && found.keeps_constraints) continue;
    if (!found.keeps_constraints) {
      const std::vector<int> independent = independent_rows(found.point);
      const bool is_stuck = independent == told && !has_moved;
      if (is_stuck && method != Method::slsqp) break;
      if (is_stuck) method = Method::cobyla;
      told = independent;
      programme = programme_of(problem, task, divisor, told, designs);
      programme.start = end.variables;
      continue;
    }
    const long before = designs.count();
    better = better_beside(programme_of(problem, task, divisor, all, designs), end.variables, found.optimality, divisor,
                           found.design.values == task.start);
    spent += designs.count() - before;
    if (problem.is_stopped && problem.is_stopped()) return {};
    if (!better || !designs.evaluate(designs.unscaled(better->variables), true, design)) break;
    divisor = size_at(point_of(problem, task, design));
    programme = programme_of(problem, task, divisor, told, designs);
    programme.start = better->variables;
  }
  if (better && found.status == "ok")
    found.status = fmt::format("not at its end: a step beside it the goal is lower by {:.2g}", better->gain);
  const int left = problem.most_evaluations - static_cast<int>(designs.count() - spent);
  if (found.status != "ok" && found.keeps_constraints && left > 0)
    end_at_corner(problem, task, {size, left}, all, designs, found);
  return found;
}

std::vector<std::optional<SearchedDesign>> search_from_starts(const DesignProblem& problem, const DesignTask& task,
                                                              int starts, Designs& designs) {
  std::vector<std::optional<SearchedDesign>> list;
  Design first;
  if (!designs.evaluate(task.start, true, first)) return list;
  for (int s = 0; s < starts; ++s) {
    DesignTask from = task;
    from.size = size_of(problem, task.goal, first);
    for (std::size_t v = 0; s > 0 && v < problem.variables.size(); ++v) {
      const Unknown& variable = problem.variables[v];
      from.start[v] = variable.lower + halton(s, base_of(v)) * (variable.upper - variable.lower);
    }
    list.push_back(search_design(problem, from, designs));
    if (problem.is_stopped && problem.is_stopped()) break;
  }
  return list;
}

bool is_better(const SearchedDesign& one, const SearchedDesign& other) {
  if (one.keeps_constraints != other.keeps_constraints) return one.keeps_constraints;
  if ((one.status == "ok") != (other.status == "ok")) return one.status == "ok";
  return one.point.goal < other.point.goal;
}

}  // namespace mbgen::optimise
