// The only source that includes NLopt, whose reference (version 2.7) documents its functions, methods and results.

#include "workbench/optimise/nonlinear_programme.hpp"

#ifdef MBGEN_NLOPT
#include <nlopt.h>

#include <cmath>
#include <exception>
#include <memory>
#include <vector>
#endif

namespace mbgen::optimise {

#ifdef MBGEN_NLOPT
namespace {

constexpr double kSmallStep = 1e-9, kSmallChange = 1e-16, kBroken = 1e-9;

/// The functions of a programme as NLopt calls them, one after another at the same point.
class Functions {
 public:
  Functions(const Programme& programme, nlopt_opt method) : programme_(programme), method_(method) {}

  double goal(const double* variables, double* gradient) {
    if (!find(variables, gradient != nullptr)) return HUGE_VAL;
    if (gradient != nullptr) Eigen::Map<Eigen::VectorXd>(gradient, point_.gradient.size()) = point_.gradient;
    return point_.goal;
  }
  void inequalities(double* values, const double* variables, double* gradient) {
    give(programme_.inequalities, values, variables, gradient, &ProgrammePoint::inequalities,
         &ProgrammePoint::of_inequalities);
  }
  void equalities(double* values, const double* variables, double* gradient) {
    give(programme_.equalities, values, variables, gradient, &ProgrammePoint::equalities,
         &ProgrammePoint::of_equalities);
  }
  void rethrow() const {
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

  /// The point of these variables; false where there is none. Exceptions must not pass through C.
  bool find(const double* variables, bool with_derivatives) {
    const Eigen::VectorXd at = Eigen::Map<const Eigen::VectorXd>(variables, programme_.start.size());
    const bool is_same = at_.size() == at.size() && at_ == at;
    if (is_same && (has_derivatives_ || !with_derivatives)) return is_good_;
    at_ = at;
    has_derivatives_ = with_derivatives;
    is_good_ = false;
    try {
      if (failure_ || (programme_.goes_on && !programme_.goes_on())) {
        nlopt_force_stop(method_);
      } else {
        ProgrammePoint found;
        is_good_ = programme_.evaluate(at, with_derivatives, found);
        if (is_good_) point_ = std::move(found);
      }
    } catch (...) {
      failure_ = std::current_exception();
      nlopt_force_stop(method_);
    }
    return is_good_;
  }

  /// Constraints; where the point is refused those of the last good one, as the goal tells the method enough.
  void give(int count, double* values, const double* variables, double* gradient, Eigen::VectorXd ProgrammePoint::*of,
            Eigen::MatrixXd ProgrammePoint::*derivatives) {
    find(variables, gradient != nullptr);
    Eigen::Map<Eigen::VectorXd> to(values, count);
    if ((point_.*of).size() != count) {
      to.setZero();
      return;
    }
    to = point_.*of;
    if (gradient != nullptr && (point_.*derivatives).rows() == count)
      Eigen::Map<Rows>(gradient, count, programme_.start.size()) = point_.*derivatives;
  }

  const Programme& programme_;
  nlopt_opt method_;
  Eigen::VectorXd at_;
  ProgrammePoint point_;
  bool has_derivatives_ = false, is_good_ = false;
  std::exception_ptr failure_;
};

std::string words_of(nlopt_result result) {
  switch (result) {
    case NLOPT_FTOL_REACHED:
      return "the goal changes no more";
    case NLOPT_XTOL_REACHED:
      return "steps are below 1e-9";
    case NLOPT_ROUNDOFF_LIMITED:
      return "rounding leaves no better step";
    case NLOPT_MAXEVAL_REACHED:
      return "the number of evaluations is used up";
    case NLOPT_FORCED_STOP:
      return "interrupted";
    case NLOPT_SUCCESS:
      return "the method is at its end";
    case NLOPT_FAILURE:
      return "the method found no further step";
    default:
      return std::string("the method stopped with ") + nlopt_result_to_string(result);
  }
}

nlopt_algorithm algorithm_of(Method method) {
  return method == Method::slsqp ? NLOPT_LD_SLSQP : method == Method::mma ? NLOPT_LD_MMA : NLOPT_LN_COBYLA;
}

}  // namespace

bool has_nlopt() { return true; }

ProgrammeEnd solve(const Programme& programme, Method method, int most) {
  const auto size = static_cast<unsigned>(programme.start.size());
  const std::unique_ptr<nlopt_opt_s, void (*)(nlopt_opt)> made(nlopt_create(algorithm_of(method), size), nlopt_destroy);
  nlopt_opt opt = made.get();
  Functions functions(programme, opt);
  nlopt_set_lower_bounds(opt, programme.lower.data());
  nlopt_set_upper_bounds(opt, programme.upper.data());
  nlopt_set_min_objective(
      opt,
      [](unsigned, const double* x, double* gradient, void* data) {
        return static_cast<Functions*>(data)->goal(x, gradient);
      },
      &functions);
  const std::vector<double> slack(static_cast<std::size_t>(programme.inequalities + programme.equalities), kBroken);
  if (programme.inequalities > 0)
    nlopt_add_inequality_mconstraint(
        opt, static_cast<unsigned>(programme.inequalities),
        [](unsigned, double* values, unsigned, const double* x, double* gradient, void* data) {
          static_cast<Functions*>(data)->inequalities(values, x, gradient);
        },
        &functions, slack.data());
  if (programme.equalities > 0)
    nlopt_add_equality_mconstraint(
        opt, static_cast<unsigned>(programme.equalities),
        [](unsigned, double* values, unsigned, const double* x, double* gradient, void* data) {
          static_cast<Functions*>(data)->equalities(values, x, gradient);
        },
        &functions, slack.data());
  nlopt_set_xtol_rel(opt, kSmallStep);
  nlopt_set_ftol_rel(opt, kSmallChange);
  nlopt_set_maxeval(opt, most);
  ProgrammeEnd end{programme.start};
  double goal = 0;
  const nlopt_result result = nlopt_optimize(opt, end.variables.data(), &goal);
  functions.rethrow();
  end.words = words_of(result);
  return end;
}
#else
bool has_nlopt() { return false; }

ProgrammeEnd solve(const Programme& programme, Method, int) { return {programme.start, false, "no NLopt"}; }
#endif

}  // namespace mbgen::optimise
