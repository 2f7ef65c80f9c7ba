#pragma once
// The recursive form run at `double`, as programs have it traced: no compiler pass and no symbol takes part.

#include <vector>

#include "compiler/analysis/analysis.hpp"
#include "compiler/formulation/formulation.hpp"
#include "runtime/generic/generic.hpp"

namespace mbgen::test {

/// Accelerations of the recursive form and rates of the slips.
struct RecursiveRates {
  std::vector<double> zdd, xd;
};

/// Parameters and inputs at their defaults. chosen: per block, the projection over joint rates; empty: the frozen
/// partitions.
inline RecursiveRates recursion_at_double(const Model& model, const Topology& topology, const Analysis& analysis,
                                          const RecursionChoices& choices, const GenericState& state,
                                          const std::vector<double>& tau,
                                          const std::vector<GroupProjection<double>>& chosen = {}) {
  const Recursion recursion = plan_recursion(model, topology, analysis.driven, choices);
  Environment<double> environment;
  environment.topology = &topology;
  for (const Parameter& parameter : model.parameters) environment.parameters.push_back(parameter.value);
  for (const Input& input : model.inputs) environment.inputs.push_back(input.default_value);
  environment.t = state.t;
  environment.z = state.z;
  environment.zd = state.zd;
  Annotator<double> annotator;
  const Constants<double> constants = make_constants(model, topology, environment);
  System<double> system{model, topology, recursion.layout, environment, state.x, constants, annotator};
  const Kinematics<double> k = kinematics(system);
  const AppliedForces<double> forces = applied_forces(system, k, velocities(system, k, MotionPoint::body_origin));
  std::vector<BlockProjection<double>> projections;
  for (std::size_t b = 0; b < topology.blocks.size(); ++b) {
    if (chosen.empty())
      projections.emplace_back(analysis.blocks[b].quasi);
    else
      projections.emplace_back(chosen[b]);
  }
  return {recursive_accelerations(system, recursion, k, forces, drives(system), tau, projections).zdd, forces.xd};
}

}  // namespace mbgen::test
