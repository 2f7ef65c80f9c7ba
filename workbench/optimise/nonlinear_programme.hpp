#pragma once
// Constrained minimisation in scaled variables, by NLopt (S. G. Johnson, https://github.com/stevengj/nlopt) where mbgen
// is built with it.

#include <Eigen/Core>
#include <functional>
#include <string>

namespace mbgen::optimise {

/// A point: the goal, inequalities (met where <= 0) and equalities (met where 0), and their derivatives, a row each.
struct ProgrammePoint {
  double goal = 0;
  Eigen::VectorXd gradient = {}, inequalities = {}, equalities = {};
  Eigen::MatrixXd of_inequalities = {}, of_equalities = {};
  Eigen::VectorXd near = {};  ///< distances to their limits within which inequalities are active
};

/// Methods: sequential quadratic programming (D. Kraft, 1988 and 1994), the method of moving asymptotes (K. Svanberg,
/// 2002), linear approximations without derivatives (M. J. D. Powell, 1994).
enum class Method { slsqp, mma, cobyla };

/// evaluate: false where the model has no result. goes_on: asked before every evaluation.
struct Programme {
  Eigen::VectorXd start, lower, upper;
  int inequalities = 0, equalities = 0;
  std::function<bool(const Eigen::VectorXd& variables, bool with_derivatives, ProgrammePoint& point)> evaluate = {};
  std::function<bool()> goes_on = {};
};

struct ProgrammeEnd {
  Eigen::VectorXd variables;
  std::string words = {};  ///< for people
};

/// Whether mbgen is built with NLopt.
bool has_nlopt();

/// Searches until steps are below 1e-9 of the variables or change the goal by less than 1e-16 of it, or `most`
/// evaluations. Points without a result are refused: the step is shortened. Requires: has_nlopt(); the start lies
/// between the bounds and evaluates; MMA has no equalities. Fails: with the exceptions of evaluate.
ProgrammeEnd solve(const Programme& programme, Method method, int most);

}  // namespace mbgen::optimise
