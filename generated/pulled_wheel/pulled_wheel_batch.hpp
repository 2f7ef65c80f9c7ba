// pulled_wheel, content hash b0d917ec774bd98f
// Made by `mbgen generate pulled_wheel.json`, mbgen 0.1.0. Change the model, not this file.
#pragma once

#include "pulled_wheel.hpp"

#include "mbgen/batch_status.hpp"

/// The solver for 4 independent instances in one call, in SIMD lanes: the interface of pulled_wheel.hpp with a row
/// of kLanes numbers in place of each number. A lane has the results of the scalar solver, bit for bit. A lane in
/// trouble is solved alone, and nothing that happens in it touches the others.
/// Every function is re-entrant, allocates nothing, does a bounded amount of work and leaves the results of
/// a lane untouched unless the status of the lane is ok.
namespace pulled_wheel::batch {

/// Instances of a call.
constexpr int kLanes = 4;

using Statuses = mbgen::LaneStatuses<kLanes>;

/// Tunable parameters with the values of the model.
struct alignas(32) Parameters {
  double k[kLanes] = {24000.0, 24000.0, 24000.0, 24000.0};  ///< N/m
  double ballast[kLanes] = {6.0, 6.0, 6.0, 6.0};  ///< kg
};

/// Inputs with their defaults, see pulled_wheel::Inputs.
struct alignas(32) Inputs {
};

/// Everything that changes in time. Start from `State state = initial_state();`.
struct alignas(32) State {
  double z[kCoordinates][kLanes];  ///< coordinates: rad or m, see kCoordinateUnits
  double zd[kCoordinates][kLanes];  ///< their velocities
  double x[2][kLanes];  ///< auxiliary states, see kAuxiliaryStateNames
  double t[kLanes];  ///< s
};

/// Generalised joint forces: N m or N.
struct alignas(32) JointForces {
  double tau[kCoordinates][kLanes];
};

/// Rates of a state that are not in the state itself.
struct alignas(32) Derivative {
  double zdd[kCoordinates][kLanes];  ///< accelerations
  double xd[2][kLanes];  ///< rates of the auxiliary states
};

/// Outputs of the model, and the terms of its energy balance.
struct alignas(32) Outputs {
  double load[kLanes];  ///< N
  double wheel_speed[kLanes];  ///< rad/s
  double hub_height[kLanes];  ///< m
  double spring_force[kLanes];  ///< N
  double kinetic_energy[kLanes];  ///< J
  double potential_energy[kLanes];  ///< J, of gravity
  double applied_power[kLanes];  ///< W, of all applied forces but gravity
};

/// Forces of the constraints.
struct alignas(32) Multipliers {
  double lambda[1][kLanes];  ///< of each closure equation, loop after loop
  double drive[1][kLanes];  ///< generalised driving force of each motion: N m or N
};

/// Rates of the last steps for step_abm4. Start with `History history{};`, and again when states or inputs were changed from
/// outside; `history.count[lane] = 0` starts one lane anew.
struct alignas(32) History {
  double zd[4][kCoordinates][kLanes];  ///< [0] at the state that the last step left, then backwards
  double zdd[4][kCoordinates][kLanes];
  double xd[4][2][kLanes];
  int count[kLanes];  ///< how many of them are known
  double h[kLanes];  ///< s, the step between them
  double t[kLanes];  ///< s, the time of [0]
};

/// One lane as the scalar solver has it, and back. Requires: 0 <= lane < kLanes.
pulled_wheel::Parameters lane_of(const Parameters& batch, int lane) noexcept;
pulled_wheel::Inputs lane_of(const Inputs& batch, int lane) noexcept;
pulled_wheel::State lane_of(const State& batch, int lane) noexcept;
pulled_wheel::Derivative lane_of(const Derivative& batch, int lane) noexcept;
pulled_wheel::Outputs lane_of(const Outputs& batch, int lane) noexcept;
pulled_wheel::Multipliers lane_of(const Multipliers& batch, int lane) noexcept;
void set_lane(Parameters& batch, int lane, const pulled_wheel::Parameters& one) noexcept;
void set_lane(Inputs& batch, int lane, const pulled_wheel::Inputs& one) noexcept;
void set_lane(State& batch, int lane, const pulled_wheel::State& one) noexcept;
void set_lane(Derivative& batch, int lane, const pulled_wheel::Derivative& one) noexcept;
void set_lane(Outputs& batch, int lane, const pulled_wheel::Outputs& one) noexcept;
void set_lane(Multipliers& batch, int lane, const pulled_wheel::Multipliers& one) noexcept;

/// As the functions of pulled_wheel.hpp, in every lane.
State initial_state() noexcept;
Statuses assemble(const Parameters& parameters, const Inputs& inputs, State& state) noexcept;
Statuses accelerations(const Parameters& parameters, const Inputs& inputs, const State& state,
                       const JointForces& forces, Derivative& derivative) noexcept;
Statuses step_rk4(const Parameters& parameters, const Inputs& inputs, State& state, double h) noexcept;
Statuses step_abm4(const Parameters& parameters, const Inputs& inputs, State& state, History& history,
                   double h) noexcept;
Statuses outputs(const Parameters& parameters, const Inputs& inputs, const State& state, const JointForces& forces,
                 const Derivative& derivative, Outputs& values) noexcept;
Statuses multipliers(const Parameters& parameters, const Inputs& inputs, const State& state,
                     const JointForces& forces, const Derivative& derivative, Multipliers& values) noexcept;

}  // namespace pulled_wheel::batch
