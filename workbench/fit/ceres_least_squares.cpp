// The only source that includes Ceres, whose user guide (version 2.1) documents its functions and options: a library of
// its own, that mbgen loads for `fit`.

#include <ceres/ceres.h>
#include <glog/logging.h>

#include <algorithm>

#include "workbench/fit/least_squares.hpp"

namespace mbgen::fit {
namespace {

constexpr double kSmallStep = 1e-10, kSmallGradient = 1e-10, kSmallChange = 1e-12;

class ReducedCost : public ceres::CostFunction {
 public:
  explicit ReducedCost(const LeastSquares& problem) : problem_(problem) {
    set_num_residuals(problem.rows);
    mutable_parameter_block_sizes()->push_back(static_cast<int>(problem.start.size()));
  }
  bool Evaluate(const double* const* unknowns, double* residuals, double** jacobians) const override {
    using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    const Eigen::Index size = problem_.start.size();
    const bool with_jacobian = jacobians != nullptr && jacobians[0] != nullptr;
    Reduced reduced;
    if (!problem_.evaluate(Eigen::Map<const Eigen::VectorXd>(unknowns[0], size), with_jacobian, reduced)) return false;
    Eigen::Map<Eigen::VectorXd>(residuals, problem_.rows) = reduced.residuals;
    if (!with_jacobian) return true;
    if (size == 1) {
      Eigen::Map<Eigen::VectorXd>(jacobians[0], problem_.rows) = reduced.jacobian.col(0);
    } else {
      Eigen::Map<Rows>(jacobians[0], problem_.rows, size) = reduced.jacobian;
    }
    return true;
  }

 private:
  const LeastSquares& problem_;
};

class Watch : public ceres::IterationCallback {
 public:
  explicit Watch(const LeastSquares& problem) : problem_(problem) {}
  ceres::CallbackReturnType operator()(const ceres::IterationSummary& summary) override {
    return problem_.goes_on(summary.iteration, summary.cost) ? ceres::SOLVER_CONTINUE : ceres::SOLVER_ABORT;
  }

 private:
  const LeastSquares& problem_;
};

}  // namespace

/// least_squares.hpp, Method.
extern "C" __attribute__((visibility("default"))) void mbgen_least_squares(const LeastSquares& problem, int most,
                                                                           LeastSquaresResult& result) {
  FLAGS_minloglevel = google::GLOG_FATAL;  // a step that the model cannot take is no news
  result.unknowns = problem.start;
  ceres::Problem of_ceres;
  of_ceres.AddResidualBlock(new ReducedCost(problem), nullptr, result.unknowns.data());
  for (int i = 0; i < static_cast<int>(problem.start.size()); ++i) {
    of_ceres.SetParameterLowerBound(result.unknowns.data(), i, problem.lower[i]);
    of_ceres.SetParameterUpperBound(result.unknowns.data(), i, problem.upper[i]);
  }
  Watch watch(problem);
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_QR;
  options.logging_type = ceres::SILENT;
  options.max_num_iterations = most;
  options.function_tolerance = kSmallChange;
  options.gradient_tolerance = kSmallGradient;
  options.parameter_tolerance = kSmallStep;
  options.callbacks.push_back(&watch);
  options.update_state_every_iteration = true;  // a failure beside a point leaves the point, not the start
  ceres::Solver::Summary summary;
  ceres::Solve(options, &of_ceres, &summary);
  result.cost = summary.final_cost;
  if (!summary.IsSolutionUsable())
    for (const ceres::IterationSummary& one : summary.iterations) result.cost = std::min(result.cost, one.cost);
  result.iterations = static_cast<int>(summary.iterations.size()) - 1;
  result.converged = summary.termination_type == ceres::CONVERGENCE;
  result.message = summary.message;
}

}  // namespace mbgen::fit
