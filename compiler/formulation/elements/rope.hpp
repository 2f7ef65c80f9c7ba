#pragma once
// Ropes and belts: their spans at a state, loads on bodies and wheels, tangents, energy.

#include "compiler/expressions/jet.hpp"
#include "compiler/formulation/elements/element_tangents.hpp"
#include "compiler/formulation/elements/energy.hpp"
#include "compiler/formulation/elements/rope_law.hpp"
#include "compiler/formulation/elements/rope_path.hpp"
#include "compiler/model/moving.hpp"

namespace mbgen {

/// Quantities of a span of a rope.
template <class T>
struct RopeState {
  T tension{0.0}, length{0.0}, stretch{0.0}, rate{0.0}, wrap{0.0}, energy{0.0};  ///< N, m, m, m/s, rad, J
};
template <>
struct StateOf<Rope> {
  template <class T>
  using type = RopeState<T>;
};

/// Value of a quantity by its index.
template <class T>
T shown(const RopeState<T>& rope, int quantity, int /*axis*/) {
  const T* values[] = {&rope.tension, &rope.length, &rope.stretch, &rope.rate, &rope.wrap, &rope.energy};
  return *values[quantity];
}

namespace detail {

/// A rope at an instant: its stations on their bodies, its shape now and at the reference.
template <class T>
struct RopeAtWork {
  const Rope& rope;
  int frame = kGround;  ///< of all vectors
  std::vector<Place<T>> at;
  std::vector<RopePlace<T>> places;
  std::vector<T> turned, turns;  ///< of each wheel about its axis, rad, and its rate
  RopeShape<T> now, reference;
  std::vector<T> rates;  ///< of the reach of each span, m/s
};

template <class T>
std::vector<RopePlace<T>> rope_places(const ForceWork<T>& work, RopeAtWork<T>& rope) {
  const System<T>& system = work.system;
  std::vector<RopePlace<T>> reference;
  const auto tree = [&](int body) { return system.topology.tree_body[body]; };
  const auto& path = rope.rope.path;
  rope.frame = system.layout.frame_of(tree(path[0].at.body));
  for (const RopeStation& station : path)
    for (const int body : {station.at.body, station.carrier}) rope.frame = common_frame(system, rope.frame, tree(body));
  for (const RopeStation& station : path) {
    rope.at.push_back(work.place(station.at));
    const Place<T>& at = rope.at.back();
    RopePlace<T> place;
    place.is_circle = station.is_circle();
    const Vector<T> axis = constant<T>(station.axis);
    if (station.kind != RopeStation::Kind::point)
      place.radius = T(station.sense) * work.value(station.radius, "radius", rope.rope.name);
    place.axis = axis;
    place.centre = at.at + carrier_origin(system.topology, system.constants, station.at.body);
    reference.push_back(place);
    place.axis = direction_in(system, work.k, tree(station.carrier), axis, rope.frame);
    place.centre = position_in(system, work.k, at, rope.frame);
    rope.places.push_back(place);
    const bool is_wheel = station.angle.expression >= 0;
    const T way(station.wheel_sense);
    rope.turned.push_back(is_wheel ? way * work.value(station.angle) : T(0.0));
    rope.turns.push_back(is_wheel ? way * system.environment.velocity(station.wheel) : T(0.0));
  }
  return reference;
}

/// Speeds at which the spans grow: the power of a tension of 1 against it.
template <class T>
std::vector<T> reach_rates(const ForceWork<T>& work, const RopeAtWork<T>& rope) {
  const System<T>& system = work.system;
  std::vector<T> rates(rope.now.spans.size(), T(0.0));
  for (std::size_t s = 0; s < rope.at.size(); ++s) {
    if (rope.at[s].body == kGround) continue;
    const Vector<T> velocity = velocity_in(system, work.k, work.v, rope.at[s], rope.frame);
    const Vector<T> spin = direction_in(system, work.k, system.layout.frame_of(rope.at[s].body),
                                        velocity_of(system, work.v, rope.at[s].body).angular, rope.frame);
    for (std::size_t g = 0; g < rates.size(); ++g) {
      const RopePull<T>& pull = rope.now.spans[g].pulls[s];
      rates[g] = rates[g] - (dot(pull.force, velocity) + dot(pull.moment, spin));
    }
  }
  return rates;
}

template <class T>
RopeAtWork<T> rope_at_work(const ForceWork<T>& work, const Rope& rope) {
  const System<T>& system = work.system;
  RopeAtWork<T> result{rope, kGround, {}, {}, {}, {}, {}, {}, {}};
  const std::vector<RopePlace<T>> reference = rope_places(work, result);
  result.reference = rope_shape<T>(rope, reference, [&](std::size_t s, const Vector<T>& now, const Vector3& then) {
    return reference[s].radius * rope_angle(reference[s].axis, constant<T>(then), now, 0, T(1.0));
  });
  result.now = rope_shape<T>(rope, result.places, [&](std::size_t s, const Vector<T>& now, const Vector3& then) {
    const RopeStation& station = rope.path[s];
    const Vector<T> seen = direction_up(system, work.k, result.frame, now, system.topology.tree_body[station.carrier]);
    const T angle = rope_angle(constant<T>(station.axis), constant<T>(then), seen, 0, T(1.0));
    return result.places[s].radius * (angle - result.turned[s]);
  });
  result.rates = reach_rates(work, result);
  return result;
}

/// The free length of a rope as a whole and its rate, from time and inputs.
template <class T>
Jet<T> free_length_of(const ForceWork<T>& work, const Rope& rope) {
  const System<T>& system = work.system;
  Jet<T> length = evaluate<Jet<T>>(*rope.free_length, system.model.expressions,
                                   MotionEnvironment<T, Environment<T>>{system.model.inputs, system.environment});
  work.system.annotator.constant(length.value, "l0_", rope.name);
  return length;
}

/// Free lengths of the spans at the reference, m, and their rates.
template <class T>
std::vector<Jet<T>> natural_lengths(const ForceWork<T>& work, const RopeAtWork<T>& at, const std::optional<T>& ea) {
  const Rope& rope = at.rope;
  std::vector<Jet<T>> natural;
  T total(0.0);
  for (const RopeSpan<T>& span : at.reference.spans) {
    natural.push_back(span.length);
    total = total + span.length;
  }
  bool is_one = rope.spans == 1;  // all of it is in one span
  for (std::size_t s = 0; s < rope.path.size(); ++s) {
    if (rope.path[s].kind != RopeStation::Kind::pulley || !rope.path[s].separates()) continue;
    total = total + T(rope.path[s].sense) * at.places[s].radius * at.reference.wraps[s];
    is_one = false;
  }
  if (rope.free_length) {
    const Jet<T> whole = free_length_of(work, rope);
    for (Jet<T>& length : natural) length = is_one ? whole : Jet<T>(length.value / total) * whole;
  } else if (rope.pretension) {
    const T pull = work.value(*rope.pretension, "f0", rope.name);
    for (Jet<T>& length : natural)
      length = ea ? length.value / (T(1.0) + pull / *ea) : length.value - pull / work.value(*rope.stiffness);
  }
  return natural;
}

/// Rope that wheels put into each span by their turns, m, or by their rates, m/s.
template <class T>
std::vector<T> from_wheels(const RopeAtWork<T>& at, const std::vector<T>& turns) {
  const Rope& rope = at.rope;
  std::vector<T> paid(at.now.spans.size(), T(0.0));
  for (const RopeLeg& leg : legs_of(rope)) {
    T& own = paid[static_cast<std::size_t>(leg.span)];
    if (rope.path[leg.from].separates()) own = own + at.places[leg.from].radius * turns[leg.from];
    if (rope.path[leg.to].separates()) own = own - at.places[leg.to].radius * turns[leg.to];
  }
  return paid;
}

template <class T>
RopeNumbers<T> rope_numbers(const ForceWork<T>& work, const RopeAtWork<T>& at, const T* slips) {
  using mbgen::max, mbgen::select;
  using std::exp, std::sqrt;
  const Rope& rope = at.rope;
  RopeNumbers<T> numbers;
  if (rope.ea) numbers.ea = work.value(*rope.ea, "ea", rope.name);
  numbers.damping = work.value(rope.damping, "damping", rope.name);
  numbers.lag = T(*rope.lag);
  numbers.grooves = grooves_of(rope);
  const std::vector<Jet<T>> natural = natural_lengths(work, at, numbers.ea);
  std::vector<T> paid = from_wheels(at, at.turned), paying = from_wheels(at, at.turns);
  for (std::size_t j = 0; j < numbers.grooves.size(); ++j) {
    T &before = paid[numbers.grooves[j].before], &behind = paid[numbers.grooves[j].behind];
    before = before - slips[j];
    behind = behind + slips[j];
  }
  for (std::size_t g = 0; g < natural.size(); ++g) {
    const RopeSpan<T>& then = at.reference.spans[g];
    numbers.slack.push_back(then.reach - then.length + natural[g].value);
    numbers.slack_rate.push_back(natural[g].first);
    if (!numbers.ea) {
      numbers.stiffness.push_back(work.value(*rope.stiffness, "k", rope.name));
      continue;
    }
    const T length = natural[g].value + paid[g];
    // Not a number for a span that is wound up.
    numbers.stiffness.push_back(*numbers.ea / select(length, length, T(sqrt(length))));
    numbers.length.push_back(length);
    numbers.lengthens.push_back(natural[g].first + paying[g]);
  }
  for (const RopeGroove& groove : numbers.grooves)
    numbers.grip.push_back(exp(work.value(rope.path[groove.station].friction, "mu", rope.name) *
                               max(at.now.wraps[groove.station], T(0.0))));
  return numbers;
}

/// A wheel that takes up rope gets, beside the tension, the energy that a metre of stretched rope has: the rope that it
/// takes has none, and a constant EA conserves energy.
template <class T>
void wind_up(ForceWork<T>& work, const RopeAtWork<T>& at, const std::vector<T>& elastic, const T& ea) {
  const Rope& rope = at.rope;
  const auto act_on = [&](std::size_t s, int span, int way) {
    if (!rope.path[s].has_wheel() || !rope.path[s].separates()) return;
    const T& tension = elastic[static_cast<std::size_t>(span)];
    const T density = T(0.5 * way * rope.path[s].wheel_sense) * (tension * tension) / ea;
    add_joint_force(work, rope.path[s].wheel, at.places[s].radius * density);
  };
  for (const RopeLeg& leg : legs_of(rope)) {
    act_on(leg.from, leg.span, 1);
    act_on(leg.to, leg.span, -1);
  }
}

/// Not a number where a taut rope would lift off a pulley.
template <class T>
T on_its_pulleys(const RopeSpan<T>& span, const T& tension) {
  using mbgen::select;
  using std::sqrt;
  if (!span.least) return tension;
  return select(*span.least, tension, select(-tension, tension, T(sqrt(*span.least))));
}

/// Appends how the places of a rope hold, see hold_names. tension: of its spans.
template <class T>
void add_holds(ForceWork<T>& work, const RopeAtWork<T>& at, const RopeNumbers<T>& numbers,
               const std::vector<T>& stretch, const std::vector<T>& tension) {
  using mbgen::select;
  const Rope& rope = at.rope;
  std::vector<T>& hold = work.forces.hold;
  hold.insert(hold.end(), at.now.rooms.begin(), at.now.rooms.end());
  for (const RopeLeg& leg : legs_of(rope))
    if (rope.path[leg.to].kind == RopeStation::Kind::pulley)
      hold.push_back(select(at.now.wraps[leg.to], T(0.0), -tension[static_cast<std::size_t>(leg.span)]));
  for (std::size_t g = 0; g < stretch.size(); ++g) {
    const T is_number = stretch[g] * stretch[g];
    hold.push_back(numbers.length.empty() ? is_number : T(select(numbers.length[g], is_number, numbers.length[g])));
  }
}

template <class T>
void apply(ForceWork<T>& work, const Rope& rope) {
  if (rope.path.empty()) return;  // its first span acts
  const auto& list = work.system.model.ropes;
  const std::size_t index = index_in(list, rope);
  const auto state = state_of_element(work.system.model, rope);
  const RopeAtWork<T> at = rope_at_work(work, rope);
  const T* slips = work.system.x.data() + state;
  const RopeNumbers<T> numbers = rope_numbers(work, at, slips);
  std::vector<T> reach;
  for (const RopeSpan<T>& span : at.now.spans) reach.push_back(span.reach);
  RopeForces<T> law = rope_law(numbers, reach, at.rates, slips);
  for (std::size_t j = 0; j < law.slip_rate.size(); ++j) work.forces.xd[state + j] = law.slip_rate[j];
  add_holds(work, at, numbers, law.stretch, law.tension);
  for (std::size_t g = 0; g < law.tension.size(); ++g) {
    law.tension[g] = on_its_pulleys(at.now.spans[g], law.tension[g]);
    work.system.annotator.name(law.tension[g], "tension_", list[index + g].name);
  }
  for (std::size_t s = 0; s < rope.path.size(); ++s) {
    RopePull<T> sum;
    for (std::size_t g = 0; g < law.tension.size(); ++g) {
      sum.force = sum.force + law.tension[g] * at.now.spans[g].pulls[s].force;
      sum.moment = sum.moment + law.tension[g] * at.now.spans[g].pulls[s].moment;
    }
    const int carrier = work.system.layout.frame_of(at.at[s].body);
    const auto seen = [&](const Vector<T>& v) { return direction_up(work.system, work.k, at.frame, v, carrier); };
    act(work, {rope.path[s].at.body, seen(sum.force), seen(sum.moment),
               arm_of(work.system, work.k, at.at[s], work.forces.about)});
  }
  if (numbers.ea) wind_up(work, at, law.elastic, *numbers.ea);
  for (std::size_t g = 0; g < law.tension.size(); ++g) {
    using mbgen::max;
    const RopeSpan<T>& span = at.now.spans[g];
    state_for(work.system, work.forces, list[index + g]) = {
        law.tension[g], span.length, law.stretch[g],
        law.rate[g],    span.wrap,   T(0.5) * law.elastic[g] * max(law.stretch[g], T(0.0))};
  }
}

/// Tangents over the reaches of the spans and the slips; wraps and the turns of wheels in a span's stiffness count as
/// constant.
template <class T>
void add_tangents(ForceWork<T>& work, const Rope& rope, std::vector<ElementTangents<T>>& elements) {
  using S = Slope<T>;
  if (rope.path.empty()) return;
  const int state = static_cast<int>(state_of_element(work.system.model, rope));
  const RopeAtWork<T> at = rope_at_work(work, rope);
  const RopeNumbers<T> numbers = rope_numbers(work, at, work.system.x.data() + state);
  LawElement<T> element;
  for (std::size_t g = 0; g < at.now.spans.size(); ++g) {
    LocalCoordinate<T> along{std::vector<T>(work.system.topology.bodies.size(), T(0.0))};
    for (std::size_t s = 0; s < at.at.size(); ++s) {
      const RopePull<T>& pull = at.now.spans[g].pulls[s];
      add_force(work, at.at[s], kGround, at.frame, -pull.force, -pull.moment, along.row);
    }
    element.coordinates.push_back(std::move(along));
    element.at.position.push_back(at.now.spans[g].reach);
    element.at.velocity.push_back(at.rates[g]);
  }
  for (std::size_t j = 0; j < numbers.grooves.size(); ++j) {
    element.states.push_back(state + static_cast<int>(j));
    element.at.state.push_back(work.system.x[static_cast<std::size_t>(state) + j]);
  }
  elements.push_back(differentiated(work, std::move(element), [&](const LawPoint<S>& point) {
    RopeForces<S> law = rope_law(numbers, point.position, point.velocity, point.state.data());
    LawResult<S> result{{}, std::move(law.slip_rate)};
    for (const S& tension : law.tension) result.force.push_back(-tension);
    return result;
  }));
}

template <class T>
T stored_energy(const EnergyWork<T>& work, const Rope& rope) {
  return state_of(work.system, work.forces, rope).energy;
}

}  // namespace detail
}  // namespace mbgen
