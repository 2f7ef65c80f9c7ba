#include "runtime/generic/by_recursion.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

#include "compiler/formulation/recursion/recursion.hpp"

namespace mbgen {
namespace {

/// The projection of each block at a state; an opened one keeps its partition. The closures are factorised with full
/// pivoting, whose smallest pivots notices look at. Fails: loop_singular.
Status chosen_projections(GenericEquations& equations, System<double>& system,
                          std::vector<BlockProjection<double>>& projections) {
  const std::vector<LoopBlock>& blocks = equations.topology.blocks;
  if (blocks.empty()) return {};
  const bool all_opened = std::all_of(blocks.begin(), blocks.end(), [](const LoopBlock& b) { return b.opened; });
  const Kinematics<double> k = kinematics(system);
  const Closures& closed =
      equations.closures_to_factorise(system, k, all_opened ? equations.rest : equations.motion_of_blocks(system, k));
  if (const Status status = equations.algebra.factorise(closed); !status.ok()) return status;
  std::vector<double> zdd_star;
  if (!all_opened) zdd_star = equations.starred_accelerations(system, GenericEquations::closure_accelerations(closed));
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    if (blocks[b].opened) {
      projections.emplace_back(equations.analysis.blocks[b].quasi);
      continue;
    }
    GroupProjection<double> projection{equations.algebra.rz_of(b), {}};
    for (const int j : blocks[b].joints) projection.zdd_star.push_back(zdd_star[j]);
    projections.emplace_back(std::move(projection));
  }
  return {};
}

/// Status of the inertias: no_inertia of the outermost direction without one, as the coordinate that moves most in it;
/// coordinates that move it have no number. The bodies of an opened block have inertia: only its equations can fail.
Status status_of(const Topology& topology, const std::vector<BlockProjection<double>>& projections,
                 const std::vector<DirectionInertia<double>>& directions) {
  for (auto it = directions.rbegin(); it != directions.rend(); ++it) {
    const DirectionInertia<double>& d = *it;
    if (d.value > 0) continue;
    if (d.block < 0) return {Code::no_inertia, d.place};
    if (topology.blocks[d.block].opened) return {Code::loop_singular, d.block};
    const auto& rz = std::get<GroupProjection<double>>(projections[d.block]).rz;
    const auto most = std::max_element(rz.begin(), rz.end(), [&](const auto& a, const auto& b) {
      return std::abs(a[d.place]) < std::abs(b[d.place]);
    });
    return {Code::no_inertia, topology.blocks[d.block].joints[most - rz.begin()]};
  }
  return {};
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
                        given.constants, given.annotator};
  const Kinematics<double> k = kinematics(system);
  const AppliedForces<double> forces = applied_forces(system, k, velocities(system, k, MotionPoint::body_origin));
  if (const Status status = check_holds(forces.hold); !status.ok()) return status;
  RecursiveSolution<double> solution =
      recursive_accelerations(system, *equations.recursion, k, forces, drives(system), tau, projections);
  if (const Status status = status_of(equations.topology, projections, solution.inertia); !status.ok()) return status;
  GenericDerivative result{std::move(solution.zdd), forces.xd};
  const Status status = check_finite(result);
  if (status.ok()) derivative = std::move(result);
  return status;
}

}  // namespace mbgen
