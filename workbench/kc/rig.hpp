#pragma once
// The rig of an axle: the user's model with its body fixed and its wheels on pads, as a separate model.

#include <array>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "compiler/compile.hpp"
#include "runtime/generic/generic.hpp"

namespace mbgen::kc {

/// Inputs of a rig, in this order: travels of both wheel centres (m, up), steering (rad or m, from the start), then for
/// each wheel the force along x and y (N) at the centre of the wheel and the torque about x, y and z (N m) on the wheel
/// body, global axes.
enum RigInput {
  kTravelLeft,
  kTravelRight,
  kSteer,
  kLoadsLeft,
  kLoadsRight = kLoadsLeft + 5,
  kRigInputs = kLoadsRight + 5
};
constexpr int kLoads = 5;
using RigInputs = std::array<double, kRigInputs>;

/// Places of a wheel's values among the outputs of the rig's model, the first of three or one; -1: none.
struct RigWheel {
  int centre = -1;             ///< m, position
  int axis = -1;               ///< spin axis, unit
  int rim = -1;                ///< unit vector that turns with the wheel body, across the axis
  int lower = -1, upper = -1;  ///< m, points of the steering axis
  int load = -1;               ///< N, force of the pad, up
  double side = 1;             ///< 1 left, -1 right
  double radius = 0;           ///< m
};

/// A spring, damper or stop of the model whose deflection follows the wheels.
struct RigElement {
  std::string name;
  std::string unit;            ///< of its deflection
  int output = -1, less = -1;  ///< its deflection is sense (output - less)
  double sense = 1;            ///< -1 of a length: compression counts positive
};

/// The rig's model with its start. Wheels do not turn on their carriers, and motions keep their initial values. Tyres,
/// frictions and the elements in the axle's `without` are removed; wheels of other axles with tyres stand on fixed
/// pads.
struct Rig {
  Axle axle;
  Compilation compilation;
  std::array<RigWheel, 2> wheels;  ///< left, right; a missing wheel has no centre
  std::vector<RigElement> elements;
  std::array<int, kRigInputs> inputs{};  ///< index into the model's inputs, -1: none
  std::string steer_unit;                ///< of the steering coordinate; "" without one
  GenericState start;
  std::vector<double> start_inputs;
};

/// A problem of an axle of a model.
Diagnostic problem_of(const Model& model, const Axle& axle, const std::string& message, const std::string& hint = "");

/// Wheels on pads, and the drives of the pads.
struct Pads {
  std::set<int> hanging = {};  ///< tyres of other axles that hang free, the others stand on pads of their own
  bool are_driven = true;      ///< pads of the axle are driven, else they follow its wheels
};

/// Decisions about a rig.
struct RigDecisions {
  Pads pads;
  Topology topology;
  Analysis analysis;
};

/// The rig at a state of the user's model, at these values of its inputs; without programs. known: decisions for other
/// values of tunable parameters, or null. Fails: with one problem if it is not a solvable model; UserError if nothing
/// holds the body to ground.
Result<Rig> make_rig(const Compilation& user, const Axle& axle, const OperatingPoint& at, const Pads& pads,
                     const RigDecisions* known = nullptr);

/// Whether the rig has programs, and its points derivatives.
inline bool has_rates(const Rig& rig) { return rig.compilation.directional != nullptr; }

/// Removes tyres, frictions, outputs, the start, and the forces that the axle names.
void take_away(const Axle& axle, Model& model);

/// A state of balance on the rig: the outputs of its model, and their derivatives along the inputs.
struct RigPoint {
  RigInputs imposed{};
  GenericState state;
  std::vector<double> inputs;  ///< of the model
  std::vector<double> values;  ///< of the outputs
  Eigen::MatrixXd slopes;      ///< outputs x kRigInputs; empty unless asked for
};

/// The static equilibrium at given inputs, found from a near state; for a mechanism without free directions its closed
/// position. Status: of the search.
Status find_point(const Rig& rig, const RigInputs& imposed, const GenericState& near, RigPoint& point);

/// Adds the derivatives: of closed loops by their velocities, of compliant ones by the linear response of the
/// equilibrium, both from the differentiated programs (no differences). Result: none, or the reason for their absence.
std::optional<Diagnostic> add_slopes(const Rig& rig, RigPoint& point);

/// Chooses the partitions of the rig's loops for a position, if the present ones are ill-conditioned there and others
/// are not. The coordinates remain the same.
void choose_at(Rig& rig, const GenericState& state);

}  // namespace mbgen::kc
