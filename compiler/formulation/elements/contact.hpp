#pragma once
// Contacts: nearest point of the surface, its axes, law along the normal (of bump stops) and friction across it.

#include "compiler/formulation/elements/bump_stop.hpp"
#include "compiler/formulation/elements/contact_surface.hpp"
#include "compiler/model/auxiliary_states.hpp"
#include "mbgen/solver/bristle.hpp"

namespace mbgen {

/// A contact at work.
template <class T>
struct ContactState {
  T load{0.0}, lateral{0.0}, penetration{0.0}, rate{0.0}, slip{0.0};  ///< N, N, m, m/s, m/s
  Vector<T> force;                                                    ///< N, on the body of `from`, global axes
};
template <>
struct StateOf<SurfaceContact> {
  template <class T>
  using type = ContactState<T>;
};

/// Value of a quantity by its index.
template <class T>
T shown(const ContactState<T>& contact, int quantity, int axis) {
  const T* values[] = {&contact.load, &contact.lateral, &contact.penetration, &contact.rate, &contact.slip};
  const Vector<T>& v = contact.force;
  return quantity < 5 ? *values[quantity] : axis == 0 ? v.x : axis == 1 ? v.y : v.z;
}

/// Bristles that hold an element at rest: states that share a limit.
struct BristleHold {
  std::size_t first = 0, count = 1;  ///< auxiliary states
  double limit = 0;                  ///< rad or m: deflection beyond which the element slides
  bool bears = false;                ///< whether they may bend
};

namespace detail {

/// m/s and parts of a deflection: smallest speed and deflection whose direction counts.
inline constexpr double kLeastSlip = 1e-9, kLeastBend = 1e-12;
/// Time in lags by which bristles of an open contact straighten: within the reach of steps longer than the model's.
inline constexpr double kReleaseInLags = 4;

/// A contact and its motion, in the axes of the body of `to`, or global on a road.
template <class T>
struct ContactMotion {
  SeenPlace<T> seen;  ///< `to` is the centre of the sphere, `from` the point of the other body
  ContactSurface<T> surface;
  T penetration, rate;  ///< m, m/s
  T arm;                ///< m, of the contact point below the centre, against the normal
  T slip[2];            ///< m/s, of the sphere's body over the surface, along the surface's axes
};

/// The centre of a sphere from the global origin, in global axes.
template <class T>
SeenPlace<T> seen_from_origin(const ForceWork<T>& work, const Attachment& centre) {
  SeenPlace<T> s;
  s.to = work.place(centre);
  s.gap = position_in(work.system, work.k, s.to, kGround);
  s.drift = velocity_in(work.system, work.k, work.v, s.to, kGround);
  return s;
}

template <class T>
ContactMotion<T> contact_motion(const ForceWork<T>& work, const SurfaceContact& contact) {
  const System<T>& system = work.system;
  ContactMotion<T> m;
  m.seen = contact.shape == SurfaceContact::Shape::road ? seen_from_origin(work, contact.from)
                                                        : seen_place(work, contact.to, contact.from);
  m.surface = contact_surface(work, contact, m.seen.gap);
  const T radius = work.value(contact.radius, "radius", contact.name);
  m.penetration = radius - m.surface.distance;
  m.rate = -dot(m.surface.normal, m.seen.drift);
  m.arm = radius - T(0.5) * m.penetration;
  if (!contact.has_friction()) return m;
  const Vector<T> spin =
      direction_up(system, work.k, m.seen.frame, spin_in(work, m.seen.to.body, m.seen.frame), m.seen.from.body) -
      m.seen.spin;
  const Vector<T> sliding = m.seen.drift - m.arm * cross(spin, m.surface.normal);
  m.slip[0] = dot(sliding, m.surface.first);
  m.slip[1] = dot(sliding, m.surface.second);
  return m;
}

/// Friction per N of normal force on the part that slides, and the rates of both bristles, m/s.
template <class A>
struct ContactFriction {
  A force[2], rate[2];
};

/// w . r. Its derivative by w is limited for bristles beyond their largest deflection, bent > 1: these spring back, and
/// would add energy over a whole step.
template <class T, class A>
A onwards(const A (&w)[2], const A (&r)[2], const A& bent) {
  using mbgen::max;
  A along = w[0] * r[0] + w[1] * r[1];
  if constexpr (!std::is_same_v<T, A>) {
    const T by_deflection = A::times(w[0].value, r[0].slope) + A::times(w[1].value, r[1].slope);
    const T by_speed = A::times(w[0].slope, r[0].value) + A::times(w[1].slope, r[1].value);
    along.slope = by_deflection + by_speed / max(bent.value, T(1.0));
  }
  return along;
}

/// Two bristles, along perpendicular axes of the surface, that share one limit, as the elasto-plastic bristle of
/// frictions in each direction (mbgen/solver/bristle.hpp). With the sliding velocity v, the deflections b, at most
/// b_max = bristle g(v) / stiction, and g Stribeck's curve of the coefficients:
///   force = -c (b + damping db/dt),  db/dt = w - yield (w . r)+ r / |r|,  r = b / b_max,  c = stiction / bristle
/// w = v or, where v is faster, b_max / lag in its direction; yield as there, of |r|; damping leaves the force at most
/// g(v), or at c |b| where this is more. So bristles bend towards the sliding without a preferred direction, and steady
/// sliding has the force g(v) against v.
template <class T, class A>
ContactFriction<A> contact_friction(const ForceWork<T>& work, const SurfaceContact& contact, const A (&velocity)[2],
                                    const A (&deflection)[2]) {
  using mbgen::max, mbgen::min;
  using std::exp, std::sqrt;
  const auto value = [&](const Quantity& q, const char* meaning) { return number<A>(work, q, meaning, contact.name); };
  const auto length = [](const A& x, const A& y, double least) { return sqrt(x * x + y * y + A(least * least)); };
  const A static_level = value(contact.stiction, "stiction"), bristle = value(contact.bristle, "bristle");
  const A speed = length(velocity[0], velocity[1], kLeastSlip);
  A level = static_level, largest = bristle;
  if (contact.has_stiction()) {
    const A sliding = value(contact.friction, "friction");
    const A ratio = speed / value(contact.stribeck_velocity, "stribeck");
    level = sliding + (static_level - sliding) * exp(-(ratio * ratio));
    largest = bristle * (level / static_level);
  }
  const A lag(*contact.lag);
  const A limited = largest / max(largest, lag * speed);
  const A elastic = value(contact.elastic, "elastic");
  A w[2], r[2];
  for (int i = 0; i < 2; ++i) {
    w[i] = velocity[i] * limited;
    r[i] = deflection[i] / largest;
  }
  const A bent = length(r[0], r[1], kLeastBend);
  const A s = min(max((bent - elastic) / max(A(1.0) - elastic, A(kLeastBristleYield)), A(0.0)), A(1.0));
  const A yield = s * s * (A(3.0) - A(2.0) * s) * max(onwards<T>(w, r, bent), A(0.0)) / bent;
  const A stiffness = static_level / bristle, damping = value(contact.bristle_damping, "bristle_damping");
  ContactFriction<A> result;
  A pull[2];
  for (int i = 0; i < 2; ++i) {
    result.rate[i] = w[i] - yield * r[i];
    pull[i] = stiffness * (deflection[i] + damping * result.rate[i]);
  }
  // Not the elastic part: a search for a rest then finds bristles that would have to bend too far.
  const A most = max(level, stiffness * length(deflection[0], deflection[1], kLeastBristle));
  const A within = most / max(most, length(pull[0], pull[1], kLeastBend));
  for (int i = 0; i < 2; ++i) result.force[i] = -(within * pull[i]);
  return result;
}

/// Forces of a contact, N: along the normal and along the axes of the surface, on the sphere's body; rates of its
/// bristles, m/s.
template <class A>
struct ContactForces {
  A normal{0.0}, across[2] = {A(0.0), A(0.0)}, rate[2] = {A(0.0), A(0.0)};
};

/// Law of a contact over A: T, or Slope<T> for differentiation. factor: of the friction, from the road.
template <class T, class A>
ContactForces<A> contact_law(const ForceWork<T>& work, const SurfaceContact& contact, const T& factor,
                             const A& penetration, const A& rate, const A (&slip)[2], const A (&deflection)[2]) {
  using mbgen::select;
  ContactForces<A> forces;
  forces.normal = bump_stop_law(work, contact.push, penetration, rate).force;
  if (!contact.has_friction()) return forces;
  const ContactFriction<A> friction = contact_friction(work, contact, slip, deflection);
  const A released(-1 / (kReleaseInLags * (*contact.lag > 0 ? *contact.lag : kShortestBristleLag)));
  for (int i = 0; i < 2; ++i) {
    forces.across[i] = A(factor) * forces.normal * friction.force[i];
    forces.rate[i] = select(-penetration, released * deflection[i], friction.rate[i]);
  }
  return forces;
}

/// Names the geometry of a contact in programs for reading.
template <class T>
void detail_contact_motion(const ForceWork<T>& work, const ContactMotion<T>& m, const std::string& contact) {
  Annotator<T>& annotator = work.system.annotator;
  if (!annotator.has_details()) return;
  detail_name(annotator, m.seen.gap, "gap_", contact);
  detail_name(annotator, m.seen.drift, "vgap_", contact);
  detail_name(annotator, m.surface.normal, "normal_", contact);
  annotator.detail(m.surface.distance, "distance_", contact);
  annotator.detail(m.arm, "arm_", contact);
}

/// The states of a contact's bristles; zero without friction.
template <class T>
std::array<T, 2> bristles_of(const ForceWork<T>& work, const SurfaceContact& contact, std::size_t first) {
  if (!contact.has_friction()) return {T(0.0), T(0.0)};
  return {work.system.x[first], work.system.x[first + 1]};
}

/// The bristles of a contact with friction: they bear while it touches.
inline std::optional<BristleHold> bristle_hold(const ForceWork<double>& work, const SurfaceContact& contact) {
  if (!contact.has_friction()) return {};
  const Model& model = work.system.model;
  return BristleHold{state_of_element(model, contact), 2, work.value(contact.bristle),
                     contact_motion(work, contact).penetration > 0};
}

template <class T>
void apply(ForceWork<T>& work, const SurfaceContact& contact) {
  const System<T>& system = work.system;
  const Model& model = system.model;
  const auto first = state_of_element(model, contact);
  const ContactMotion<T> m = contact_motion(work, contact);
  detail_contact_motion(work, m, contact.name);
  const auto [b1, b2] = bristles_of(work, contact, first);
  const T deflection[2] = {b1, b2};
  const ContactForces<T> law =
      contact_law(work, contact, m.surface.friction, m.penetration, m.rate, m.slip, deflection);
  const Vector<T> friction = law.across[0] * m.surface.first + law.across[1] * m.surface.second;
  const Vector<T> force = law.normal * m.surface.normal + friction;
  const Vector<T> moment = m.arm * cross(m.surface.normal, friction);  // on the other body, about the centre
  if (contact.shape != SurfaceContact::Shape::road) {
    act_between(work, contact.to, contact.from, m.seen, -force, moment);
  } else {
    const int carrier = system.layout.frame_of(m.seen.to.body);
    const auto on_sphere = [&](const Vector<T>& v) { return direction_up(system, work.k, kGround, v, carrier); };
    act(work, {contact.from.body, on_sphere(force), on_sphere(-moment),
               arm_of(system, work.k, m.seen.to, work.forces.about)});
  }
  ContactState<T> state{law.normal, T(0.0), m.penetration,
                        m.rate,     T(0.0), direction_in(system, work.k, m.seen.from.body, force, kGround)};
  if (contact.has_friction()) {
    for (std::size_t i = 0; i < 2; ++i) work.forces.xd[first + i] = law.rate[i];
    state.lateral = safe_length(law.across[0] * law.across[0] + law.across[1] * law.across[1]);
    state.slip = safe_length(m.slip[0] * m.slip[0] + m.slip[1] * m.slip[1]);
  }
  state_for(work.system, work.forces, contact) = std::move(state);
}

/// Local coordinates: the distance of the centre from the surface, and with friction the ways of the contact point
/// along both axes of the surface.
template <class T>
void add_tangents(ForceWork<T>& work, const SurfaceContact& contact, std::vector<ElementTangents<T>>& elements) {
  using S = Slope<T>;
  const Model& model = work.system.model;
  const int first = static_cast<int>(state_of_element(model, contact));
  const ContactMotion<T> m = contact_motion(work, contact);
  LawElement<T> element;
  const auto add = [&](const Vector<T>& along, const T& position, const T& rate) {
    element.coordinates.push_back({row_between(work, m.seen, along, -m.arm * cross(m.surface.normal, along))});
    element.at.position.push_back(position);
    element.at.velocity.push_back(rate);
  };
  add(m.surface.normal, -m.penetration, -m.rate);
  element.expressions = expressions_of(contact.friction, contact.stiction);
  if (contact.has_friction()) {
    add(m.surface.first, T(0.0), m.slip[0]);
    add(m.surface.second, T(0.0), m.slip[1]);
    for (int i = 0; i < 2; ++i) {
      element.states.push_back(first + i);
      element.at.state.push_back(work.system.x[static_cast<std::size_t>(first + i)]);
    }
  }
  elements.push_back(differentiated(work, std::move(element), [&](const LawPoint<S>& at) {
    const bool rubs = contact.has_friction();
    const S none(0.0), slip[2] = {rubs ? at.velocity[1] : none, rubs ? at.velocity[2] : none},
                       deflection[2] = {rubs ? at.state[0] : none, rubs ? at.state[1] : none};
    const ContactForces<S> law =
        contact_law(work, contact, m.surface.friction, S(-at.position[0]), S(-at.velocity[0]), slip, deflection);
    LawResult<S> result{{law.normal}, {}};
    for (int i = 0; rubs && i < 2; ++i) {
      result.force.push_back(law.across[i]);
      result.rate.push_back(law.rate[i]);
    }
    return result;
  }));
}

/// Of the penetration; bristles have none.
template <class T>
T stored_energy(const EnergyWork<T>& work, const SurfaceContact& contact) {
  using mbgen::max;
  const T zero(0.0), depth = max(state_of(work.system, work.forces, contact).penetration, zero);
  const double power = contact.push.exponent + 1;
  return max(work.value(std::get<Quantity>(*contact.push.stiffness)), zero) * power_by_constant(depth, power) /
         T(power);
}

}  // namespace detail
}  // namespace mbgen
