#pragma once
// The generic runtime: double-step Maggi for any model without generating code, theory.md sections 1 to 5 on Eigen.

#include <array>
#include <memory>
#include <vector>

#include "compiler/analysis/analysis.hpp"
#include "compiler/model/model.hpp"
#include "compiler/topology/topology.hpp"
#include "mbgen/solver/step_clock.hpp"
#include "mbgen/status.hpp"
#include "runtime/generic/algebra_choice.hpp"
#include "runtime/state/state.hpp"

namespace mbgen {

struct WayLimits;  // mbgen/solver/singular_step.hpp

/// A value that is asked of a coordinate or its velocity.
struct CoordinateTarget {
  int coordinate = -1;
  double value = 0;     ///< rad or m, or per second
  double weight = 1;    ///< of its squared error, against the weights of the other targets
  bool locked = false;  ///< to be met exactly; of driven coordinates the motion says where they are
};

/// The road below a place.
struct RoadBelow {
  double height = 0;    ///< m, global z
  double friction = 1;  ///< factor of the tyre's friction
};

struct GenericEquations;
struct GenericActuatedMotion;
template <class T>
struct ImplicitEquations;

/// Equations of an implicit step; null where the frozen partition does not serve, see mbgen/implicit.hpp.
struct GenericTangents {
  std::shared_ptr<const ImplicitEquations<double>> equations;
};

/// Solver of one model at double. Copies the data that it needs of its arguments. It works in memory of its own: one
/// thread at a time, and any number of solvers in as many threads. With LinearAlgebra::blas one thread of the whole
/// process: Debian's serial OpenBLAS shares buffers without a lock.
class GenericSolver {
 public:
  /// algebra: of the closures and the reduced equations; see make_loop_algebra.
  GenericSolver(const Model& model, const Topology& topology, const Analysis& analysis,
                const GenericAlgebra& algebra = {});
  ~GenericSolver();
  GenericSolver(GenericSolver&&) noexcept;

  /// inputs, parameters: values in model order (all inputs; tunable parameters only).
  void set_inputs(const std::vector<double>& inputs);
  void set_parameters(const std::vector<double>& tunable_parameters);

  /// All accelerations at a state (60)-(63). tau: per coordinate. clock, where given, is told the end of each of the
  /// nine steps. Fails: not_a_number, loop_singular, no_inertia.
  Status accelerations(const GenericState& state, const std::vector<double>& tau, GenericDerivative& derivative,
                       StepClock* clock = nullptr) const;
  /// Newton on the dependent coordinates, then consistent velocities; driven coordinates are set from their motions.
  /// Fails: loop_not_closed, loop_singular; the state is then unchanged.
  Status project(GenericState& state) const;
  /// Accelerations without joint forces, projection, and projection by the shortest corrections, as integrators ask for
  /// them: notices say how near a singular position is. Projections from a state that is not near fail with
  /// loop_not_closed, see mbgen/motion.hpp. project_crossing closes a state at a singular position.
  Status solve_motion(const GenericState& state, GenericDerivative& derivative) const;
  Status project_motion(GenericState& state) const;
  Status project_nearest(GenericState& state) const;
  Status project_crossing(GenericState& state, double& clearance) const;
  /// Loop block that is on another side of a singular position at `to` than at `from`, or -1.
  int changed_side(const GenericState& from, const GenericState& to) const;
  /// The way of the loops in a step of h seconds, see watch_way of mbgen/motion.hpp.
  Status watch_way(const GenericState& from, const GenericState& to, double h, const WayLimits& limits) const;
  /// Equations of an implicit step at a state, and the changes of velocities and auxiliary states that solve them for
  /// given rates. g: s, the method's factor times the step. The status may be a notice.
  /// Fails: not_a_number, implicit_singular, implicit_state_grows.
  Status tangents(const GenericState& state, double g, GenericTangents& tangents) const;
  GenericDerivative changes(const GenericTangents& tangents, double g, const std::vector<double>& zd,
                            const GenericDerivative& rates) const;
  /// Lagrange multipliers in the order of Topology::loops, given accelerations.
  std::vector<double> multipliers(const GenericState& state, const std::vector<double>& tau,
                                  const GenericDerivative& derivative) const;
  /// Generalised driving force of each motion, given accelerations: N or N m, along its coordinate.
  std::vector<double> driving_forces(const GenericState& state, const std::vector<double>& tau,
                                     const GenericDerivative& derivative) const;
  /// Forces of the actuators for the accelerations of the independent coordinates in `derivative`, whose zdd become all
  /// accelerations. Requires: has_inverse_dynamics, a consistent state. Fails: not_a_number, loop_singular,
  /// actuators_singular; derivative and force are then unchanged.
  Status inverse_dynamics(const GenericState& state, const std::vector<double>& tau, GenericDerivative& derivative,
                          std::vector<double>& force) const;
  /// The maps between motors and joints of mbgen/actuated.hpp, with its failures. Requires: has_inverse_dynamics
  /// without motions that actuators give; as many values as actuators, or coordinates. jacobian: coordinates x
  /// actuators.
  Status complete_joints(const std::vector<double>& position, const std::vector<double>& speed,
                         GenericState& state) const;
  Status actuator_positions(const GenericState& state, std::vector<double>& position, std::vector<double>& speed) const;
  Status complete_accelerations(const GenericState& state, const std::vector<double>& acceleration,
                                std::vector<double>& zdd) const;
  Status actuator_jacobian(const GenericState& state, std::vector<double>& jacobian) const;
  Status forces_at_actuators(const GenericState& state, const std::vector<double>& tau,
                             std::vector<double>& force) const;
  Status forces_at_independent(const GenericState& state, const std::vector<double>& force,
                               std::vector<double>& tau) const;
  /// Side of the singular positions of the actuators on which a state is, 1 or -1; 0 of more actuators than directions.
  /// Requires: has_inverse_dynamics.
  int side_of_actuators(const GenericState& state) const;
  /// Closure residuals in the order of Topology::loops (positions), and Phi_z zd (velocities).
  std::vector<double> position_residuals(const GenericState& state) const;
  std::vector<double> velocity_residuals(const GenericState& state) const;
  /// Pose of every body of the model in the global frame, fixed ones and ground too: of its frame as the model gives
  /// it.
  std::vector<Pose> poses(const GenericState& state) const;
  /// The road of a tyre (index into Model::tyres) below places of the global x and y, m, at the time of a state.
  std::vector<RoadBelow> road_below(const GenericState& state, std::size_t tyre,
                                    const std::vector<std::array<double, 2>>& places) const;
  GenericOutputs outputs(const GenericState& state, const std::vector<double>& tau,
                         const GenericDerivative& derivative) const;
  /// The exchanges of energy at a consistent state: powers of each force element by what it does at rest in this
  /// position, then by the rest (spring and damper of one element do not cancel), then of gravity on each body; kinetic
  /// energy of each body by translation and about each axis. Not finite where the state is not. Cost: linear.
  GenericExchanges exchanges(const GenericState& state) const;
  /// Moves a closed state at rest to the closed positions whose targeted coordinates are nearest to their values: the
  /// least weighted sum of squares, locked and driven ones exact, the others as near to where they were as steps along
  /// the closures lead. Fails: not_a_number; loop_not_closed, `state` is then at the least open positions that were
  /// found, locked and driven coordinates in place.
  Status assemble(GenericState& state, const std::vector<CoordinateTarget>& positions) const;
  /// The same for velocities, at the positions of `state`: the least that meet the targets.
  Status assemble_velocities(GenericState& state, const std::vector<CoordinateTarget>& velocities) const;
  /// Sets the sampled values whose instant is at the start of a step of h seconds; any: whether there are such values.
  /// Fails: not_a_number, sample_inside_step; the state is then unchanged.
  Status sample(GenericState& state, double h, bool& any) const;
  /// Sets the loads of frictions to the reactions at the state, as they are under the loads before.
  /// Fails: as accelerations, auxiliary_not_a_number; the state is then unchanged.
  Status set_friction_loads(GenericState& state) const;
  /// Static equilibrium, driven coordinates at their motions: at rest, closed, generalised forces of the free
  /// directions zero (least change of position where they are indifferent). First that to which the bodies sink, else
  /// one nearby from which they would fall. Where there is none `state` is the last that was tried.
  Status equilibrium(GenericState& state) const;

 private:
  /// Everything at a state. Fails: not_a_number, loop_singular, actuators_singular.
  Status look_at_actuators(const GenericState& state, GenericActuatedMotion& motion) const;
  /// How near a singular position the blocks are. Fails: loop_singular.
  Status notice(const GenericState& state) const;
  /// The same from the factors at hand, where they tell it. Requires: they are those of the state.
  Status notice_of_factors(const GenericState& state) const;
  /// The reactions that sampled values take, see reaction_loads; sets everything that their expressions look at. Fails:
  /// as accelerations.
  Status take_loads(const GenericState& state, std::vector<double>& loads) const;
  /// Takes over a projected state unless it is a jump. is_factorised: the factors at hand are its. Gives notices.
  Status without_jump(const GenericState& closed, GenericState& state, bool is_factorised) const;

  std::unique_ptr<GenericEquations> equations_;
};

}  // namespace mbgen
