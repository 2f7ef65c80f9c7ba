#include "runtime/generic/by_recursion.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

#include "compiler/formulation/recursion/recursion.hpp"

namespace mbgen {
namespace {

/// The projection of each block at a state; an opened one keeps its partition. Fails: loop_singular.
Status chosen_projections(GenericEquations& equations, System<double>& system,
                          std::vector<BlockProjection<double>>& projections) {
  if (equations.topology.blocks.empty()) return {};
  const Kinematics<double> k = kinematics(system);
  const Closures& closed = equations.closures_to_factorise(system, k, equations.motion_of_blocks(system, k));
  if (const Status status = equations.algebra.factorise(closed); !status.ok()) return status;
  const std::vector<double> zdd_star =
      equations.starred_accelerations(system, GenericEquations::closure_accelerations(closed));
  for (std::size_t b = 0; b < equations.topology.blocks.size(); ++b) {
    if (equations.topology.blocks[b].opened) {
      projections.emplace_back(equations.analysis.blocks[b].quasi);
      continue;
    }
    GroupProjection<double> projection{equations.algebra.rz_of(b), {}};
    for (const int j : equations.topology.blocks[b].joints) projection.zdd_star.push_back(zdd_star[j]);
    projections.emplace_back(std::move(projection));
  }
  return {};
}

/// The outermost direction without inertia, as the coordinate that moves most in it; -1: all have some. Coordinates
/// that move it have no number.
int coordinate_without_inertia(const Topology& topology, const std::vector<BlockProjection<double>>& projections,
                               const std::vector<DirectionInertia<double>>& directions) {
  for (auto it = directions.rbegin(); it != directions.rend(); ++it) {
    const DirectionInertia<double>& d = *it;
    if (d.value > 0) continue;
    if (d.block < 0) return d.place;
    if (const LoopPartition* opened = std::get_if<LoopPartition>(&projections[d.block]))
      return topology.blocks[d.block].joints[opened->independent[d.place]];
    const auto& rz = std::get<GroupProjection<double>>(projections[d.block]).rz;
    const auto most = std::max_element(rz.begin(), rz.end(), [&](const auto& a, const auto& b) {
      return std::abs(a[d.place]) < std::abs(b[d.place]);
    });
    return topology.blocks[d.block].joints[most - rz.begin()];
  }
  return -1;
}

}  // namespace

Status accelerations_by_recursion(GenericEquations& equations, const GenericState& state,
                                  const std::vector<double>& tau, GenericDerivative& derivative) {
  System<double>& given = equations.system(state);
  std::vector<BlockProjection<double>> projections;
  if (const Status status = chosen_projections(equations, given, projections); !status.ok()) return status;
  if (!equations.recursion)
    equations.recursion = plan_recursion(equations.model, equations.topology, equations.analysis.driven);
  System<double> system{given.model,     given.topology, equations.recursion->layout, given.environment, given.x,
                        given.constants, given.scribe};
  const Kinematics<double> k = kinematics(system);
  const AppliedForces<double> forces = applied_forces(system, k, velocities(system, k, MotionPoint::body_origin));
  RecursiveSolution<double> solution =
      recursive_accelerations(system, *equations.recursion, k, forces, drives(system), tau, projections);
  if (const int i = coordinate_without_inertia(equations.topology, projections, solution.inertia); i >= 0)
    return {Code::no_inertia, i};
  GenericDerivative result{std::move(solution.zdd), forces.xd};
  const Status status = check_finite(result);
  if (status.ok()) derivative = std::move(result);
  return status;
}

}  // namespace mbgen
