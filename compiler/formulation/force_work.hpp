#pragma once
// Common parts of the force elements: their results, their view of the system, characteristics, and forces put on
// bodies.

#include <functional>
#include <optional>

#include "compiler/formulation/motion.hpp"
#include "compiler/model/curve.hpp"
#include "mbgen/tyre.hpp"

namespace mbgen {

/// Length, its rate and the tension of an element between two points.
template <class T>
struct ElementState {
  T length{0.0}, rate{0.0}, force{0.0};  ///< m, m/s, N (tension positive)
};

/// A bushing's deflection and what acts on its `to` body at the point of `to`, in its axes on `from`, counted as its
/// freedoms are.
template <class T>
struct BushingState {
  Vector<T> deflection, rotation;  ///< m, rad
  Vector<T> force, moment;         ///< N, N m
};

/// A bump stop's way beyond its clearance, the rate of that and the force against it.
template <class T>
struct BumpStopState {
  T penetration{0.0}, rate{0.0}, force{0.0};  ///< m or rad, per second, N or N m
};

/// One force element's force and moment on one body of the model, in the frame that carries the body.
template <class T>
struct Action {
  int body = -1;            ///< index into Model::bodies
  Vector<T> force, moment;  ///< N, N m
  Vector<T> point;          ///< of the force, m, from the point of AppliedForces::about
};

template <class T>
struct AppliedForces {
  std::vector<Spatial<T>> wrench;  ///< per body, in the axes of the frame that carries it
  std::vector<T> joint;            ///< per coordinate, N or N m
  std::vector<Action<T>> actions;  ///< terms of the sum `wrench`, and actions on bodies fixed to ground
  std::vector<T> xd;               ///< rates of the auxiliary states
  std::vector<T> bristle_rates;    ///< the last of them, those of frictions
  std::vector<ElementState<T>> springs, air_springs;
  std::vector<TyreResult<T>> tyres;
  std::vector<BushingState<T>> bushings;
  std::vector<BumpStopState<T>> bump_stops;
  MotionPoint about = MotionPoint::frame_origin;  ///< point of the body that wrenches are about
};

namespace detail {

/// The forces of a tyre (index into Model::tyres) by a law that several share, none where it shares none.
template <class T>
using SharedTyreLaw =
    std::function<std::optional<TyreResult<T>>(std::size_t tyre, const TyreProperties<T>&, const TyreContact<T>&)>;

/// State that the force elements read, and sums that they add to.
template <class T>
struct ForceWork {
  System<T>& system;
  const Kinematics<T>& k;
  const Velocities<T>& v;
  AppliedForces<T>& forces;
  SharedTyreLaw<T> shared_law = {};  ///< where tyres share one
  T value(const Quantity& q) const { return value_of(system.model, q, system.environment); }
  /// The value of an element's field, named <meaning>_<element>.
  T value(const Quantity& q, const char* meaning, const std::string& element) const {
    T result = value(q);
    system.scribe.constant(result, meaning, "_", element);
    return result;
  }
  Place<T> place(const Attachment& at) const { return place_of(system, at); }
};

/// Value of a characteristic at an argument: factor times argument, or a table. The factor is named
/// <meaning>_<element>.
template <class T>
T law(const ForceWork<T>& work, const Law& law, const T& argument, const char* meaning, const std::string& element) {
  if (const Quantity* factor = std::get_if<Quantity>(&law)) return work.value(*factor, meaning, element) * argument;
  return value_along(std::get<Table>(law), argument);
}

template <class T>
T law(const ForceWork<T>& work, const std::optional<Law>& optional, const T& argument, const char* meaning,
      const std::string& element) {
  return optional ? law(work, *optional, argument, meaning, element) : T(0.0);
}

/// An expression with two local variables.
template <class T>
T with_locals(const ForceWork<T>& work, int expression, const T& first, const T& second) {
  Environment<T> environment = work.system.environment;
  environment.locals = {first, second};
  return evaluate<T>(work.system.model.expressions[expression], environment);
}

/// Adds a force and a moment on a body of the model.
template <class T>
void act(ForceWork<T>& work, const Action<T>& action) {
  work.forces.actions.push_back(action);
  const int body = work.system.topology.tree_body[action.body];
  if (body == kGround) return;
  Spatial<T>& wrench = work.forces.wrench[body];
  wrench = wrench + force_at(action.force, action.point);
  wrench.angular = wrench.angular + action.moment;
}

/// Adds a generalised force on a coordinate.
template <class T>
void add_joint_force(ForceWork<T>& work, const CoordinateReference& reference, const T& force) {
  const int i = tree_coordinate(work.system.topology, reference);
  if (i >= 0) work.forces.joint[i] = work.forces.joint[i] + force;
}

/// Adds a force at a place of a body, given in the axes of a frame at or below the place's.
template <class T>
void apply_force(ForceWork<T>& work, int model_body, const Place<T>& place, const Vector<T>& force, int frame) {
  const int carrier = work.system.layout.frame_of(place.body);
  act(work, {model_body,
             direction_up(work.system, work.k, frame, force, carrier),
             {},
             arm_of(work.system, work.k, place, work.forces.about)});
}

/// The line between two places, in the axes of a frame.
template <class T>
struct Line {
  Place<T> from, to;
  int frame = kGround;
  Vector<T> gap;         ///< m
  T length, reciprocal;  ///< m, 1/m
  T rate;                ///< of the length, m/s
};

template <class T>
Line<T> line_between(const System<T>& system, const Kinematics<T>& k, const Velocities<T>& v, const Attachment& from,
                     const Attachment& to) {
  const Place<T> a = place_of(system, from), b = place_of(system, to);
  const int frame = common_frame(system, a.body, b.body);
  const Vector<T> gap = position_in(system, k, b, frame) - position_in(system, k, a, frame);
  const Vector<T> gap_rate = velocity_in(system, k, v, b, frame) - velocity_in(system, k, v, a, frame);
  const T length = norm(gap);
  const T reciprocal = T(1.0) / length;
  return {a, b, frame, gap, length, reciprocal, dot(gap, gap_rate) * reciprocal};
}

/// Two places joined by a line element; `tension` gives its force from length and rate.
template <class T, class Tension>
ElementState<T> line_element(ForceWork<T>& work, const Attachment& from, const Attachment& to, const Tension& tension) {
  const Line<T> line = line_between(work.system, work.k, work.v, from, to);
  ElementState<T> state;
  state.length = line.length;
  state.rate = line.rate;
  const T reference = reference_distance(work.system.topology, work.system.constants, to, line.to, from, line.from);
  state.force = tension(state.length, state.rate, reference);
  const Vector<T> force = (state.force * line.reciprocal) * line.gap;
  apply_force(work, from.body, line.from, force, line.frame);
  apply_force(work, to.body, line.to, -force, line.frame);
  return state;
}

}  // namespace detail
}  // namespace mbgen
