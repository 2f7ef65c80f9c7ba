#pragma once
// The equations of one model at double: its data, and the formulation's view of one state.

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "compiler/analysis/analysis.hpp"
#include "compiler/analysis/many_directions.hpp"
#include "compiler/formulation/formulation.hpp"
#include "compiler/formulation/recursion/recursion_units.hpp"
#include "runtime/generic/block_factors.hpp"
#include "runtime/generic/loop_algebra.hpp"
#include "runtime/generic/maggi.hpp"
#include "runtime/state/state.hpp"

namespace mbgen {

/// All that the formulation says about a state before the equations are solved.
struct Prepared {
  Kinematics<double> kinematics;
  Velocities<double> velocities;
  Closures closures;
};

/// A state with its true accelerations, and the forces that its constraints carry.
struct Solved {
  Prepared prepared;
  Inertias<double> inertias;
  AppliedForces<double> forces;
  Accelerations<double> accelerations;
  std::vector<std::vector<double>> multipliers;  ///< per block, per equation
  std::vector<double> unbalanced;  ///< tree forces less M zdd less Phi_z' lambda: driving forces, with opposite sign
};

/// A row of a block's Jacobian times values of all coordinates.
inline double product(const SparseRow<double>& row, const std::vector<int>& joints, const std::vector<double>& values) {
  double sum = 0;
  for (std::size_t i = 0; i < row.columns.size(); ++i) sum += row.values[i] * values[joints[row.columns[i]]];
  return sum;
}

struct GenericEquations {
  Model model;
  Topology topology;
  Analysis analysis;
  Layout layout;
  Annotator<double> annotator;
  System<double> at;  ///< the state in hand; inputs and parameters stay from state to state
  const RelativeMotion<double> rest;
  RelativeMotion<double> relative;  ///< bodies of all blocks, each to the base of its block
  const ModelClosures places;
  Closures at_hand;  ///< as factorised last
  LoopAlgebra algebra;
  TreeMass mass;  ///< empty until it is asked for
  ReducedEquations reduced;
  Eigen::VectorXd free;                ///< accelerations of the free directions
  bool recursive = false;              ///< accelerations are those of the recursive form
  std::optional<Recursion> recursion;  ///< its plan, once it was asked for
  std::vector<double> magnitudes;      ///< of the auxiliary states in a search for rest: magnitude_of of the user's own

  GenericEquations(const Model& m, const Topology& t, const Analysis& a, const GenericAlgebra& choice)
      : model(m),
        topology(t),
        analysis(a),
        layout(choose_layout(m, t)),
        at{model, topology, layout, {}, {}, {}, annotator},
        rest(at_rest<double>(topology)),
        relative(rest),
        places(topology),
        algebra(make_loop_algebra(choice, model, topology, analysis)),
        recursive(algebra.rz_of && has_many_directions(free_coordinates(topology, analysis).size(),
                                                       least_operations(topology, analysis).recursive)) {
    // Deflections of tyres and rubber count there as coordinates do, in m and rad.
    for (const AuxiliaryState& state : auxiliary_states(model)) magnitudes.push_back(magnitude_of(state));
    std::fill_n(magnitudes.begin(), first_user_state(model), 1.0);
    at.environment.topology = &topology;
    for (const Input& input : model.inputs) at.environment.inputs.push_back(input.default_value);
    for (const Parameter& parameter : model.parameters) at.environment.parameters.push_back(parameter.value);
    refresh();
  }

  /// Computes the constants anew.
  void refresh() {
    at.environment.z.assign(topology.bodies.size(), 0.0);
    at.environment.zd = at.environment.z;
    at.constants = make_constants(model, topology, at.environment);
  }

  /// Names arguments of a call that are not finite.
  Status check_arguments(const GenericState& state, const std::vector<double>& tau) const {
    const Status status = check_finite(state, tau, at.environment.inputs);
    if (!status.ok()) return status;
    int tunable = 0;
    for (std::size_t p = 0; p < model.parameters.size(); ++p) {
      if (!model.parameters[p].tunable) continue;
      if (!std::isfinite(at.environment.parameters[p])) return {Code::parameter_not_a_number, tunable};
      ++tunable;
    }
    return {};
  }

  /// Puts driven coordinates and their velocities where their motions are. Fails: not_a_number.
  static Status follow_motions(System<double>& system, GenericState& state) {
    for (const Drive<double>& d : drives(system)) {
      if (!std::isfinite(d.position + d.velocity)) return {Code::not_a_number, d.coordinate};
      state.z[d.coordinate] = system.environment.z[d.coordinate] = d.position;
      state.zd[d.coordinate] = system.environment.zd[d.coordinate] = d.velocity;
    }
    return {};
  }

  System<double>& system(const GenericState& state) {
    at.environment.t = state.t;
    at.environment.z = state.z;
    at.environment.zd = state.zd;
    at.environment.charts = state.charts;
    count_as_the_model(model, at.environment);
    at.x = state.x;
    return at;
  }

  int columns(std::size_t b) const { return static_cast<int>(topology.blocks[b].joints.size()); }

  /// Residuals and Jacobians of all blocks.
  Closures closures(System<double>& system, const Kinematics<double>& k) const {
    Closures result;
    places.evaluate(system, k, rest, result);
    return result;
  }

  /// The same for factorisations: rows of velocities alone are zero where they repeat others here, so that none of them
  /// takes the pivot of a row of positions. Result: the closures at hand, until the next call.
  const Closures& closures_to_factorise(System<double>& system, const Kinematics<double>& k,
                                        const RelativeMotion<double>& motion) {
    places.evaluate(system, k, motion, at_hand);
    for (std::size_t b = 0; b < at_hand.size(); ++b)
      drop_repeating_rows(analysis.blocks[b], at_hand[b].jacobian, columns(b));
    return at_hand;
  }

  /// Motion of the bodies of all blocks, each to the base of its block.
  const RelativeMotion<double>& motion_of_blocks(System<double>& system, const Kinematics<double>& k) {
    for (const LoopBlock& block : topology.blocks) set_relative_motion(system, k, block, relative);
    return relative;
  }

  /// c of Phi_z zdd = c of closures that were evaluated with motion_of_blocks.
  static PerBlock closure_accelerations(const Closures& closures) {
    PerBlock result;
    for (const SparseClosure<double>& closed : closures) result.push_back(closed.acceleration);
    return result;
  }

  Prepared prepare(System<double>& system) const {
    Prepared p;
    p.kinematics = kinematics(system);
    p.velocities = velocities(system, p.kinematics);
    p.closures = closures(system, p.kinematics);
    return p;
  }

  /// zdd under zero free accelerations: driven ones prescribed, dependent ones from c and the factors at hand.
  std::vector<double> starred_accelerations(const System<double>& system, const PerBlock& c) const {
    std::vector<double> zdd_star(topology.bodies.size(), 0.0);
    for (const Drive<double>& d : drives(system)) zdd_star[d.coordinate] = d.acceleration;
    algebra.solve(c, zdd_star);
    return zdd_star;
  }

  /// The coordinate that moves most in a free direction.
  int coordinate_of(int direction) const {
    std::vector<double> moved(topology.bodies.size(), 0.0);
    algebra.add_rz_times(Eigen::VectorXd::Unit(reduced.mass.rows(), direction), moved);
    Eigen::Index most = 0;
    Eigen::Map<const Eigen::VectorXd>(moved.data(), topology.size()).cwiseAbs().maxCoeff(&most);
    return static_cast<int>(most);
  }

  /// Factors of a block by full pivoting, driven columns never dependent.
  BlockFactors factors(std::size_t b, const SparseClosure<double>& closed) const {
    return BlockFactors(closed.jacobian, columns(b), analysis.blocks[b].driven, analysis.blocks[b].rank);
  }

  /// Factors for the multipliers of a block: of redundant equations the same ones are left out at every state, unless
  /// the others lose rank there.
  BlockFactors multiplier_factors(std::size_t b, const SparseClosure<double>& closed) const {
    SparseRows kept = closed.jacobian;
    for (int e : analysis.blocks[b].redundant_equations) kept[e] = {};
    BlockFactors factors_of_kept(kept, columns(b), analysis.blocks[b].driven, analysis.blocks[b].rank);
    return factors_of_kept.rank() < analysis.blocks[b].rank ? factors(b, closed) : factors_of_kept;
  }

  /// Multipliers by block, and the rest of the residual forces (driving forces with opposite sign).
  std::vector<std::vector<double>> block_multipliers(const Prepared& p, std::vector<double>& residual) const {
    std::vector<std::vector<double>> lambda;
    for (std::size_t b = 0; b < topology.blocks.size(); ++b) {
      const std::vector<int>& joints = topology.blocks[b].joints;
      std::vector<double> right_hand_side;
      for (int j : joints) right_hand_side.push_back(residual[j]);
      lambda.push_back(multiplier_factors(b, p.closures[b]).multipliers(right_hand_side));
      for (std::size_t e = 0; e < lambda[b].size(); ++e) {
        const SparseRow<double>& row = p.closures[b].jacobian[e];
        for (std::size_t i = 0; i < row.columns.size(); ++i)
          residual[joints[row.columns[i]]] -= row.values[i] * lambda[b][e];
      }
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

  /// Generalised driving force of each motion.
  std::vector<double> driving_forces(const System<double>& system, const Solved& solved) const {
    std::vector<double> force;
    for (const Drive<double>& d : drives(system)) force.push_back(-solved.unbalanced[d.coordinate]);
    return force;
  }
};

}  // namespace mbgen
