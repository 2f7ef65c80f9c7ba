#pragma once
// Tyres on roads, around the tyre law of the runtime's header tyre.hpp.

#include "compiler/formulation/elements/tyre_names.hpp"
#include "compiler/formulation/roads/road_envelope.hpp"
#include "compiler/model/auxiliary_states.hpp"

namespace mbgen {

/// Value of a quantity by its index.
template <class T>
T shown(const TyreResult<T>& tyre, int quantity, int /*axis*/) {
  const T* values[] = {&tyre.load, &tyre.fx, &tyre.fy, &tyre.mz, &tyre.kappa, &tyre.alpha};
  return *values[quantity];
}

template <>
struct StateOf<Tyre> {
  template <class T>
  using type = TyreResult<T>;
};

namespace detail {

/// Spin axis of a wheel in its carrying frame; equal to the joint's own axis if possible, so that the spin angle
/// cancels. axis: GLOBAL at the reference. body: of the tree.
template <class T>
Vector<T> spin_axis(const System<T>& system, const Kinematics<T>& k, const Vector3& axis, int body) {
  if (body == kGround) return constant<T>(axis);
  const Vector3& joint = system.topology.bodies[body].axis;
  const double along = joint[0] * axis[0] + joint[1] * axis[1] + joint[2] * axis[2];
  const int carrier = system.layout.frame_of(body);
  if (system.revolute(body) && std::abs(std::abs(along) - 1) < 1e-12 &&
      system.layout.bodies[body].joint_frame == carrier)
    return T(along > 0 ? 1.0 : -1.0) * k.axis[body];
  return direction_in(system, k, body, constant<T>(axis), carrier);
}

/// Plane of the road under a wheel at rest, at the position of the wheel centre.
template <class T>
struct RoadPlane {
  Vector<T> up;     ///< its unit normal, in the frame that carries the wheel
  T distance;       ///< m, of the wheel centre from it
  T friction{1.0};  ///< factor of the tyre's friction
};

/// The plane under a wheel: from the tyre's envelope, or tangential to the road vertically below the centre. The latter
/// needs one evaluation of the road instead of a search: with the road's curvature c (1/m) and slope p relative to the
/// wheel, the nearest point of the road is closer by about c h^2 p^2 / 2 than this plane, h its distance.
template <class T>
RoadPlane<T> road_plane(const ForceWork<T>& work, const Tyre& tyre) {
  using std::sqrt;
  const System<T>& system = work.system;
  const Place<T> centre = work.place(tyre.centre);
  const int carrier = system.layout.frame_of(centre.body);
  const Vector<T> vertical{T(0.0), T(0.0), T(1.0)};
  const Vector<T> position = position_in(system, work.k, centre, kGround);
  const T height = position.z - work.value(tyre.road_height, "road", tyre.name);
  if (tyre.road < 0) return {direction_up(system, work.k, kGround, vertical, carrier), height};
  const Road& road = system.model.roads[tyre.road];
  const auto [x, y] = on_road(road, position.x, position.y);
  const T cosine(std::cos(road.heading)), sine(std::sin(road.heading));
  RoadHeight<T> below;
  if (tyre.envelope) {
    const Vector<T> axis =
        direction_in(system, work.k, carrier, spin_axis(system, work.k, tyre.axis, centre.body), kGround);
    const T level = T(1.0) / sqrt(axis.x * axis.x + axis.y * axis.y);
    const T forward_x = level * axis.y, forward_y = -(level * axis.x);
    below = height_of_envelope<T>(work, tyre, road,
                                  {x, y, cosine * forward_x + sine * forward_y, cosine * forward_y - sine * forward_x});
  } else {
    below = height_of_road(work, road, x, y);
  }
  const T by_x = cosine * below.by_x - sine * below.by_y, by_y = sine * below.by_x + cosine * below.by_y;
  const T steepness = T(1.0) / sqrt(T(1.0) + by_x * by_x + by_y * by_y);
  const Vector<T> normal{-(steepness * by_x), -(steepness * by_y), steepness};
  return {direction_up(system, work.k, kGround, normal, carrier), steepness * (height - T(road.origin[2]) - below.z),
          friction_of_road(work, road, x, y)};
}

inline Turning turning_of(const Tyre& tyre) {
  if (!tyre.parking) return Turning::none;
  return tyre.turn_slip ? Turning::turn_slip : Turning::patch;
}

/// A wheel in the axes of the frame that carries it. road: plane under it.
template <class T>
WheelMotion<T> wheel_motion(const ForceWork<T>& work, const Tyre& tyre, std::size_t index, const RoadPlane<T>& road) {
  const System<T>& system = work.system;
  const Place<T> centre = work.place(tyre.centre);
  WheelMotion<T> wheel;
  wheel.up = road.up;
  wheel.axis = spin_axis(system, work.k, tyre.axis, centre.body);
  wheel.height = road.distance;
  const Spatial<T> velocity = velocity_of(system, work.v, centre.body);
  wheel.velocity = velocity_at(velocity, arm_of(system, work.k, centre, work.v.about));
  wheel.angular = velocity.angular;
  wheel.u = system.x[2 * index];
  wheel.v = system.x[2 * index + 1];
  if (tyre.parking) wheel.turn = system.x[turn_state(system.model, index)];
  return wheel;
}

/// The contact of a wheel and its position, m, from the reference point of the wheel body's motion.
template <class T>
struct PlacedContact {
  RoadContact<T> contact;
  Vector<T> point;
};
template <class T>
PlacedContact<T> placed_contact(const ForceWork<T>& work, const Tyre& tyre, const WheelMotion<T>& wheel) {
  const RoadContact<T> contact = road_contact(wheel, work.value(tyre.radius, "radius", tyre.name));
  return {contact, arm_of(work.system, work.k, work.place(tyre.centre), work.v.about) + contact.down};
}

/// Properties of a mounted tyre; value: of one of the tyre's quantities, named by its meaning.
template <class T, class Value>
TyreProperties<T> tyre_properties(const Tyre& tyre, const Value& value) {
  TyreProperties<T> properties{value(tyre.radius, "radius"),
                               value(tyre.stiffness, "k"),
                               value(tyre.damping, "d"),
                               value(tyre.friction, "friction"),
                               value(tyre.rolling_resistance, "rolling"),
                               value(tyre.relaxation_x, "relaxation_x"),
                               value(tyre.relaxation_y, "relaxation_y"),
                               value(tyre.low_speed, "low_speed"),
                               T(tyre.side),
                               T(tyre.count),
                               value(tyre.pressure, "pressure"),
                               T(tyre.over_load_x ? 1.0 : 0.0),
                               T(tyre.over_load_y ? 1.0 : 0.0)};
  if (tyre.parking) {
    properties.turn_stiffness = value(tyre.parking->stiffness, "turn_stiffness");
    properties.turn_radius = value(tyre.parking->radius, "turn_radius");
    properties.turn_load = value(tyre.parking->load, "turn_load");
  }
  properties.turning = turning_of(tyre);
  properties.ellipse = tyre.combined_slip == CombinedSlip::ellipse;
  return properties;
}

/// Calls use(set) with a tyre's set of coefficients in the form of its model.
template <class T, class Use>
auto with_tyre_set(TyreModel model, const std::vector<T>& coefficients, const Use& use) {
  if (model == TyreModel::mf61) return use(MagicFormula61<T>::from_fields(coefficients.data()));
  return model == TyreModel::pac2002 ? use(Pac2002<T>::from_fields(coefficients.data()))
                                     : use(Pac89<T>::from_fields(coefficients.data()));
}

/// The law of a set of coefficients.
template <class T>
TyreResult<T> tyre_law(TyreModel model, const std::vector<T>& coefficients, const TyreProperties<T>& properties,
                       const TyreContact<T>& contact) {
  return with_tyre_set(model, coefficients, [&](const auto& set) { return tyre_forces(set, properties, contact); });
}

/// Properties of a mounted tyre, named; over A: T, or Slope<T>.
template <class A, class T>
TyreProperties<A> properties_on(const ForceWork<T>& work, const Tyre& tyre, const RoadPlane<T>& road) {
  TyreProperties<A> properties = tyre_properties<A>(
      tyre, [&](const Quantity& q, const char* meaning) { return A(work.value(q, meaning, tyre.name)); });
  properties.friction = A(road.friction) * properties.friction;
  return properties;
}

/// Names the quantities of a tyre in programs for reading.
template <class T>
void detail_tyre(const ForceWork<T>& work, const Tyre& tyre, const TyreProperties<T>& properties,
                 const TyreContact<T>& contact, const TyreResult<T>& result) {
  if (!work.system.annotator.has_details()) return;
  const TyreNames<T> name{work.system.annotator, tyre.name};
  detail_result(name, result);
  std::vector<T> coefficients;
  for (const Quantity& q : tyre.coefficients) coefficients.push_back(work.value(q));
  with_tyre_set(tyre.model, coefficients, [&](const auto& set) { detail_law(name, set, properties, contact); });
}

template <class T>
TyreResult<T> tyre_result(const ForceWork<T>& work, const Tyre& tyre, const TyreProperties<T>& properties,
                          const TyreContact<T>& contact) {
  std::vector<T> coefficients;
  for (const Quantity& q : tyre.coefficients) coefficients.push_back(work.value(q));
  return tyre_law(tyre.model, coefficients, properties, contact);
}

/// Leaves a tyre to a shared law. Result: false for a tyre without one.
template <class T>
bool act_by_shared_law(ForceWork<T>& work, const Tyre& tyre, std::size_t i, const TyreProperties<T>& properties,
                       const WheelMotion<T>& wheel) {
  if (!work.shared_law) return false;
  const std::optional<WheelForces<T>> on_wheel = work.shared_law(i, properties, wheel);
  if (!on_wheel) return false;
  act(work, {tyre.centre.body, on_wheel->wrench.linear, on_wheel->wrench.angular,
             arm_of(work.system, work.k, work.place(tyre.centre), work.v.about)});
  work.forces.xd[2 * i] = on_wheel->du;
  work.forces.xd[2 * i + 1] = on_wheel->dv;
  if (tyre.parking) work.forces.xd[turn_state(work.system.model, i)] = on_wheel->dturn;
  return true;
}

template <class T>
void apply(ForceWork<T>& work, const Tyre& tyre) {
  const std::size_t i = index_in(work.system.model.tyres, tyre);
  TyreResult<T>& seen = state_for(work.system, work.forces, tyre);  // zero where a law is shared
  const RoadPlane<T> road = road_plane(work, tyre);
  const WheelMotion<T> wheel = wheel_motion(work, tyre, i, road);
  const TyreProperties<T> properties = properties_on<T>(work, tyre, road);
  if (act_by_shared_law(work, tyre, i, properties, wheel)) return;
  const auto [contact, point] = placed_contact(work, tyre, wheel);
  const TyreResult<T> result = tyre_result(work, tyre, properties, contact.motion);
  const Spatial<T> wrench = tyre_wrench(contact, result);
  detail_contact(work, wheel, contact, tyre.name);
  detail_tyre(work, tyre, properties, contact.motion, result);
  work.system.annotator.name(result.load, "load_", tyre.name);
  work.system.annotator.name(result.fx, "fx_", tyre.name);
  work.system.annotator.name(result.fy, "fy_", tyre.name);
  act(work, {tyre.centre.body, wrench.linear, wrench.angular, point});
  work.forces.xd[2 * i] = result.du;
  work.forces.xd[2 * i + 1] = result.dv;
  if (tyre.parking) work.forces.xd[turn_state(work.system.model, i)] = result.dturn;
  seen = result;
}

}  // namespace detail
}  // namespace mbgen
