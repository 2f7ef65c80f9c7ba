#pragma once
// Bushings: deflections, the law of the six freedoms, Maxwell branches.

#include "compiler/formulation/elements/element_tangents.hpp"
#include "compiler/formulation/elements/energy.hpp"
#include "compiler/formulation/elements/seen_place.hpp"
#include "compiler/formulation/orientation.hpp"
#include "compiler/model/auxiliary_states.hpp"

namespace mbgen {

/// A bushing's deflection and what acts on its `to` body at the point of `to`, in its axes on `from`, counted as its
/// freedoms are.
template <class T>
struct BushingState {
  Vector<T> deflection, rotation;  ///< m, rad
  Vector<T> force, moment;         ///< N, N m
};
template <>
struct StateOf<Bushing> {
  template <class T>
  using type = BushingState<T>;
};

/// By index of the quantity.
template <class T>
T shown(const BushingState<T>& bushing, int quantity, int axis) {
  const Vector<T>* values[] = {&bushing.force, &bushing.moment, &bushing.deflection, &bushing.rotation};
  const Vector<T>& v = *values[quantity];
  return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
}

namespace detail {

/// Below this square of the sine the functions of an angle are series, exact to rounding with six terms.
constexpr double kSmallSineSquared = 1e-3;

/// A rotation by its rotation vector, with what takes an angular velocity to the rate of the vector.
template <class T>
struct TurnedBy {
  Vector<T> vector;  ///< theta: axis times angle, rad
  Vector<T> sines;   ///< axis times sine of the angle
  T curvature{0.0};  ///< h: (1 - angle/2 cot(angle/2)) / sine^2
};

/// The rotation vector of a rotation matrix up to kLargestBushingTurn, not a number beyond. Smooth through zero, where
/// angle/sine and h are their series in the square of the sine. sines: half the skew part of the matrix; cosine: of the
/// angle. Source: the exponential map of rotations, as in F. C. Park, "Computing the exponential and its derivative";
/// the series are those of asin(s)/s and of (1 - asin(s)/2 (1 + sqrt(1 - s^2))/s)/s^2.
template <class T>
TurnedBy<T> turned_by(const Vector<T>& sines, const T& cosine) {
  using mbgen::select;
  using std::atan2, std::sqrt;
  const T square = dot(sines, sines);
  const T half(0.5), one(1.0);
  // Small angle: a small sine, and not that of nearly half a turn.
  const T is_small = T(2.0 * kSmallSineSquared) - (square + (one - cosine));
  const T by_series =
      one +
      square * (T(1.0 / 6) +
                square * (T(3.0 / 40) + square * (T(5.0 / 112) + square * (T(35.0 / 1152) + square * T(63.0 / 2816)))));
  const T safe = select(is_small, one, square);
  const T sine = sqrt(safe);
  const T by_angle = atan2(sine, cosine) / sine;
  const T within = cosine - T(std::cos(kLargestBushingTurn));
  TurnedBy<T> turned;
  const T factor = select(within, select(is_small, by_series, by_angle), T(sqrt(within)));
  const T h_by_series =
      T(1.0 / 12) +
      square * (T(7.0 / 240) + square * (T(53.0 / 3360) + square * (T(823.0 / 80640) + square * T(12923.0 / 1774080))));
  turned.vector = factor * sines;
  turned.sines = sines;
  turned.curvature = select(is_small, h_by_series, T((one - half * (by_angle * (one + cosine))) / safe));
  return turned;
}

/// Rate of the rotation vector from the angular velocity, both in the axes that the rotation starts from: the inverse
/// of the left Jacobian of the exponential map.
template <class T>
Vector<T> rate_of_vector(const TurnedBy<T>& turned, const Vector<T>& spin) {
  return spin - T(0.5) * cross(turned.vector, spin) + turned.curvature * cross(turned.sines, cross(turned.sines, spin));
}

/// Moment whose power on the angular velocity is that of `forces` on the rate of the rotation vector: the transpose of
/// rate_of_vector.
template <class T>
Vector<T> moment_of_forces(const TurnedBy<T>& turned, const Vector<T>& forces) {
  return forces + T(0.5) * cross(turned.vector, forces) +
         turned.curvature * cross(turned.sines, cross(turned.sines, forces));
}

/// A value per freedom of a bushing, counted as they are.
template <class T>
using BushingValues = std::array<T, kBushingFreedoms>;

/// Forces of a bushing against its deflections, N and N m, and the rates of the extensions of its Maxwell branches.
template <class T>
struct BushingForces {
  BushingValues<T> force;
  std::vector<T> extension_rates;
};

/// The law of a bushing: a function of deflections, their rates and the extensions of its Maxwell branches alone.
/// A: T, or Slope<T> where the law is differentiated.
template <class T, class A>
BushingForces<A> bushing_law(const ForceWork<T>& work, const Bushing& bushing, const BushingValues<A>& deflection,
                             const BushingValues<A>& rate, const A* extensions) {
  BushingForces<A> result;
  for (int i = 0; i < kBushingFreedoms; ++i) {
    const std::string freedom(kBushingFreedomNames[i]);
    const auto value = [&](const Quantity& quantity, const char* meaning, const std::string& of) {
      return A(work.value(quantity, (meaning + of).c_str(), bushing.name));
    };
    A force(0.0);
    for (int j = 0; j < kBushingFreedoms; ++j) {
      const std::string pair = freedom + "_" + std::string(kBushingFreedomNames[j]);
      const int upper = kBushingFreedoms * std::min(i, j) + std::max(i, j);
      if (bushing_couples(bushing.stiffness, i, j))
        force = force + value((*bushing.stiffness)[upper], "k_", pair) * deflection[j];
      if (bushing_couples(bushing.damping, i, j))
        force = force + value((*bushing.damping)[upper], "d_", pair) * rate[j];
    }
    if (const std::optional<BushingFreedom>& own = bushing.freedoms[i]) {
      // One after the other: names are given in the order of evaluation, which compilers choose within an expression.
      force = force + value(own->preload, "f0_", freedom);
      force = force + law(work, own->stiffness, deflection[i], ("k_" + freedom).c_str(), bushing.name);
      force = force + law(work, own->damping, rate[i], ("d_" + freedom).c_str(), bushing.name);
      if (own->force) force = force + with_locals(work, *own->force, deflection[i], rate[i]);
      if (own->maxwell_stiffness) {
        const A& extension = extensions[result.extension_rates.size()];
        force = force + value(*own->maxwell_stiffness, "km_", freedom) * extension;
        result.extension_rates.push_back(rate[i] - extension / value(own->maxwell_time, "tm_", freedom));
      }
    }
    result.force[i] = force;
  }
  return result;
}

/// Deflections of a bushing and their rates, and what leads back from forces on them to forces on the bodies.
template <class T>
struct BushingMotion {
  SeenPlace<T> seen;
  TurnedBy<T> turned;  ///< axes of the bushing
  BushingValues<T> deflection, rate;
};

/// Columns of a bushing's axes, in the axes of its `from` body.
template <class T>
Matrix<T> axes_of(const Bushing& bushing) {
  return pose_rotation<T>(Pose{{}, bushing.axes});
}

template <class T>
BushingMotion<T> bushing_motion(const ForceWork<T>& work, const Bushing& bushing) {
  const System<T>& system = work.system;
  BushingMotion<T> m;
  m.seen = seen_place(work, bushing.from, bushing.to);
  const int from = m.seen.from.body, to = m.seen.to.body, frame = m.seen.frame;
  const auto in_from = [&](const Vector<T>& v) { return direction_up(system, work.k, frame, v, from); };
  const auto column = [&](const Vector3& axis) {
    return in_from(direction_in(system, work.k, to, constant<T>(axis), frame));
  };
  const Matrix<T> axes = axes_of<T>(bushing);
  const Matrix<T> turn{column({1, 0, 0}), column({0, 1, 0}), column({0, 0, 1})};
  const Vector<T> sines = T(0.5) * Vector<T>{turn.y.z - turn.z.y, turn.z.x - turn.x.z, turn.x.y - turn.y.x};
  const T cosine = T(0.5) * (turn.x.x + turn.y.y + turn.z.z - T(1.0));
  m.turned = turned_by(transposed_times(axes, sines), cosine);
  const Vector<T> spin_between = transposed_times(axes, in_from(spin_in(work, to, frame)) - m.seen.spin);
  const Vector<T> parts[] = {transposed_times(axes, m.seen.gap), m.turned.vector, transposed_times(axes, m.seen.drift),
                             rate_of_vector(m.turned, spin_between)};
  for (int i = 0; i < kBushingFreedoms; ++i) {
    const T sense(bushing_sense(bushing, i));
    m.deflection[i] = sense * component(parts[i / 3], i % 3);
    m.rate[i] = sense * component(parts[2 + i / 3], i % 3);
  }
  return m;
}

template <class T>
void apply(ForceWork<T>& work, const Bushing& bushing) {
  const std::vector<T>& x = work.system.x;
  std::size_t next =
      static_cast<std::size_t>(first_extension(work.system.model, index_in(work.system.model.bushings, bushing)));
  const BushingMotion<T> motion = bushing_motion(work, bushing);
  const BushingForces<T> law = bushing_law(work, bushing, motion.deflection, motion.rate, x.data() + next);
  for (const T& rate : law.extension_rates) work.forces.xd[next++] = rate;
  BushingValues<T> on_from;
  for (int i = 0; i < kBushingFreedoms; ++i) on_from[i] = T(bushing_sense(bushing, i)) * law.force[i];
  const Vector<T> force{on_from[0], on_from[1], on_from[2]};
  const bool turns = bushing_acts(bushing, 3) || bushing_acts(bushing, 4) || bushing_acts(bushing, 5);
  Vector<T> moment;
  if (turns) moment = moment_of_forces(motion.turned, Vector<T>{on_from[3], on_from[4], on_from[5]});
  const Matrix<T> axes = axes_of<T>(bushing);
  act_between(work, bushing.from, bushing.to, motion.seen, axes * force, axes * moment);
  const auto counted = [&](const Vector<T>& v, int first) {
    const auto sense = [&](int i) { return T(bushing_sense(bushing, first + i)); };
    return Vector<T>{sense(0) * v.x, sense(1) * v.y, sense(2) * v.z};
  };
  const auto& q = motion.deflection;
  BushingState<T> state{{q[0], q[1], q[2]}, {q[3], q[4], q[5]}, counted(-force, 0), counted(-moment, 3)};
  name(work.system.scribe, state.deflection, "q_", bushing.name);
  name(work.system.scribe, state.force, "f_", bushing.name);
  states_of<Bushing>(work.forces).push_back(std::move(state));
}

/// The row of a deflection of a bushing.
template <class T>
std::vector<T> deflection_row(const ForceWork<T>& work, const Bushing& bushing, const BushingMotion<T>& m,
                              int freedom) {
  const Matrix<T> axes = axes_of<T>(bushing);
  const T sense(bushing_sense(bushing, freedom));
  Vector<T> along;
  (freedom % 3 == 0 ? along.x : freedom % 3 == 1 ? along.y : along.z) = sense;
  return freedom < 3 ? row_between(work, m.seen, axes * along, Vector<T>{})
                     : row_between(work, m.seen, Vector<T>{}, axes * moment_of_forces(m.turned, along));
}

/// The freedoms along which a bushing acts.
inline std::vector<int> acting_freedoms(const Bushing& bushing) {
  std::vector<int> freedoms;
  for (int i = 0; i < kBushingFreedoms; ++i)
    if (bushing_acts(bushing, i)) freedoms.push_back(i);
  return freedoms;
}

template <class T>
ElementTangents<T> tangents_of(ForceWork<T>& work, const Bushing& bushing, int first_state) {
  using S = Slope<T>;
  const BushingMotion<T> m = bushing_motion(work, bushing);
  const std::vector<int> freedoms = acting_freedoms(bushing);
  LawElement<T> element;
  for (const int freedom : freedoms) {
    element.coordinates.push_back({deflection_row(work, bushing, m, freedom)});
    element.at.position.push_back(m.deflection[freedom]);
    element.at.velocity.push_back(m.rate[freedom]);
    const std::optional<BushingFreedom>& own = bushing.freedoms[freedom];
    if (own)
      for (const int expression : expressions_of(own->preload, own->stiffness, own->damping, own->force))
        element.expressions.push_back(expression);
  }
  for (int s = 0; s < maxwell_branches(bushing); ++s) {
    element.states.push_back(first_state + s);
    element.at.state.push_back(work.system.x[first_state + s]);
  }
  return differentiated(work, std::move(element), [&](const LawPoint<S>& at) {
    BushingValues<S> deflection, rate;
    for (int i = 0; i < kBushingFreedoms; ++i) {
      deflection[i] = S(m.deflection[i]);
      rate[i] = S(m.rate[i]);
    }
    for (std::size_t a = 0; a < freedoms.size(); ++a) {
      deflection[freedoms[a]] = at.position[a];
      rate[freedoms[a]] = at.velocity[a];
    }
    BushingForces<S> law = bushing_law(work, bushing, deflection, rate, at.state.data());
    LawResult<S> result{{}, std::move(law.extension_rates)};
    for (const int freedom : freedoms) result.force.push_back(-law.force[freedom]);
    return result;
  });
}

template <class T>
void add_tangents(ForceWork<T>& work, const Bushing& bushing, std::vector<ElementTangents<T>>& elements) {
  const Model& model = work.system.model;
  elements.push_back(tangents_of(work, bushing, first_extension(model, index_in(model.bushings, bushing))));
}

/// Springs of Maxwell branches too.
template <class T>
T stored_energy(const EnergyWork<T>& work, const Bushing& bushing) {
  const System<T>& system = work.system;
  const BushingState<T>& state = state_of(system, work.forces, bushing);
  auto branch = static_cast<std::size_t>(first_extension(system.model, index_in(system.model.bushings, bushing)));
  const auto deflection = [&](int i) { return component(i < 3 ? state.deflection : state.rotation, i % 3); };
  T energy(0.0);
  for (int i = 0; i < kBushingFreedoms; ++i) {
    const T q = deflection(i);
    for (int j = i; j < kBushingFreedoms; ++j)
      if (bushing_couples(bushing.stiffness, i, j))
        energy = energy + T(i == j ? 0.5 : 1.0) * work.value((*bushing.stiffness)[kBushingFreedoms * i + j]) *
                              (q * deflection(j));
    const std::optional<BushingFreedom>& own = bushing.freedoms[i];
    if (!own) continue;
    energy = energy + work_of(work, own->stiffness, q) + work.value(own->preload) * q;
    if (own->maxwell_stiffness) {
      const T& extension = system.x[branch++];
      energy = energy + T(0.5) * work.value(*own->maxwell_stiffness) * (extension * extension);
    }
  }
  return energy;
}

}  // namespace detail
}  // namespace mbgen
