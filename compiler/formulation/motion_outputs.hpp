#pragma once
// Outputs over positions, velocities, states and applied forces, as values of expressions too.

#include <algorithm>

#include "compiler/formulation/elements/stored_energy.hpp"
#include "compiler/formulation/momentum.hpp"
#include "compiler/formulation/users_angles.hpp"
#include "compiler/model/element_access.hpp"

namespace mbgen {
namespace detail {

/// A direction of a frame in the axes of a body of the model at or above it.
template <class T>
Vector<T> in_axes_of(const System<T>& system, const Kinematics<T>& k, int frame, const Vector<T>& direction, int body) {
  const Vector<T> tree_axes = direction_up(system, k, frame, direction, system.topology.tree_body[body]);
  return transposed_times(pose_rotation<T>(system.model.bodies[body].pose), tree_axes);
}

template <class T>
T point_output(const System<T>& system, const SolvedState<T>& s, const PointOutput& output) {
  if (output.relative_to.body >= 0) return relative_point_output(system, s, output);
  const Place<T> place = place_of(system, output.point);
  const int carrier = system.layout.frame_of(place.body);
  Vector<T> global;
  if (output.what == PointOutput::What::position) {
    global = position_in(system, s.kinematics, place, kGround);
  } else {
    const Vector<T> in_carrier =
        output.what == PointOutput::What::velocity
            ? velocity_in(system, s.kinematics, s.velocities, place, carrier)
            : place_acceleration(system, s.kinematics, s.accelerations, place) +
                  direction_up(system, s.kinematics, kGround, system.constants.gravity, carrier);
    if (output.in_body_axes)
      return component(in_axes_of(system, s.kinematics, carrier, in_carrier, output.point.body), output.axis);
    global = direction_in(system, s.kinematics, carrier, in_carrier, kGround);
  }
  if (output.axes != kNoBody && !output.in_body_axes)
    return component(in_axes_of_any(system, s.kinematics, kGround, global, output.axes), output.axis);
  if (!output.in_body_axes) return component(global, output.axis);
  return component(in_axes_of(system, s.kinematics, kGround, global, output.point.body), output.axis);
}

template <class T>
T coordinate_output(const Topology& topology, const Coordinates<T>& users, const CoordinateOutput& output) {
  const int i = tree_coordinate(topology, output.coordinate);
  if (i < 0) return T(0.0);
  if (output.what == CoordinateOutput::What::position) return users.z[i];
  return output.what == CoordinateOutput::What::velocity ? users.zd[i] : users.zdd[i];
}

template <class T>
T element_output(const System<T>& system, const AppliedForces<T>& forces, const ElementOutput& output) {
  T value(0.0);
  with_kind(output.kind, [&](auto kind) {
    const auto& element = kind.list(system.model)[output.element];
    const EnergyWork<T> work{system, forces};
    if constexpr (requires { stored_energy(work, element); })
      if (output.quantity == quantity_index(kind, kPotentialEnergy)) return void(value = stored_energy(work, element));
    if constexpr (requires { shown(state_of(system, forces, element), 0, 0); })
      value = shown(state_of(system, forces, element), output.quantity, output.axis);
  });
  return value;
}

/// Value of an output by its source, where it needs accelerations at most.
template <class T>
struct MotionReader {
  const System<T>& system;
  const SolvedState<T>& s;
  const Coordinates<T>& users;  ///< as the model counts them

  T operator()(const ExpressionOutput& output) const {
    return value_of(system.model, output.value, system.environment);
  }
  T operator()(const PointOutput& output) const { return point_output(system, s, output); }
  T operator()(const CoordinateOutput& output) const { return coordinate_output(system.topology, users, output); }
  T operator()(const ElementOutput& output) const { return element_output(system, s.forces, output); }
  T operator()(const StoredEnergyOutput&) const { return stored_energy_of_all(system, s.forces); }
  T operator()(const RotationOutput& output) const { return rotation_output(system, s, output); }
  T operator()(const MomentumOutput& output) const { return momentum_output(system, s, output); }
  T operator()(const PointsOutput& output) const { return points_output(system, s, output); }
  T operator()(const WheelOutput& output) const { return wheel_output(system, s, output); }
  /// Known after forces only, see OutputReader.
  T operator()(const DriveOutput&) const { return T(0.0); }
  T operator()(const ReactionOutput&) const { return T(0.0); }
  T operator()(const MultiplierOutput&) const { return T(0.0); }
};

/// Sets the observed outputs of a round for expressions. read: as MotionReader.
template <class T, class Read>
void observe(System<T>& system, int round, const Read& read) {
  std::vector<T>& values = system.environment.observed;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const ObservedOutput& observed = system.model.observed[i];
    if (observed.round != round) continue;
    values[i] = std::visit(read, observed.output.source);
    system.annotator.name(values[i], "out_", observed.output.name);
  }
}

/// The same before accelerations are known.
template <class T>
void observe(System<T>& system, const Kinematics<T>& k, const Velocities<T>& v, const AppliedForces<T>& forces,
             int round) {
  if (system.model.observed.empty()) return;
  const std::size_t size = system.topology.bodies.size();
  Accelerations<T> unknown;  // outputs of velocities may ask for these too, without a use for them
  unknown.base.resize(size);
  unknown.own.resize(size);
  unknown.about = v.about;
  const std::vector<T> none(size, T(0.0));
  const std::vector<std::vector<T>> no_multipliers;
  const SolvedState<T> s{k, v, unknown, forces, none, no_multipliers, none};
  const Coordinates<T> users = users_coordinates(system.environment, none);
  observe(system, round, MotionReader<T>{system, s, users});
}

}  // namespace detail
}  // namespace mbgen
