#include <algorithm>

#include "mbgen/actuation.hpp"
#include "runtime/generic/actuated.hpp"
#include "runtime/generic/equations.hpp"
#include "runtime/generic/generic.hpp"

namespace mbgen {

Status GenericSolver::inverse_dynamics(const GenericState& state, const std::vector<double>& tau,
                                       GenericDerivative& derivative, std::vector<double>& force) const {
  GenericEquations& equations = *equations_;
  if (const Status status = equations.check_arguments(state, tau); !status.ok()) return status;
  if (const int bad = first_not_finite(derivative.zdd); bad >= 0) return {Code::not_a_number, bad};
  const Analysis& analysis = equations.analysis;
  InverseDynamics<double> inverse =
      mbgen::inverse_dynamics(equations.system(state), analysis.directions, analysis.actuation, derivative.zdd, tau);
  for (std::size_t b = 0; b < inverse.quality.size(); ++b)
    if (!(inverse.quality[b] >= kPivotThreshold<double>)) return {Code::loop_singular, static_cast<int>(b)};
  const auto hardly_moved =
      std::ranges::find_if(inverse.clearance, [](double clearance) { return !(clearance >= kLeastActuation<double>); });
  if (hardly_moved != inverse.clearance.end()) {
    const std::size_t free = free_coordinates(equations.topology, analysis).size();
    if (inverse.force.size() == inverse.clearance.size() || free != inverse.clearance.size())
      return {Code::actuators_singular, static_cast<int>(hardly_moved - inverse.clearance.begin())};
    // Others of the actuators may move it.
    GenericActuatedMotion motion;
    if (const Status status = look_at_actuators(state, motion); !status.ok()) return status;
    inverse.force = motion.forces_for(required_forces(equations.system(state), inverse.zdd, tau));
  }
  if (const int bad = first_not_finite(inverse.zdd); bad >= 0) return {Code::not_a_number, bad};
  if (first_not_finite(inverse.force) >= 0) return {Code::not_a_number, -1};
  derivative.zdd = std::move(inverse.zdd);
  force = std::move(inverse.force);
  return {};
}

int GenericSolver::side_of_actuators(const GenericState& state) const {
  const Analysis& analysis = equations_->analysis;
  if (!analysis.actuation.independent.empty()) return 0;
  return mbgen::side_of_actuators(equations_->system(state), analysis.directions, analysis.actuation);
}

}  // namespace mbgen
