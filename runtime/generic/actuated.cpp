#include "runtime/generic/actuated.hpp"

#include <algorithm>
#include <cmath>

#include "mbgen/motion.hpp"
#include "mbgen/solver/actuated_motion.hpp"
#include "mbgen/solver/newton.hpp"
#include "mbgen/solver/orthonormal.hpp"
#include "runtime/generic/generic.hpp"

namespace mbgen {
namespace {

/// The largest absolute value, NaN if one is.
double largest_of(const std::vector<double>& values) {
  return solver_detail::largest(values.data(), static_cast<int>(values.size()));
}

PerBlock negative(PerBlock values) {
  for (std::vector<double>& block : values)
    for (double& value : block) value = -value;
  return values;
}

PerBlock zeros_like(PerBlock values) {
  for (std::vector<double>& block : values) std::fill(block.begin(), block.end(), 0.0);
  return values;
}

/// Lets coordinates that an actuator moves alone be where it has them.
void set_own_coordinates(const ActuatorsSeen<double>& seen, const std::vector<double>& position, GenericState& state) {
  for (std::size_t i = 0; i < position.size(); ++i) {
    const std::vector<double>& direction = seen.direction[i];
    const auto moves = [](double entry) { return entry != 0; };
    if (std::ranges::count_if(direction, moves) != 1) continue;
    const auto own = static_cast<std::size_t>(std::ranges::find_if(direction, moves) - direction.begin());
    state.z[own] += (position[i] - seen.position[i]) / direction[own];
  }
}

/// Newton's iteration to the positions of the actuators; then motion is at them. Fails: loop_singular, loop_not_closed.
Status move_actuators(GenericEquations& equations, const std::vector<double>& position, GenericState& trial,
                      GenericActuatedMotion& motion) {
  double previous = INFINITY;
  for (int left = kNewtonIterations + 1;; --left) {
    if (left == 0) return {Code::loop_not_closed, 0};
    if (const Status status = GenericEquations::follow_motions(equations.system(trial), trial); !status.ok())
      return status;
    if (const Status status = motion.look(equations, trial); !status.ok()) return status;
    std::vector<double> dz(trial.z.size(), 0.0), along = position;
    equations.algebra.solve(negative(motion.residual), dz);
    for (std::size_t i = 0; i < along.size(); ++i) along[i] -= motion.seen.position[i];
    motion.add_along(along, dz);
    const double size = largest_of(dz);
    if (!std::isfinite(size)) return {Code::loop_not_closed, 0};
    const bool gains = size > 0 && size < 0.5 * previous && left > 1;
    if (size <= equations.model.solver.closure_tolerance || (!gains && size <= kRoundingFloor<double>)) break;
    previous = size;
    const double factor = shortening(size, kLargestNewtonStep<double>);
    for (std::size_t c = 0; c < dz.size(); ++c) trial.z[c] += factor * dz[c];
  }
  for (std::size_t b = 0; b < motion.residual.size(); ++b)
    if (!(largest_of(motion.residual[b]) <= kRedundantTolerance<double>))
      return {Code::loop_not_closed, static_cast<int>(b)};
  return {};
}

}  // namespace

Status GenericActuatedMotion::look(GenericEquations& equations, const GenericState& state) {
  System<double>& system = equations.system(state);
  const Kinematics<double> k = kinematics(system);
  const Closures& closures = equations.closures_to_factorise(system, k, equations.motion_of_blocks(system, k));
  if (const Status status = equations.algebra.factorise(closures); !status.ok()) return status;
  equations.algebra.form_rz();
  residual.clear();
  for (const SparseClosure<double>& closed : closures) residual.push_back(closed.residual);
  acceleration = GenericEquations::closure_accelerations(closures);
  seen = actuators_seen(system);
  coordinates = equations.topology.size();
  actuators = static_cast<int>(equations.model.actuators.size());
  directions = static_cast<int>(free_coordinates(equations.topology, equations.analysis).size());
  const auto n = static_cast<std::size_t>(coordinates), count = static_cast<std::size_t>(directions);
  basis.assign(n * count, 0.0);
  r.assign(count * count, 0.0);
  order.assign(count, 0);
  for (std::size_t q = 0; q < count; ++q) {
    std::vector<double> moved(n, 0.0);
    equations.algebra.add_rz_times(Eigen::VectorXd::Unit(directions, static_cast<Eigen::Index>(q)), moved);
    for (std::size_t c = 0; c < n; ++c) basis[c * count + q] = moved[c];
  }
  orthonormalise(coordinates, directions, basis.data(), r.data(), order.data());
  scale.clear();
  speeds.assign(seen.position.size() * count, 0.0);
  for (std::size_t i = 0; i < seen.position.size(); ++i) {
    scale.push_back(1 / std::sqrt(equations.model.actuators[i].weight));
    for (std::size_t q = 0; q < count; ++q)
      for (std::size_t c = 0; c < n; ++c)
        speeds[i * count + q] += scale[i] * seen.direction[i][c] * basis[c * count + q];
  }
  smallest = orthonormalise(actuators, directions, speeds.data(), r.data(), order.data()) /
             equations.analysis.typical_actuation;
  return {};
}

Status GenericActuatedMotion::actuators_status(const GenericEquations& equations) const {
  if (smallest >= kLeastActuation<double>) return {};
  const std::vector<int> free = free_coordinates(equations.topology, equations.analysis);
  const auto count = static_cast<std::size_t>(directions);
  std::vector<double> motion(count, 0.0), share(count, 0.0);
  motion.back() = 1;
  for (std::size_t k = count - 1; k-- > 0;) {
    for (std::size_t j = k + 1; j < count; ++j) motion[k] -= r[k * count + j] * motion[j];
    motion[k] /= r[k * count + k];
  }
  for (std::size_t k = 0; k < count; ++k) share[static_cast<std::size_t>(order[k])] = motion[k];
  std::size_t most = 0;
  double largest = -1;
  for (std::size_t q = 0; q < count; ++q) {
    double moved = 0;
    for (std::size_t k = 0; k < count; ++k) moved += basis[static_cast<std::size_t>(free[q]) * count + k] * share[k];
    if (std::abs(moved) > largest) largest = std::abs(moved), most = q;
  }
  return {Code::actuators_singular, static_cast<int>(most)};
}

void GenericActuatedMotion::add_along(const std::vector<double>& along, std::vector<double>& x) const {
  const auto count = static_cast<std::size_t>(directions);
  std::vector<double> missing, share(count), work(count);
  for (std::size_t i = 0; i < along.size(); ++i) {
    double value = along[i];
    for (std::size_t c = 0; c < x.size(); ++c) value -= seen.direction[i][c] * x[c];
    missing.push_back(scale[i] * value);
  }
  solve_least_squares(actuators, directions, speeds.data(), r.data(), order.data(), missing.data(), share.data(),
                      work.data());
  for (std::size_t c = 0; c < x.size(); ++c)
    for (std::size_t q = 0; q < count; ++q) x[c] += basis[c * count + q] * share[q];
}

std::vector<double> GenericActuatedMotion::forces_for(const std::vector<double>& tau) const {
  const auto count = static_cast<std::size_t>(directions);
  std::vector<double> along(count, 0.0), force(scale.size()), work(count);
  for (std::size_t q = 0; q < count; ++q)
    for (std::size_t c = 0; c < tau.size(); ++c) along[q] += basis[c * count + q] * tau[c];
  solve_least_norm(actuators, directions, speeds.data(), r.data(), order.data(), along.data(), force.data(),
                   work.data());
  for (std::size_t i = 0; i < force.size(); ++i) force[i] *= scale[i];
  return force;
}

Status GenericSolver::look_at_actuators(const GenericState& state, GenericActuatedMotion& motion) const {
  const Status arguments = equations_->check_arguments(state, std::vector<double>(state.z.size(), 0.0));
  if (!arguments.ok()) return arguments;
  const Status status = motion.look(*equations_, state);
  return status.ok() ? motion.actuators_status(*equations_) : status;
}

Status GenericSolver::actuator_positions(const GenericState& state, std::vector<double>& position,
                                         std::vector<double>& speed) const {
  const Status arguments = equations_->check_arguments(state, std::vector<double>(state.z.size(), 0.0));
  if (!arguments.ok()) return arguments;
  const ActuatorsSeen<double> seen = actuators_seen(equations_->system(state));
  position = seen.position;
  speed.assign(position.size(), 0.0);
  for (std::size_t i = 0; i < speed.size(); ++i)
    for (std::size_t c = 0; c < state.zd.size(); ++c) speed[i] += seen.direction[i][c] * state.zd[c];
  return {};
}

Status GenericSolver::complete_joints(const std::vector<double>& position, const std::vector<double>& speed,
                                      GenericState& state) const {
  GenericEquations& equations = *equations_;
  const Status arguments = equations.check_arguments(state, std::vector<double>(state.z.size(), 0.0));
  if (!arguments.ok()) return arguments;
  if (first_not_finite(position) >= 0 || first_not_finite(speed) >= 0) return {Code::not_a_number, -1};
  GenericState start = state;
  set_own_coordinates(actuators_seen(equations.system(state)), position, start);
  GenericState trial = start;
  GenericActuatedMotion motion;
  if (const Status status = move_actuators(equations, position, trial, motion); !status.ok()) return status;
  if (const Status status = motion.actuators_status(equations); !status.ok()) return status;
  for (std::size_t b = 0; b < equations.topology.blocks.size(); ++b)
    for (const int c : equations.topology.blocks[b].joints)
      if (!equations.analysis.driven[c] && !(std::abs(trial.z[c] - start.z[c]) <= kLargestCorrection<double>))
        return {Code::loop_not_closed, static_cast<int>(b)};
  std::vector<double> zd(trial.z.size(), 0.0);
  for (const Drive<double>& d : drives(equations.system(trial))) zd[d.coordinate] = d.velocity;
  equations.algebra.solve(zeros_like(motion.residual), zd);
  motion.add_along(speed, zd);
  if (const int bad = first_not_finite(zd); bad >= 0) return {Code::not_a_number, bad};
  trial.zd = std::move(zd);
  state = std::move(trial);
  return {};
}

Status GenericSolver::complete_accelerations(const GenericState& state, const std::vector<double>& acceleration,
                                             std::vector<double>& zdd) const {
  GenericActuatedMotion motion;
  if (const Status status = look_at_actuators(state, motion); !status.ok()) return status;
  std::vector<double> all = equations_->starred_accelerations(equations_->system(state), motion.acceleration);
  std::vector<double> along = acceleration;
  for (std::size_t i = 0; i < along.size(); ++i) along[i] -= motion.seen.drift[i];
  motion.add_along(along, all);
  if (const int bad = first_not_finite(all); bad >= 0) return {Code::not_a_number, bad};
  zdd = std::move(all);
  return {};
}

Status GenericSolver::actuator_jacobian(const GenericState& state, std::vector<double>& jacobian) const {
  GenericActuatedMotion motion;
  if (const Status status = look_at_actuators(state, motion); !status.ok()) return status;
  const std::size_t count = motion.scale.size();
  jacobian.assign(state.z.size() * count, 0.0);
  for (std::size_t i = 0; i < count; ++i) {
    std::vector<double> unit(count, 0.0), rates(state.z.size(), 0.0);
    unit[i] = 1;
    motion.add_along(unit, rates);
    for (std::size_t c = 0; c < rates.size(); ++c) jacobian[c * count + i] = rates[c];
  }
  return {};
}

Status GenericSolver::forces_at_actuators(const GenericState& state, const std::vector<double>& tau,
                                          std::vector<double>& force) const {
  GenericActuatedMotion motion;
  if (const Status status = look_at_actuators(state, motion); !status.ok()) return status;
  if (const int bad = first_not_finite(tau); bad >= 0) return {Code::not_a_number, bad};
  force = motion.forces_for(tau);
  return {};
}

Status GenericSolver::forces_at_independent(const GenericState& state, const std::vector<double>& force,
                                            std::vector<double>& tau) const {
  const Status arguments = equations_->check_arguments(state, std::vector<double>(state.z.size(), 0.0));
  if (!arguments.ok()) return arguments;
  if (const int bad = first_not_finite(force); bad >= 0) return {Code::not_a_number, bad};
  GenericActuatedMotion motion;
  if (const Status status = motion.look(*equations_, state); !status.ok()) return status;
  std::vector<double> on_all(state.z.size(), 0.0);
  for (std::size_t i = 0; i < force.size(); ++i)
    for (std::size_t c = 0; c < on_all.size(); ++c) on_all[c] += motion.seen.direction[i][c] * force[i];
  tau.assign(on_all.size(), 0.0);
  const std::vector<int> free = free_coordinates(equations_->topology, equations_->analysis);
  for (std::size_t q = 0; q < free.size(); ++q) {
    std::vector<double> moved(on_all.size(), 0.0);
    equations_->algebra.add_rz_times(Eigen::VectorXd::Unit(motion.directions, static_cast<Eigen::Index>(q)), moved);
    for (std::size_t c = 0; c < on_all.size(); ++c) tau[static_cast<std::size_t>(free[q])] += moved[c] * on_all[c];
  }
  return {};
}

}  // namespace mbgen
