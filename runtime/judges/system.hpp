#pragma once
// The mechanism in Cartesian coordinates: six per body, every joint a constraint (theory.md section 6). Slow but
// obviously correct: it shares no kinematics with the recursive formulation, which it judges.

#include <Eigen/Dense>
#include <memory>
#include <vector>

#include "compiler/model/model.hpp"
#include "compiler/topology/topology.hpp"
#include "runtime/judges/bodies.hpp"
#include "runtime/state/state.hpp"

namespace mbgen {

/// Index-1 terms at one state, n = 6 per body, m equations: M qdd + Phi_q' lambda = F, Phi_q qdd = c (5). qdd contains,
/// body after body, the acceleration of the centre of mass and the angular acceleration, global axes. Equations in
/// order: the joints of the model, tree and cut alike; the rods; the motions. A massive rod has a spherical joint at
/// each end, from and to, and one more equation: no spin about its axis (nonholonomic, residual zero).
struct CartesianTerms {
  Eigen::MatrixXd mass;      ///< M, n x n, positive semidefinite: zero for massless bodies
  Eigen::VectorXd force;     ///< F, n: applied and gyroscopic
  Eigen::MatrixXd jacobian;  ///< Phi_q, m x n, rows scaled to m or 1
  Eigen::VectorXd residual;  ///< Phi, m
  Eigen::VectorXd velocity;  ///< Phi_q qd - b, m: violation of (3) by the velocities
  Eigen::VectorXd bias;      ///< c of (4), m
  std::vector<double> xd;    ///< rates of the auxiliary states
  std::vector<int> late;     ///< nonholonomic equations
  std::vector<double> hold;  ///< per place of hold_names, negative or NaN where the element does not hold
};

/// A force and a moment about a named point, global axes.
struct CartesianWrench {
  Eigen::Vector3d force, moment;  ///< N, N m
};

struct CartesianMechanism;

class CartesianSystem {
 public:
  CartesianSystem(const Model& model, const Topology& topology);
  ~CartesianSystem();
  CartesianSystem(CartesianSystem&&) noexcept;

  const Model& model() const;
  int coordinates() const;  ///< n
  int equations() const;    ///< m
  /// Index into Topology::loops of an equation's closure, -1 for joints of the tree and motions.
  int loop_of(int equation) const;

  /// Values in model order (all inputs; tunable parameters only).
  void set_inputs(const std::vector<double>& inputs);
  void set_parameters(const std::vector<double>& tunable_parameters);

  /// Bodies placed along the tree by its coordinates; loops may be open. Massive rods lie along their end points.
  CartesianState place(const GenericState& state) const;
  /// Tree coordinates and rates from the bodies' relative poses; angles are the nearest to `guess`.
  GenericState joint_state(const CartesianState& state, const GenericState& guess) const;
  /// Tree accelerations from the accelerations of the bodies. z: the coordinates at this state.
  std::vector<double> joint_accelerations(const CartesianState& state, const GenericState& z,
                                          const Eigen::VectorXd& qdd) const;
  /// All terms of (5). tau: per tree coordinate, added to the model's joint forces.
  CartesianTerms terms(const CartesianState& state, const GenericState& z, const std::vector<double>& tau) const;
  /// Whether sampled values are loads of reactions or look at outputs over accelerations.
  bool takes_reactions() const;
  /// Sets the sampled values whose instant is at the start of a step of h seconds, or with h = 0 at the time of the
  /// state; any: whether there are such values. z: the coordinates at this state. qdd, lambda: the accelerations and
  /// multipliers there where takes_reactions. Fails: sample_inside_step, auxiliary_not_a_number; the state is then
  /// unchanged.
  Status sample(CartesianState& state, const GenericState& z, const Eigen::VectorXd& qdd, const Eigen::VectorXd& lambda,
                double h, bool& any) const;
  /// Sets the values that are loads of reactions in z, which has the coordinates at this state. lambda: as in sample.
  void set_friction_loads(const CartesianState& state, const Eigen::VectorXd& lambda, GenericState& z) const;
  /// Moves the bodies by a small displacement (m, rad), n values; velocities are unchanged.
  void displace(CartesianState& state, const Eigen::VectorXd& dq) const;
  /// Velocities of all bodies as n values, and back.
  Eigen::VectorXd velocities(const CartesianState& state) const;
  void set_velocities(CartesianState& state, const Eigen::VectorXd& qd) const;

  /// Multipliers of the closures of Topology::loops, in their order and scale, from the multipliers of all equations.
  std::vector<double> loop_multipliers(const CartesianState& state, const Eigen::VectorXd& lambda) const;
  /// Generalised driving force of each motion, from the multipliers of all equations.
  std::vector<double> driving_forces(const Eigen::VectorXd& lambda) const;
  /// Action of each joint of the model (constraint, springs, drives and tau of its coordinates) from its `from` to
  /// its `to` body, about the joint's point on `to`.
  std::vector<CartesianWrench> joint_reactions(const CartesianState& state, const GenericState& z,
                                               const std::vector<double>& tau, const Eigen::VectorXd& lambda) const;
  /// Force of each rod on the body at an end, N, global axes.
  std::vector<Eigen::Vector3d> rod_forces(const CartesianState& state, const Eigen::VectorXd& lambda,
                                          ReactionOutput::End end) const;

  /// Values of the model's outputs and the terms of its energy balance. qdd: accelerations of all bodies; lambda: the
  /// multipliers of all equations.
  GenericOutputs outputs(const CartesianState& state, const GenericState& z, const std::vector<double>& tau,
                         const Eigen::VectorXd& qdd, const Eigen::VectorXd& lambda) const;

 private:
  /// Values of Model::observed. Arguments as in `outputs`.
  std::vector<double> observed(const CartesianState& state, const GenericState& z, const Eigen::VectorXd& qdd,
                               const Eigen::VectorXd& lambda) const;
  /// Per sampled value the magnitude of its reaction, N or N m; zero for a value that is none.
  std::vector<double> reaction_loads(const CartesianState& state, const GenericState& z,
                                     const Eigen::VectorXd& lambda) const;

  std::unique_ptr<CartesianMechanism> mechanism_;
};

}  // namespace mbgen
