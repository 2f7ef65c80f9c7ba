#include "runtime/generic/generic.hpp"

#include <algorithm>

#include "runtime/generic/content.hpp"

namespace mbgen {

namespace {

constexpr int kMostNewtonSteps = 20;
constexpr double kLongestNewtonStep = 0.3;  // rad or m; a longer one leaves the basin

double largest(const std::vector<double>& values) {
  double result = 0;
  for (double v : values) result = std::abs(v) <= result ? result : std::abs(v);  // NaN stays
  return result;
}

bool finite(const std::vector<double>& values) {
  return std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); });
}

int first_not_finite(const std::vector<double>& values) {
  for (std::size_t i = 0; i < values.size(); ++i)
    if (!std::isfinite(values[i])) return static_cast<int>(i);
  return -1;
}

}  // namespace

GenericSolver::GenericSolver(const Model& model, const Topology& topology, const Analysis& analysis)
    : content_(std::make_unique<Content>(model, topology, analysis)) {}
GenericSolver::~GenericSolver() = default;
GenericSolver::GenericSolver(GenericSolver&&) noexcept = default;

void GenericSolver::set_inputs(const std::vector<double>& inputs) {
  content_->inputs = inputs;
  content_->constants_environment.inputs = inputs;  // no constant of a model depends on them
}

void GenericSolver::set_parameters(const std::vector<double>& tunable_parameters) {
  std::size_t next = 0;
  for (std::size_t p = 0; p < content_->parameters.size(); ++p)
    if (content_->model.parameters[p].tunable) content_->parameters[p] = tunable_parameters[next++];
  content_->refresh();
}

Status GenericSolver::accelerations(const GenericState& state, const std::vector<double>& tau,
                                    GenericDerivative& derivative) const {
  for (const std::vector<double>* values : {&state.z, &state.zd, &tau})
    if (const int i = first_not_finite(*values); i >= 0) return {Code::not_a_number, i};
  if (!finite(state.x) || !std::isfinite(state.t)) return {Code::not_a_number, -1};
  System<double> system = content_->system(state);
  const Prepared p = content_->prepare(system);
  const Inertias<double> m = inertias(system, p.kinematics);
  const AppliedForces<double> forces = applied_forces(system, p.kinematics, p.velocities);
  std::vector<GroupProjection<double>> projections;
  if (const Status status = content_->projections(system, p, projections); !status.ok()) return status;
  const std::vector<double> zdd_star = starred_accelerations(content_->topology, projections);
  const Accelerations<double> a = mbgen::accelerations(system, p.kinematics, p.velocities, zdd_star);
  const std::vector<double> q = tree_forces(system, p.kinematics, m, p.velocities, a, forces, tau);
  int singular = -1;
  derivative.zdd =
      solve_maggi(tree_mass_matrix(system, p.kinematics, m), q, zdd_star, content_->topology, projections, singular);
  if (singular >= 0) return {Code::no_inertia, singular};
  derivative.xd = forces.xd;
  if (const int i = first_not_finite(derivative.zdd); i >= 0) return {Code::not_a_number, i};
  return {};
}

Status GenericSolver::project(GenericState& state) const {
  GenericState trial = state;
  const Topology& topology = content_->topology;
  if (const int i = first_not_finite(state.z); i >= 0) return {Code::not_a_number, i};
  const double tolerance = content_->model.solver.closure_tolerance;
  for (int step = 0;; ++step) {
    System<double> system = content_->system(trial);
    for (const Drive<double>& d : drives(system)) {
      trial.z[d.coordinate] = system.environment.z[d.coordinate] = d.position;
      trial.zd[d.coordinate] = system.environment.zd[d.coordinate] = d.velocity;
    }
    const Prepared p = content_->prepare(system);
    int open = -1;
    for (std::size_t b = 0; b < topology.blocks.size(); ++b) {
      const std::vector<int>& joints = topology.blocks[b].joints;
      const BlockFactors factors = content_->factors(b, p.closures[b]);
      if (factors.rank() < content_->analysis.blocks[b].rank) return {Code::loop_singular, static_cast<int>(b)};
      std::vector<double> zd, dz(joints.size(), 0.0), right_hand_side, still(p.closures[b].residual.size(), 0.0);
      for (int j : joints) zd.push_back(trial.zd[j]);
      factors.solve(still, zd);
      for (std::size_t c = 0; c < joints.size(); ++c) trial.zd[joints[c]] = zd[c];
      if (largest(p.closures[b].residual) <= tolerance) continue;
      open = static_cast<int>(b);
      for (double value : p.closures[b].residual) right_hand_side.push_back(-value);
      factors.solve(right_hand_side, dz);
      const double longest = largest(dz);
      if (!std::isfinite(longest)) return {Code::loop_not_closed, open};
      const double scale = longest > kLongestNewtonStep ? kLongestNewtonStep / longest : 1.0;
      for (std::size_t c = 0; c < joints.size(); ++c) trial.z[joints[c]] += scale * dz[c];
    }
    if (open < 0) break;
    if (step == kMostNewtonSteps) return {Code::loop_not_closed, open};
  }
  state = std::move(trial);
  return {};
}

std::vector<double> GenericSolver::multipliers(const GenericState& state, const std::vector<double>& tau,
                                               const GenericDerivative& derivative) const {
  System<double> system = content_->system(state);
  const Solved solved = content_->solved(system, tau, derivative.zdd);
  return in_loop_order(content_->topology, solved.multipliers);
}

std::vector<double> GenericSolver::position_residuals(const GenericState& state) const {
  System<double> system = content_->system(state);
  std::vector<std::vector<double>> by_block;
  for (const BlockClosure<double>& closed : content_->prepare(system).closures) by_block.push_back(closed.residual);
  return in_loop_order(content_->topology, by_block);
}

std::vector<double> GenericSolver::velocity_residuals(const GenericState& state) const {
  System<double> system = content_->system(state);
  std::vector<std::vector<double>> by_block;
  const Prepared p = content_->prepare(system);
  for (std::size_t b = 0; b < p.closures.size(); ++b) {
    by_block.emplace_back();
    for (const std::vector<double>& row : p.closures[b].jacobian) {
      double sum = 0;
      for (std::size_t c = 0; c < row.size(); ++c) sum += row[c] * state.zd[content_->topology.blocks[b].joints[c]];
      by_block.back().push_back(sum);
    }
  }
  return in_loop_order(content_->topology, by_block);
}

GenericOutputs GenericSolver::outputs(const GenericState& state, const std::vector<double>& tau,
                                      const GenericDerivative& derivative) const {
  System<double> system = content_->system(state);
  const Solved solved = content_->solved(system, tau, derivative.zdd);
  std::vector<double> drive;
  std::vector<int> driven;
  for (const Drive<double>& d : drives(system)) {
    driven.push_back(d.coordinate);
    drive.push_back(-solved.unbalanced[d.coordinate]);
  }
  const SolvedState<double> view{solved.prepared.kinematics,
                                 solved.prepared.velocities,
                                 solved.accelerations,
                                 solved.forces,
                                 derivative.zdd,
                                 solved.multipliers,
                                 drive};
  const Energies<double> e = energies(system, view, solved.inertias, tau, driven);
  return {output_values(system, view), e.kinetic, e.potential, e.power};
}

}  // namespace mbgen
