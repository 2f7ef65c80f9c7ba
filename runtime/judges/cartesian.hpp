#pragma once
// Interface of the Cartesian judges: four formulations of the paper's first section for any model, on Eigen.

#include <array>
#include <memory>
#include <vector>

#include "compiler/model/model.hpp"
#include "compiler/topology/topology.hpp"
#include "mbgen/status.hpp"
#include "runtime/judges/method.hpp"
#include "runtime/state/state.hpp"

namespace mbgen {

/// Stabilisation of the integrated constraints.
enum class Stabilisation {
  projection,  ///< mass-orthogonal projections of position and velocity after each step
  baumgarte    ///< c - 2 alpha Phid - alpha^2 Phi instead of c
};

/// Solver of one model in Cartesian coordinates. Copies the data it needs from its arguments.
class CartesianSolver {
 public:
  CartesianSolver(const Model& model, const Topology& topology, CartesianMethod method, Stabilisation stabilisation);
  ~CartesianSolver();
  CartesianSolver(CartesianSolver&&) noexcept;

  /// Values of all inputs, model order; a step starts with them and extrapolates inputs with derivatives.
  void set_inputs(const std::vector<double>& inputs);
  void set_parameters(const std::vector<double>& tunable_parameters);

  /// Accelerations of the tree coordinates. tau: per coordinate. Fails: not_a_number; no_inertia if rank [M; Phi_q] < n
  /// (9), with the coordinate that moves most.
  Status accelerations(const GenericState& state, const std::vector<double>& tau, GenericDerivative& derivative) const;
  /// Mass-orthogonal projection of position, then velocity. Fails: loop_not_closed; the state is then unchanged.
  Status project(GenericState& state) const;
  /// One step of Runge-Kutta in Cartesian coordinates, stabilised. The bodies' own state continues if `state` is the
  /// result of the last step. The state is unchanged on failure.
  Status step(GenericState& state, double h);
  /// Multipliers in the order and scale of Topology::loops at a state.
  Status multipliers(const GenericState& state, const std::vector<double>& tau, std::vector<double>& lambda) const;
  /// Generalised driving force of each motion at a state, N or N m.
  Status driving_forces(const GenericState& state, const std::vector<double>& tau, std::vector<double>& drive) const;
  /// Forces of the actuators, with the least weighted sum of squares, for the accelerations of `independent` tree
  /// coordinates in `derivative`, whose zdd become all accelerations; the inputs of actuators do not act. Virtual work
  /// along all motions that the constraints leave to the bodies.
  /// Fails: as accelerations; actuators_singular where the actuators do not move every motion.
  Status inverse_dynamics(const GenericState& state, const std::vector<double>& tau,
                          const std::vector<int>& independent, GenericDerivative& derivative,
                          std::vector<double>& force) const;
  /// Per joint of the model, then per rod: force (N) and moment (N m) on its `to` body, about the joint's point on that
  /// body, global axes.
  Status reactions(const GenericState& state, const std::vector<double>& tau,
                   std::vector<std::array<double, 6>>& wrenches) const;
  /// All outputs of the model and the terms of its energy balance, from the accelerations of the bodies and the
  /// multipliers of these equations. The values are unchanged unless the status is ok.
  Status outputs(const GenericState& state, const std::vector<double>& tau, GenericOutputs& values) const;
  /// Sets the sampled values that are due at the start of a step of h seconds, or with h = 0 at the time of the state;
  /// any: whether there are such values. Fails: sample_inside_step, auxiliary_not_a_number, or as accelerations for
  /// values that are loads of reactions; the state is then unchanged.
  Status sample(GenericState& state, double h, bool& any) const;

  /// Sets the normal forces of frictions from reactions to those of the judge's own accelerations and multipliers at
  /// the state, which is unchanged on failure. Fails: as accelerations.
  Status set_friction_loads(GenericState& state) const;
  /// Largest residual of all constraints of the bodies' own state: position (m or 1) and velocity.
  Status residuals(const GenericState& state, double& position, double& velocity) const;

 private:
  struct Content;
  std::unique_ptr<Content> content_;
};

}  // namespace mbgen
