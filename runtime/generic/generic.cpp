#include "runtime/generic/generic.hpp"

#include "compiler/formulation/formulation.hpp"
#include "runtime/generic/maggi.hpp"

#include <algorithm>

namespace mbgen {

namespace {

constexpr int kMostNewtonSteps = 20;
constexpr double kLongestNewtonStep = 0.3;   // rad or m; a longer one leaves the basin

/// All that the formulation says about a state before the equations are solved.
struct Prepared {
  Kinematics<double> kinematics;
  Velocities<double> velocities;
  std::vector<BlockClosure<double>> closures;
};

double largest(const std::vector<double>& values) {
  double result = 0;
  for (double v : values) result = std::abs(v) <= result ? result : std::abs(v);   // NaN stays
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

struct GenericSolver::Content {
  Model model;
  Topology topology;
  Analysis analysis;
  Layout layout;
  mutable Scribe<double> scribe;
  std::vector<double> inputs, parameters;
  Environment<double> constants_environment;
  Constants<double> constants;

  Content(const Model& m, const Topology& t, const Analysis& a) : model(m), topology(t), analysis(a), layout(choose_layout(m, t)) {
    for (const Input& input : model.inputs) inputs.push_back(input.default_value);
    for (const Parameter& parameter : model.parameters) parameters.push_back(parameter.value);
    refresh();
  }

  void refresh() {
    constants_environment = Environment<double>{};
    constants_environment.topology = &topology;
    constants_environment.parameters = parameters;
    constants_environment.inputs = inputs;
    constants_environment.z.assign(topology.bodies.size(), 0.0);
    constants_environment.zd = constants_environment.z;
    constants = make_constants(model, topology, constants_environment);
  }

  System<double> system(const GenericState& state) const {
    Environment<double> environment = constants_environment;
    environment.t = state.t;
    environment.z = state.z;
    environment.zd = state.zd;
    return {model, topology, layout, std::move(environment), state.x, constants, scribe};
  }

  Prepared prepare(System<double>& system) const {
    Prepared p;
    p.kinematics = kinematics(system);
    p.velocities = velocities(system, p.kinematics);
    for (const LoopBlock& block : topology.blocks)
      p.closures.push_back(closure(system, p.kinematics, block, relative_motion(system, p.kinematics, block)));
    return p;
  }

  /// Factors of a block by full pivoting, driven columns never dependent.
  BlockFactors factors(std::size_t b, const BlockClosure<double>& closed) const {
    return BlockFactors(closed.jacobian, analysis.blocks[b].driven, analysis.blocks[b].rank);
  }

  /// Rz and zdd_star of every group at this state.
  Status projections(const System<double>& system, const Prepared& p, std::vector<GroupProjection<double>>& result) const {
    const std::vector<Drive<double>> drive = drives(system);
    const auto acceleration = [&](int joint) {
      for (const Drive<double>& d : drive)
        if (d.coordinate == joint) return d.acceleration;
      return 0.0;
    };
    for (const JointGroup& group : topology.groups) {
      GroupProjection<double> projection;
      if (group.block < 0) {
        projection.rz = {analysis.driven[group.joints[0]] ? std::vector<double>{} : std::vector<double>{1.0}};
        projection.zdd_star = {acceleration(group.joints[0])};
      } else {
        const BlockFactors block = factors(group.block, p.closures[group.block]);
        if (block.rank() < analysis.blocks[group.block].rank) return {Code::loop_singular, group.block};
        for (int j : group.joints) projection.zdd_star.push_back(acceleration(j));
        projection.rz = block.rz();
        block.solve(p.closures[group.block].acceleration, projection.zdd_star);
      }
      result.push_back(std::move(projection));
    }
    return {};
  }

  /// tree forces less M zdd, tau included, per coordinate.
  std::vector<double> residual_forces(System<double>& system, const Prepared& p, const Inertias<double>& m,
                                      const Accelerations<double>& a, const AppliedForces<double>& forces,
                                      const std::vector<double>& tau) const {
    return tree_forces(system, p.kinematics, m, p.velocities, a, forces, tau);
  }

  /// Multipliers by block, and what they leave of the residual forces (driving forces with opposite sign).
  std::vector<std::vector<double>> block_multipliers(const Prepared& p, std::vector<double>& residual) const {
    std::vector<std::vector<double>> lambda;
    for (std::size_t b = 0; b < topology.blocks.size(); ++b) {
      const std::vector<int>& joints = topology.blocks[b].joints;
      std::vector<double> right_hand_side;
      for (int j : joints) right_hand_side.push_back(residual[j]);
      lambda.push_back(factors(b, p.closures[b]).multipliers(right_hand_side));
      for (std::size_t e = 0; e < lambda[b].size(); ++e)
        for (std::size_t c = 0; c < joints.size(); ++c) residual[joints[c]] -= p.closures[b].jacobian[e][c] * lambda[b][e];
    }
    return lambda;
  }

  std::vector<double> in_loop_order(const std::vector<std::vector<double>>& by_block) const {
    std::vector<std::vector<double>> of_loop(topology.loops.size());
    for (std::size_t b = 0; b < by_block.size(); ++b) {
      auto next = by_block[b].begin();
      for (int l : topology.blocks[b].loops) {
        of_loop[l].assign(next, next + topology.loops[l].equations);
        next += topology.loops[l].equations;
      }
    }
    std::vector<double> result;
    for (const auto& values : of_loop) result.insert(result.end(), values.begin(), values.end());
    return result;
  }
};

GenericSolver::GenericSolver(const Model& model, const Topology& topology, const Analysis& analysis)
    : content_(std::make_unique<Content>(model, topology, analysis)) {}
GenericSolver::~GenericSolver() = default;
GenericSolver::GenericSolver(GenericSolver&&) noexcept = default;

void GenericSolver::set_inputs(const std::vector<double>& inputs) {
  content_->inputs = inputs;
  content_->refresh();
}

void GenericSolver::set_parameters(const std::vector<double>& tunable_parameters) {
  std::size_t next = 0;
  for (std::size_t p = 0; p < content_->parameters.size(); ++p)
    if (content_->model.parameters[p].tunable) content_->parameters[p] = tunable_parameters[next++];
  content_->refresh();
}

Status GenericSolver::accelerations(const GenericState& state, const std::vector<double>& tau, GenericDerivative& derivative) const {
  for (const std::vector<double>* values : {&state.z, &state.zd, &tau})
    if (const int i = first_not_finite(*values); i >= 0) return {Code::not_a_number, i};
  if (!finite(state.x) || !std::isfinite(state.t)) return {Code::not_a_number, -1};
  System<double> system = content_->system(state);
  const Prepared p = content_->prepare(system);
  const Inertias<double> m = inertias(system, p.kinematics);
  const AppliedForces<double> forces = applied_forces(system, p.kinematics, p.velocities);
  std::vector<GroupProjection<double>> projections;
  if (const Status status = content_->projections(system, p, projections); !status.ok()) return status;
  std::vector<double> zdd_star(state.z.size(), 0.0);
  for (std::size_t g = 0; g < projections.size(); ++g)
    for (std::size_t c = 0; c < projections[g].zdd_star.size(); ++c)
      zdd_star[content_->topology.groups[g].joints[c]] = projections[g].zdd_star[c];
  const Accelerations<double> a = mbgen::accelerations(system, p.kinematics, p.velocities, zdd_star);
  const std::vector<double> q = tree_forces(system, p.kinematics, m, p.velocities, a, forces, tau);
  int singular = -1;
  derivative.zdd = solve_maggi(tree_mass_matrix(system, p.kinematics, m), q, zdd_star, content_->topology, projections, singular);
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
  const Prepared p = content_->prepare(system);
  const Inertias<double> m = inertias(system, p.kinematics);
  const AppliedForces<double> forces = applied_forces(system, p.kinematics, p.velocities);
  const Accelerations<double> a = mbgen::accelerations(system, p.kinematics, p.velocities, derivative.zdd);
  std::vector<double> residual = content_->residual_forces(system, p, m, a, forces, tau);
  return content_->in_loop_order(content_->block_multipliers(p, residual));
}

std::vector<double> GenericSolver::position_residuals(const GenericState& state) const {
  System<double> system = content_->system(state);
  std::vector<std::vector<double>> by_block;
  for (const BlockClosure<double>& closed : content_->prepare(system).closures) by_block.push_back(closed.residual);
  return content_->in_loop_order(by_block);
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
  return content_->in_loop_order(by_block);
}

GenericOutputs GenericSolver::outputs(const GenericState& state, const std::vector<double>& tau,
                                      const GenericDerivative& derivative) const {
  System<double> system = content_->system(state);
  const Prepared p = content_->prepare(system);
  const Inertias<double> m = inertias(system, p.kinematics);
  const AppliedForces<double> forces = applied_forces(system, p.kinematics, p.velocities);
  const Accelerations<double> a = mbgen::accelerations(system, p.kinematics, p.velocities, derivative.zdd);
  std::vector<double> residual = content_->residual_forces(system, p, m, a, forces, tau);
  content_->block_multipliers(p, residual);
  std::vector<double> drive;
  std::vector<int> driven;
  for (const Drive<double>& d : drives(system)) {
    driven.push_back(d.coordinate);
    drive.push_back(-residual[d.coordinate]);
  }
  const SolvedState<double> solved{p.kinematics, p.velocities, a, forces, derivative.zdd, drive};
  const Energies<double> e = energies(system, solved, m, tau, driven);
  return {output_values(system, solved), e.kinetic, e.potential, e.power};
}

}  // namespace mbgen
