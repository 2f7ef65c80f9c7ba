#pragma once
// What a generic solver holds, and the formulation's view of one state.

#include <utility>

#include "compiler/formulation/formulation.hpp"
#include "runtime/generic/generic.hpp"
#include "runtime/generic/maggi.hpp"

namespace mbgen {

/// All that the formulation says about a state before the equations are solved.
struct Prepared {
  Kinematics<double> kinematics;
  Velocities<double> velocities;
  std::vector<BlockClosure<double>> closures;
};

/// A state with its true accelerations, and the forces that its constraints carry.
struct Solved {
  Prepared prepared;
  Inertias<double> inertias;
  AppliedForces<double> forces;
  Accelerations<double> accelerations;
  std::vector<std::vector<double>> multipliers;  ///< per block, per equation
  std::vector<double>
      unbalanced;  ///< tree forces less M zdd less Phi_z' lambda: what the drives must add, with opposite sign
};

struct GenericSolver::Content {
  Model model;
  Topology topology;
  Analysis analysis;
  Layout layout;
  mutable Scribe<double> scribe;
  std::vector<double> inputs, parameters;
  Environment<double> constants_environment;
  Constants<double> constants;

  Content(const Model& m, const Topology& t, const Analysis& a)
      : model(m), topology(t), analysis(a), layout(choose_layout(m, t)) {
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
  Status projections(const System<double>& system, const Prepared& p,
                     std::vector<GroupProjection<double>>& result) const {
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

  /// Factors for the multipliers of a block: of redundant equations the same ones are left out at every state, unless
  /// the others lose rank there.
  BlockFactors multiplier_factors(std::size_t b, const BlockClosure<double>& closed) const {
    std::vector<std::vector<double>> kept = closed.jacobian;
    for (int e : analysis.blocks[b].redundant_equations) std::fill(kept[e].begin(), kept[e].end(), 0.0);
    BlockFactors factors_of_kept(kept, analysis.blocks[b].driven, analysis.blocks[b].rank);
    return factors_of_kept.rank() < analysis.blocks[b].rank ? factors(b, closed) : factors_of_kept;
  }

  /// Multipliers by block, and what they leave of the residual forces (driving forces with opposite sign).
  std::vector<std::vector<double>> block_multipliers(const Prepared& p, std::vector<double>& residual) const {
    std::vector<std::vector<double>> lambda;
    for (std::size_t b = 0; b < topology.blocks.size(); ++b) {
      const std::vector<int>& joints = topology.blocks[b].joints;
      std::vector<double> right_hand_side;
      for (int j : joints) right_hand_side.push_back(residual[j]);
      lambda.push_back(multiplier_factors(b, p.closures[b]).multipliers(right_hand_side));
      for (std::size_t e = 0; e < lambda[b].size(); ++e)
        for (std::size_t c = 0; c < joints.size(); ++c)
          residual[joints[c]] -= p.closures[b].jacobian[e][c] * lambda[b][e];
    }
    return lambda;
  }

  Solved solved(System<double>& system, const std::vector<double>& tau, const std::vector<double>& zdd) const {
    Solved s;
    s.prepared = prepare(system);
    s.inertias = mbgen::inertias(system, s.prepared.kinematics);
    s.forces = applied_forces(system, s.prepared.kinematics, s.prepared.velocities);
    s.accelerations = mbgen::accelerations(system, s.prepared.kinematics, s.prepared.velocities, zdd);
    s.unbalanced =
        tree_forces(system, s.prepared.kinematics, s.inertias, s.prepared.velocities, s.accelerations, s.forces, tau);
    s.multipliers = block_multipliers(s.prepared, s.unbalanced);
    return s;
  }
};

}  // namespace mbgen
