#pragma once
// Names of numbers that programs take and give: an array and a place in it.

#include <cstdint>
#include <string>

namespace mbgen {

/// The arrays, in the order of their names; solver/programs.hpp tells which program takes and gives which.
enum class Array : std::uint8_t {
  Jz,                   ///< Jacobian of a loop block, row by row
  Phi,                  ///< residuals of a block
  Rz,                   ///< projection of a block, row by row
  actuation,            ///< pivots of the actuators over their references, one a free direction
  c,                    ///< right-hand side of a block's accelerations: Phi_z zdd = c
  charts,               ///< of balls, 0 or 1: mbgen/charts.hpp
  derived,              ///< constants that follow from tunable parameters
  direction,            ///< of the tree's forces for a unit force of each actuator, row by row
  drift,                ///< acceleration of each actuator's motor where no coordinate accelerates
  drive,                ///< generalised driving force of a motion
  driven_acceleration,  ///< of driven coordinates, by their motions
  due,                  ///< of sampled values, 1 where its instant is now, else 0
  dz,                   ///< Newton correction of the positions
  energy,               ///< kinetic, potential
  force,                ///< of actuators
  held,                 ///< auxiliary states that hold between instants
  hold,                 ///< of places of elements: negative, or NaN, where one does not hold
  in,                   ///< inputs of the model
  inertia,              ///< pivots of the final equations, one a free direction
  lambda,               ///< multipliers
  law_argument,         ///< of a law that elements share, see SharedLaw; its index takes the place of a block's
  law_result,           ///< likewise
  missing,              ///< forces of a block that its multipliers and drives provide
  par,                  ///< tunable parameters
  pivot,                ///< smallest pivot of each block over its reference
  place,                ///< of wheels on ground of a host: x and y of each
  position,             ///< of each actuator's motor
  power,                ///< of the applied forces
  rate,                 ///< Phi_z zd of a block
  required,             ///< forces of the tree that accelerations need, per coordinate
  residual,             ///< of all closure equations, then of the motions
  seed,                 ///< entries of a direction, see differentiate
  slope,                ///< of values by others, see take_derivatives_apart
  step,                 ///< of the implicit equations, the method's factor times the step, s
  state_pivot,          ///< of the equations of an implicit step, one a state of the user's own
  t,                    ///< time
  tangent,              ///< of the implicit equations, one after another; see formulation/implicit/implicit.hpp
  tau,                  ///< joint forces
  x,                    ///< auxiliary states
  xd,                   ///< their rates
  y,                    ///< outputs of the model
  z,                    ///< coordinates
  zd,                   ///< velocities
  zdd,                  ///< accelerations
  zdd_star              ///< accelerations of a block at zero independent ones
};

const char* name_of(Array array);

/// An array, of one loop block where each has its own, or its derivative along a direction.
struct SlotGroup {
  constexpr SlotGroup(Array array, int block = -1, int derivative = 0)
      : array(array), block(block), derivative(derivative) {}
  Array array;
  int block;       ///< index of the loop block, -1 for an array of the whole solver
  int derivative;  ///< how often differentiated
  auto operator<=>(const SlotGroup&) const = default;
};

/// The array of one loop block.
constexpr SlotGroup of_block(Array array, std::size_t block) { return {array, static_cast<int>(block)}; }

/// The derivative of an array along a direction.
constexpr SlotGroup derivative_of(SlotGroup group) { return {group.array, group.block, group.derivative + 1}; }

/// "zdd", "Rz3", "d_zdd".
std::string text_of(const SlotGroup& group);

/// An input or output of a program.
struct Slot {
  SlotGroup group = Array::t;
  int index = 0;
  auto operator<=>(const Slot&) const = default;
};

/// "Rz3[7]".
std::string text_of(const Slot& slot);

}  // namespace mbgen
