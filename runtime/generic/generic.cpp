#include "runtime/generic/generic.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "mbgen/solver/closure.hpp"
#include "runtime/generic/by_recursion.hpp"
#include "runtime/generic/equations.hpp"

namespace mbgen {

GenericSolver::GenericSolver(const Model& model, const Topology& topology, const Analysis& analysis,
                             const GenericAlgebra& algebra)
    : equations_(std::make_unique<GenericEquations>(model, topology, analysis, algebra)) {}
GenericSolver::~GenericSolver() = default;
GenericSolver::GenericSolver(GenericSolver&&) noexcept = default;

void GenericSolver::set_inputs(const std::vector<double>& inputs) {
  equations_->at.environment.inputs = inputs;  // no constant of a model depends on them
}

void GenericSolver::set_parameters(const std::vector<double>& tunable_parameters) {
  std::vector<double>& parameters = equations_->at.environment.parameters;
  std::size_t next = 0;
  for (std::size_t p = 0; p < parameters.size(); ++p)
    if (equations_->model.parameters[p].tunable) parameters[p] = tunable_parameters[next++];
  equations_->refresh();
}

Status GenericSolver::accelerations(const GenericState& state, const std::vector<double>& tau,
                                    GenericDerivative& derivative, StepClock* clock) const {
  const auto end_of = [clock](Step step) {
    if (clock) clock->at_end_of(static_cast<int>(step));
  };
  if (clock) clock->start();
  GenericEquations& equations = *equations_;
  if (const Status status = equations.check_arguments(state, tau); !status.ok()) return status;
  System<double>& system = equations.system(state);
  for (const Drive<double>& d : drives(system))
    if (!std::isfinite(d.acceleration)) return {Code::not_a_number, d.coordinate};
  if (equations.recursive && !clock) return accelerations_by_recursion(equations, state, tau, derivative);
  const Kinematics<double> k = kinematics(system);
  const Inertias<double> m = inertias(system, k);
  end_of(Step::inertias);
  // A clock sees the closures of positions apart from those of accelerations, which are cheaper together.
  const Closures& closed =
      equations.closures_to_factorise(system, k, clock ? equations.rest : equations.motion_of_blocks(system, k));
  if (const Status status = equations.algebra.factorise(closed); !status.ok()) return status;
  end_of(Step::jacobian);
  equations.algebra.form_rz();
  end_of(Step::projection);
  const Velocities<double> v = velocities(system, k);
  end_of(Step::velocities);
  const AppliedForces<double> forces = applied_forces(system, k, v);
  if (const Status status = check_holds(forces.hold); !status.ok()) return status;
  end_of(Step::forces);
  if (clock) equations.places.evaluate(system, k, equations.motion_of_blocks(system, k), equations.at_hand);
  std::vector<double> zdd = equations.starred_accelerations(system, GenericEquations::closure_accelerations(closed));
  end_of(Step::closure_bias);
  const Accelerations<double> a = mbgen::accelerations(system, k, v, zdd);
  const std::vector<double> q = tree_forces(system, k, m, v, a, forces, tau);
  end_of(Step::accelerations);
  tree_mass_matrix(system, k, m, equations.mass);
  equations.algebra.reduce(equations.mass, q, equations.reduced);
  end_of(Step::reduced_system);
  if (const int direction = solve_free(equations.reduced, equations.free); direction >= 0)
    return {Code::no_inertia, equations.coordinate_of(direction)};
  equations.algebra.add_rz_times(equations.free, zdd);
  GenericDerivative result{std::move(zdd), forces.xd};
  end_of(Step::solution);
  const Status status = check_finite(result);
  if (status.ok()) derivative = std::move(result);
  return status;
}

Status GenericSolver::project(GenericState& state) const {
  if (const Status status = equations_->check_arguments(state, {}); !status.ok()) return status;
  GenericState trial = state;
  const Topology& topology = equations_->topology;
  const double tolerance = equations_->model.solver.closure_tolerance;
  double previous = INFINITY;
  for (int step = 0;; ++step) {
    System<double>& system = equations_->system(trial);
    if (const Status status = GenericEquations::follow_motions(system, trial); !status.ok()) return status;
    const Closures& closures = equations_->closures_to_factorise(system, kinematics(system), equations_->rest);
    if (const Status status = equations_->algebra.factorise(closures); !status.ok()) return status;
    PerBlock right_hand_side;
    for (const SparseClosure<double>& closed : closures) right_hand_side.emplace_back(closed.residual.size(), 0.0);
    equations_->algebra.solve(right_hand_side, trial.zd);
    int open = -1;
    double size = 0;
    for (std::size_t b = 0; b < closures.size(); ++b) {
      const double of_block = largest_absolute(closures[b].residual);
      if (of_block <= tolerance) continue;
      open = static_cast<int>(b);
      size = of_block <= size ? size : of_block;
      std::transform(closures[b].residual.begin(), closures[b].residual.end(), right_hand_side[b].begin(),
                     std::negate<>());
    }
    // Angles of many turns round above the tolerance, as in mbgen/solver/closure.hpp.
    if (open < 0 || (!(size < 0.5 * previous) && size <= kRoundingFloor<double>)) break;
    previous = size;
    if (step == kNewtonIterations) return {Code::loop_not_closed, open};
    std::vector<double> dz(trial.z.size(), 0.0);
    equations_->algebra.solve(right_hand_side, dz);
    for (std::size_t b = 0; b < closures.size(); ++b) {
      double longest = 0;
      for (int j : topology.blocks[b].joints) longest = std::isnan(dz[j]) ? dz[j] : std::max(longest, std::abs(dz[j]));
      if (!std::isfinite(longest)) return {Code::loop_not_closed, static_cast<int>(b)};
      const double scale = shortening(longest, kLargestNewtonStep<double>);
      for (int j : topology.blocks[b].joints) trial.z[j] += scale * dz[j];
    }
  }
  const Status status = equations_->check_arguments(trial, {});
  if (status.ok()) state = std::move(trial);
  return status;
}

std::vector<double> GenericSolver::multipliers(const GenericState& state, const std::vector<double>& tau,
                                               const GenericDerivative& derivative) const {
  System<double>& system = equations_->system(state);
  const Solved solved = equations_->solved(system, tau, derivative.zdd);
  return in_loop_order(equations_->topology, solved.multipliers);
}

std::vector<double> GenericSolver::driving_forces(const GenericState& state, const std::vector<double>& tau,
                                                  const GenericDerivative& derivative) const {
  System<double> system = equations_->system(state);
  return equations_->driving_forces(system, equations_->solved(system, tau, derivative.zdd));
}

std::vector<Pose> GenericSolver::poses(const GenericState& state) const {
  System<double>& system = equations_->system(state);
  const Kinematics<double> k = kinematics(system);
  std::vector<Pose> poses;
  for (std::size_t b = 0; b < equations_->model.bodies.size(); ++b) {
    const Pose& reference = equations_->model.bodies[b].pose;
    const int tree = equations_->topology.tree_body[b];
    poses.push_back(reference);
    if (tree == kGround) {
      const Vector<double>& shift = system.constants.shift[b];
      const double moved[] = {shift.x, shift.y, shift.z};
      for (std::size_t k = 0; k < 3; ++k) poses.back().origin[k] += moved[k];
      continue;
    }
    const Vector<double> from_joint = constant<double>(reference.origin) -
                                      carrier_origin(equations_->topology, system.constants, static_cast<int>(b));
    const Vector<double> origin = position_in(system, k, {tree, from_joint}, kGround);
    const Matrix<double> axes = pose_rotation<double>(reference);
    const auto turned = [&](const Vector<double>& axis) { return direction_in(system, k, tree, axis, kGround); };
    const Vector<double> x = turned(axes.x), y = turned(axes.y), z = turned(axes.z);
    poses.back() = {{origin.x, origin.y, origin.z}, {x.x, y.x, z.x, x.y, y.y, z.y, x.z, y.z, z.z}};
  }
  return poses;
}

std::vector<double> GenericSolver::position_residuals(const GenericState& state) const {
  System<double>& system = equations_->system(state);
  std::vector<std::vector<double>> by_block;
  for (const SparseClosure<double>& closed : equations_->closures(system, kinematics(system)))
    by_block.push_back(closed.residual);
  return in_loop_order(equations_->topology, by_block);
}

std::vector<double> GenericSolver::velocity_residuals(const GenericState& state) const {
  System<double>& system = equations_->system(state);
  std::vector<std::vector<double>> by_block;
  const Closures closures = equations_->closures(system, kinematics(system));
  for (std::size_t b = 0; b < closures.size(); ++b) {
    by_block.emplace_back();
    for (const SparseRow<double>& row : closures[b].jacobian)
      by_block.back().push_back(product(row, equations_->topology.blocks[b].joints, state.zd));
  }
  return in_loop_order(equations_->topology, by_block);
}

GenericOutputs GenericSolver::outputs(const GenericState& state, const std::vector<double>& tau,
                                      const GenericDerivative& derivative) const {
  System<double>& system = equations_->system(state);
  const Solved solved = equations_->solved(system, tau, derivative.zdd);
  const std::vector<double> drive = equations_->driving_forces(system, solved);
  std::vector<int> driven;
  for (const Drive<double>& d : drives(system)) driven.push_back(d.coordinate);
  const SolvedState<double> view{solved.prepared.kinematics,
                                 solved.prepared.velocities,
                                 solved.accelerations,
                                 solved.forces,
                                 derivative.zdd,
                                 solved.multipliers,
                                 drive};
  const Energies<double> e = energies(system, view, tau, driven);
  return {output_values(system, view), e.kinetic, e.potential, e.power};
}

}  // namespace mbgen
