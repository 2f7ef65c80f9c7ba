#include "runtime/judges/cartesian.hpp"

#include <cmath>

#include "compiler/model/inputs.hpp"
#include "runtime/judges/evaluation.hpp"
#include "runtime/judges/inverse_dynamics.hpp"
#include "runtime/judges/methods.hpp"
#include "runtime/judges/runge_kutta.hpp"

namespace mbgen {
namespace {

/// Time constant of Baumgarte's method in steps of the model: independent of the present step, so that the integrated
/// equations do not change with it.
constexpr double kStepsToClose = 50;

bool same(const GenericState& a, const GenericState& b) {
  return a.z == b.z && a.zd == b.zd && a.x == b.x && a.t == b.t;
}

/// Solution of equations (5).
struct Solved {
  Evaluation evaluation;
  CartesianSolution solution;
};

}  // namespace

struct CartesianSolver::Content {
  Topology topology;
  CartesianSystem system;
  CartesianMethod method;
  Stabilisation stabilisation;
  double closure_tolerance;
  double closing_rate;  ///< alpha of Baumgarte's method, 1/s
  std::vector<Input> model_inputs;
  std::vector<double> inputs;  ///< at the start of a step
  PlacedState left;            ///< after the last step; its z is empty before the first one

  Content(const Model& model, const Topology& t, CartesianMethod m, Stabilisation s)
      : topology(t),
        system(model, t),
        method(m),
        stabilisation(s),
        closure_tolerance(model.solver.closure_tolerance),
        closing_rate(1 / (kStepsToClose * model.solver.step)),
        model_inputs(model.inputs) {
    for (const Input& input : model.inputs) inputs.push_back(input.default_value);
  }

  Mechanics mechanics() const { return {system, topology}; }

  /// The bodies after the last step, or placed along the tree.
  PlacedState configuration(const GenericState& state) const {
    return same(left.z, state) ? left : PlacedState{system.place(state), state};
  }

  Status solve_at(const PlacedState& at, const std::vector<double>& tau, Solved& solved) const {
    Status status = evaluate(mechanics(), at, tau, {}, solved.evaluation);
    if (!status.ok()) return status;
    const CartesianTerms& terms = solved.evaluation.terms;
    const ConstraintFactors& factors = *solved.evaluation.factors;
    const ReducedBias bias = factors.reduce(terms.bias);
    status = check_compatibility(mechanics(), solved.evaluation, bias);
    if (status.ok()) solved.solution = solve(method, {terms.mass, terms.force, factors, bias});
    return status;
  }

  /// Rates at one stage of a step. equations: kept equations, set by the first stage. The later stages are not closed,
  /// so that another choice among redundant equations would change the differential equation.
  Status stage(const PlacedState& at, std::vector<int>& equations, CartesianRates& rates) const {
    const std::vector<double> no_tau(at.z.z.size(), 0.0);
    Evaluation evaluation;
    Status status = evaluate(mechanics(), at, no_tau, equations, evaluation);
    if (!status.ok()) return status;
    CartesianTerms& terms = evaluation.terms;
    const ConstraintFactors& factors = *evaluation.factors;
    if (equations.empty()) status = check_compatibility(mechanics(), evaluation, factors.reduce(terms.bias));
    if (!status.ok()) return status;
    equations = factors.kept();
    if (stabilisation == Stabilisation::baumgarte)
      terms.bias -= 2 * closing_rate * terms.velocity + closing_rate * closing_rate * terms.residual;
    rates.qdd = solve(method, {terms.mass, terms.force, factors, factors.reduce(terms.bias)}).qdd;
    rates.xd = terms.xd;
    return rates.qdd.allFinite() ? Status{} : Status{Code::not_a_number, -1};
  }

  /// Inputs dt seconds after the start of the step, extrapolated by their derivatives.
  void advance_inputs(double dt) {
    if (inputs_have_derivatives(model_inputs)) system.set_inputs(advanced_inputs(model_inputs, inputs, dt));
  }

  /// Sets the sampled values that are due at the start of a step of h seconds.
  Status sample(PlacedState& at, double h, bool& any) const {
    Solved before;
    Status status;
    if (system.takes_reactions()) status = solve_at(at, std::vector<double>(at.z.z.size(), 0.0), before);
    if (status.ok()) status = system.sample(at.bodies, at.z, before.solution.qdd, before.solution.lambda, h, any);
    if (status.ok()) at.z.x = at.bodies.x;
    return status;
  }

  /// Result of a step of h seconds.
  Status advance(PlacedState& at, double h) {
    std::vector<int> equations;
    bool any = false;
    Status status = sample(at, h, any);
    if (!status.ok()) return status;
    const GenericState start = at.z;
    const auto derivative = [&](const CartesianState& bodies, CartesianRates& rates) {
      advance_inputs(bodies.t - start.t);
      return stage({bodies, system.joint_state(bodies, start)}, equations, rates);
    };
    status = runge_kutta_step(derivative, at.bodies, h);
    if (!status.ok()) return status;
    advance_inputs(h);
    at.z = system.joint_state(at.bodies, start);
    if (const Status finite = check_finite(at.z, {}, inputs); !finite.ok()) return finite;
    return stabilisation == Stabilisation::projection ? close(mechanics(), closure_tolerance, at) : Status{};
  }
};

CartesianSolver::CartesianSolver(const Model& model, const Topology& topology, CartesianMethod method,
                                 Stabilisation stabilisation)
    : content_(std::make_unique<Content>(model, topology, method, stabilisation)) {}
CartesianSolver::~CartesianSolver() = default;
CartesianSolver::CartesianSolver(CartesianSolver&&) noexcept = default;

void CartesianSolver::set_inputs(const std::vector<double>& inputs) {
  content_->inputs = inputs;
  content_->system.set_inputs(inputs);
}

void CartesianSolver::set_parameters(const std::vector<double>& tunable_parameters) {
  content_->system.set_parameters(tunable_parameters);
  content_->left = {};
}

Status CartesianSolver::accelerations(const GenericState& state, const std::vector<double>& tau,
                                      GenericDerivative& derivative) const {
  Status status = check_finite(state, tau, content_->inputs);
  if (!status.ok()) return status;
  const PlacedState at = content_->configuration(state);
  Solved solved;
  status = content_->solve_at(at, tau, solved);
  if (!status.ok()) return status;
  std::vector<double> zdd = content_->system.joint_accelerations(at.bodies, state, solved.solution.qdd);
  GenericDerivative result{std::move(zdd), solved.evaluation.terms.xd};
  status = check_finite(result);
  if (status.ok()) derivative = std::move(result);
  return status;
}

Status CartesianSolver::project(GenericState& state) const {
  PlacedState trial{{}, state};
  Status status = check_finite(state, {}, content_->inputs);
  if (!status.ok()) return status;
  trial.bodies = content_->system.place(state);
  status = close(content_->mechanics(), content_->closure_tolerance, trial);
  if (status.ok()) state = trial.z;
  return status;
}

Status CartesianSolver::step(GenericState& state, double h) {
  if (!(h > 0) || !std::isfinite(h)) return {Code::step_invalid, -1};
  Status status = check_finite(state, {}, content_->inputs);
  if (!status.ok()) return status;
  PlacedState at = content_->configuration(state);
  status = content_->advance(at, h);
  content_->advance_inputs(0);
  if (!status.ok()) return status;
  state = at.z;
  content_->left = std::move(at);
  return {};
}

Status CartesianSolver::multipliers(const GenericState& state, const std::vector<double>& tau,
                                    std::vector<double>& lambda) const {
  const PlacedState at = content_->configuration(state);
  Solved solved;
  const Status status = content_->solve_at(at, tau, solved);
  if (status.ok()) lambda = content_->system.loop_multipliers(at.bodies, solved.solution.lambda);
  return status;
}

Status CartesianSolver::driving_forces(const GenericState& state, const std::vector<double>& tau,
                                       std::vector<double>& drive) const {
  const PlacedState at = content_->configuration(state);
  Solved solved;
  const Status status = content_->solve_at(at, tau, solved);
  if (status.ok()) drive = content_->system.driving_forces(solved.solution.lambda);
  return status;
}

Status CartesianSolver::inverse_dynamics(const GenericState& state, const std::vector<double>& tau,
                                         const std::vector<int>& independent, GenericDerivative& derivative,
                                         std::vector<double>& force) const {
  Content& content = *content_;
  Status status = check_finite(state, tau, content.inputs);
  if (!status.ok()) return status;
  if (const int bad = first_not_finite(derivative.zdd); bad >= 0) return {Code::not_a_number, bad};
  const PlacedState at = content.configuration(state);
  std::vector<double> inputs = content.inputs;
  for (const Actuator& actuator : content.system.model().actuators)
    if (actuator.input >= 0) inputs[static_cast<std::size_t>(actuator.input)] = 0;
  content.system.set_inputs(inputs);
  Evaluation evaluation;
  status = evaluate(content.mechanics(), at, tau, {}, evaluation);
  const Eigen::MatrixXd columns = actuator_columns(content.system, at, inputs);
  content.system.set_inputs(content.inputs);
  if (!status.ok()) return status;
  const Eigen::VectorXd qdd = accelerations_of(content.system, at, evaluation, independent, derivative.zdd);
  const Eigen::MatrixXd& basis = evaluation.factors->null_basis();
  const Eigen::VectorXd required = basis.transpose() * (evaluation.terms.mass * qdd - evaluation.terms.force);
  std::vector<double> found;
  if (!least_forces(content.system.model(), basis.transpose() * columns, required, found))
    return {Code::actuators_singular, -1};
  derivative.zdd = content.system.joint_accelerations(at.bodies, state, qdd);
  force = std::move(found);
  return {};
}

Status CartesianSolver::reactions(const GenericState& state, const std::vector<double>& tau,
                                  std::vector<std::array<double, 6>>& wrenches) const {
  const PlacedState at = content_->configuration(state);
  Solved solved;
  const Status status = content_->solve_at(at, tau, solved);
  if (!status.ok()) return status;
  wrenches.clear();
  for (const CartesianWrench& wrench :
       content_->system.joint_reactions(at.bodies, state, tau, solved.solution.lambda)) {
    const Eigen::Vector3d &f = wrench.force, &m = wrench.moment;
    wrenches.push_back({f.x(), f.y(), f.z(), m.x(), m.y(), m.z()});
  }
  for (const Eigen::Vector3d& f :
       content_->system.rod_forces(at.bodies, solved.solution.lambda, ReactionOutput::End::to))
    wrenches.push_back({f.x(), f.y(), f.z(), 0, 0, 0});
  return {};
}

Status CartesianSolver::outputs(const GenericState& state, const std::vector<double>& tau,
                                GenericOutputs& values) const {
  const PlacedState at = content_->configuration(state);
  Solved solved;
  const Status status = content_->solve_at(at, tau, solved);
  if (status.ok())
    values = content_->system.outputs(at.bodies, state, tau, solved.solution.qdd, solved.solution.lambda);
  return status;
}

Status CartesianSolver::sample(GenericState& state, double h, bool& any) const {
  PlacedState at = content_->configuration(state);
  const Status status = content_->sample(at, h, any);
  if (status.ok() && any) state.x = at.z.x;
  return status;
}

Status CartesianSolver::set_friction_loads(GenericState& state) const {
  if (!content_->system.takes_reactions()) return {};
  const PlacedState at = content_->configuration(state);
  Solved solved;
  const Status status = content_->solve_at(at, std::vector<double>(state.z.size(), 0.0), solved);
  if (!status.ok()) return status;
  content_->system.set_friction_loads(at.bodies, solved.solution.lambda, state);
  return {};
}

Status CartesianSolver::residuals(const GenericState& state, double& position, double& velocity) const {
  const PlacedState at = content_->configuration(state);
  const std::vector<double> no_tau(state.z.size(), 0.0);
  const CartesianTerms terms = content_->system.terms(at.bodies, state, no_tau);
  position = terms.residual.size() == 0 ? 0 : terms.residual.cwiseAbs().maxCoeff();
  velocity = terms.velocity.size() == 0 ? 0 : terms.velocity.cwiseAbs().maxCoeff();
  return {};
}

}  // namespace mbgen
