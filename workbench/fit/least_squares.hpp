#pragma once
// Bounded nonlinear least squares, by Ceres (S. Agarwal, K. Mierle and others).

#include <Eigen/Core>
#include <functional>
#include <string>

namespace mbgen::fit {

/// Half the sum of squares at a point, as few rows: only the norm of the residuals, J' r and J' J matter to the method.
struct Reduced {
  Eigen::VectorXd residuals;
  Eigen::MatrixXd jacobian;  ///< one row a residual; empty where only the sum of squares was asked for
};

/// A problem in scaled unknowns. rows: of all residuals; evaluate: false where the model has no result there.
struct LeastSquares {
  Eigen::VectorXd start, lower, upper;
  int rows = 0;
  std::function<bool(const Eigen::VectorXd& unknowns, bool with_jacobian, Reduced& reduced)> evaluate;
  std::function<bool(int iteration, double cost)> goes_on;  ///< asked after every iteration
};

struct LeastSquaresResult {
  Eigen::VectorXd unknowns;
  double cost = 0;  ///< half the sum of squares
  int iterations = 0;
  bool converged = false;
  std::string message;  ///< of the method, for people
};

/// Levenberg-Marquardt in a trust region, with bounds, until steps are below 1e-10 of the unknowns or lower the
/// sum of squares by less than 1e-12 of it, the gradient vanishes, or `most` iterations. Requires: the start lies
/// between the bounds and evaluates.
using Method = void (*)(const LeastSquares& problem, int most, LeastSquaresResult& result);

/// The method of the library beside mbgen (with Ceres, two dozen more libraries are loaded: fit alone waits for them).
/// Fails: UserError, where mbgen is built without Ceres or its library is not found.
Method least_squares_method();

}  // namespace mbgen::fit
