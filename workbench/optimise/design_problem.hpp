#pragma once
// A design that is searched: variables, measures, goals and constraints, and their evaluation.

#include <Eigen/Core>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include "workbench/host/progress.hpp"
#include "workbench/optimise/goals.hpp"
#include "workbench/optimise/nonlinear_programme.hpp"
#include "workbench/search/evaluation_journal.hpp"

namespace mbgen::optimise {

/// A problem that was read and checked.
struct DesignProblem {
  const FreeModel& model;
  std::vector<Unknown> variables = {};
  MeasureSet measures = {};
  Wishes wishes = {};
  std::vector<std::size_t> lengths = {};  ///< numbers of each measure
  Method method = Method::slsqp;
  int jobs = 1, most_evaluations = 500;
  std::function<bool()> is_stopped = {};  ///< thread-safe
};

/// All measures of a design, one after another, and their derivatives by the variables in parts of their scales.
struct Design {
  std::vector<double> values;
  Eigen::VectorXd numbers;
  Eigen::MatrixXd derivatives;  ///< a row a number; without rows where not asked for
};

/// A design that has no result.
struct RefusedDesign {
  std::vector<double> values;
  std::string reason;
};

/// An evaluation for the course of a search.
struct EvaluatedDesign {
  double goal = 0, broken = 0;  ///< weighted sum; largest excess of a constraint, in parts of its scale
  bool is_refused = false;
};

/// Responses of all measures at values of the variables.
struct Responses {
  std::string failure;
  std::vector<Response> list;
  std::vector<std::string> warnings;
};
Responses responses_at(const DesignProblem& problem, const std::vector<double>& values, bool with_derivatives);

/// Evaluates designs, each once, with a journal and a line of progress.
class Designs {
 public:
  Designs(const DesignProblem& problem, EvaluationJournal& journal) : problem_(problem), journal_(journal) {}

  /// False where the model has no result.
  bool evaluate(const std::vector<double>& values, bool with_derivatives, Design& design);
  /// Values of scaled variables, between the bounds.
  std::vector<double> unscaled(const Eigen::VectorXd& scaled) const;
  Eigen::VectorXd scaled(const std::vector<double>& values) const;

  long count() const { return count_; }
  long count_with_derivatives() const { return with_derivatives_; }
  const std::vector<RefusedDesign>& refused() const { return refused_; }
  const std::vector<EvaluatedDesign>& course() const { return course_; }

 private:
  bool compute(const std::vector<double>& values, bool with_derivatives, Design& design, std::string& failure);
  bool take_known(const std::string& key, bool with_derivatives, Design& design) const;
  void note(const Design& design);

  const DesignProblem& problem_;
  EvaluationJournal& journal_;
  std::set<std::string> seen_, seen_refusals_;  ///< arguments of this run
  std::vector<RefusedDesign> refused_;
  std::vector<EvaluatedDesign> course_;
  long count_ = 0, with_derivatives_ = 0;
  StatusLine line_;
};

/// The value of a goal of a design, smaller is better, and its derivatives: value / scale, -value / scale, or the mean
/// square of (value - target) / scale.
struct GoalValue {
  double cost = 0;
  Eigen::VectorXd gradient;
};
GoalValue cost_of(const DesignProblem& problem, const Goal& goal, const Design& design);

/// A goal for people, in the unit of its measure: the value, or the root mean square of value - target.
double shown_value(const DesignProblem& problem, const Goal& goal, const Design& design);

/// Excess of a constraint at each of its points, in parts of its scale: met where <= 0, of an equality where 0.
struct ConstraintValues {
  Eigen::VectorXd excess;
  Eigen::MatrixXd derivatives;
};
ConstraintValues excess_of(const DesignProblem& problem, const Constraint& constraint, const Design& design);

/// Largest excess of a constraint; of an equality its size.
double broken_by(const Constraint& constraint, const ConstraintValues& values);

/// Distance to its limit, in parts of its scale, within which a constraint is active.
double near_part(const Constraint& constraint);

/// Whether the excess is beyond the tolerance.
bool is_broken(const Constraint& constraint, const ConstraintValues& values);

}  // namespace mbgen::optimise
