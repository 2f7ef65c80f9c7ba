#pragma once
// Bushings: force law of their six freedoms, Maxwell branches.

#include "compiler/formulation/elements/energy.hpp"
#include "compiler/formulation/elements/six_freedoms.hpp"
#include "compiler/model/auxiliary_states.hpp"

namespace mbgen {

/// Deflection of a bushing, and load on its `to` body at the point of `to`, in its axes on `from`, with the sense of
/// its freedoms.
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

/// Value of a quantity by its index.
template <class T>
T shown(const BushingState<T>& bushing, int quantity, int axis) {
  const Vector<T>* values[] = {&bushing.force, &bushing.moment, &bushing.deflection, &bushing.rotation};
  const Vector<T>& v = *values[quantity];
  return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
}

namespace detail {

/// A value per freedom of a bushing, with its sense.
template <class T>
using BushingValues = std::array<T, kBushingFreedoms>;

/// Forces of a bushing against its deflections, N and N m, and the rates of the extensions of its Maxwell branches.
template <class T>
struct BushingForces {
  BushingValues<T> force;
  std::vector<T> extension_rates;
};

/// Force law of a bushing; depends on deflections, their rates and the extensions of its Maxwell branches only. A: T,
/// or Slope<T> for differentiation.
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
      // Separate statements: names are given in the order of evaluation, which is unspecified within an expression.
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

template <class T>
SixFreedoms<T> freedoms_of(const ForceWork<T>& work, const Bushing& bushing) {
  std::array<double, kBushingFreedoms> sense;
  for (int i = 0; i < kBushingFreedoms; ++i) sense[static_cast<std::size_t>(i)] = bushing_sense(bushing, i);
  return {work, bushing.from, bushing.to, bushing.axes, sense};
}

/// Names the deflections and loads of a bushing in programs for reading.
template <class T>
void detail_bushing(const ForceWork<T>& work, const SixFreedoms<T>& at, const BushingState<T>& state,
                    const std::string& bushing) {
  Annotator<T>& annotator = work.system.annotator;
  if (!annotator.has_details()) return;
  detail_name(annotator, state.deflection, "deflection_", bushing);
  detail_name(annotator, state.rotation, "rotation_", bushing);
  detail_name(annotator, Vector<T>{at.rate[0], at.rate[1], at.rate[2]}, "rate_", bushing);
  detail_name(annotator, Vector<T>{at.rate[3], at.rate[4], at.rate[5]}, "rate_", bushing, "_turn");
  detail_name(annotator, state.moment, "moment_", bushing);
  detail_name(annotator, at.seen.gap, "gap_", bushing);
  detail_name(annotator, at.seen.drift, "vgap_", bushing);
  detail_name(annotator, at.seen.spin, "spin_", bushing);
  detail_name(annotator, at.turned.sines, "sines_", bushing);
  annotator.detail(at.turned.curvature, "curvature_", bushing);
}

template <class T>
void apply(ForceWork<T>& work, const Bushing& bushing) {
  const std::vector<T>& x = work.system.x;
  std::size_t next = state_of_element(work.system.model, bushing);
  const SixFreedoms<T> at = freedoms_of(work, bushing);
  const BushingForces<T> law = bushing_law(work, bushing, at.position, at.rate, x.data() + next);
  for (const T& rate : law.extension_rates) work.forces.xd[next++] = rate;
  const bool turns = bushing_acts(bushing, 3) || bushing_acts(bushing, 4) || bushing_acts(bushing, 5);
  // Before the actions on bodies, whose names would be first along the axes of a body.
  const auto on_from = [&](int i) { return T(-1.0) * law.force[i]; };
  if (work.system.annotator.has_details())
    detail_name(work.system.annotator, Vector<T>{on_from(0), on_from(1), on_from(2)}, "force_", bushing.name);
  const auto [force, moment] = at.resist(work, law.force, turns);
  const auto& q = at.position;
  BushingState<T> state{{q[0], q[1], q[2]}, {q[3], q[4], q[5]}, at.counted(-force, 0), at.counted(-moment, 3)};
  detail_bushing(work, at, state, bushing.name);
  name(work.system.annotator, state.deflection, "q_", bushing.name);
  name(work.system.annotator, state.force, "f_", bushing.name);
  state_for(work.system, work.forces, bushing) = std::move(state);
}

/// Freedoms of a bushing with a force.
inline std::vector<int> acting_freedoms(const Bushing& bushing) {
  std::vector<int> freedoms;
  for (int i = 0; i < kBushingFreedoms; ++i)
    if (bushing_acts(bushing, i)) freedoms.push_back(i);
  return freedoms;
}

template <class T>
ElementTangents<T> tangents_of(ForceWork<T>& work, const Bushing& bushing, int first_state) {
  using S = Slope<T>;
  const SixFreedoms<T> m = freedoms_of(work, bushing);
  const std::vector<int> freedoms = acting_freedoms(bushing);
  LawElement<T> element;
  for (const int freedom : freedoms) {
    element.coordinates.push_back({m.row(work, freedom)});
    element.at.position.push_back(m.position[freedom]);
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
      deflection[i] = S(m.position[i]);
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
  elements.push_back(tangents_of(work, bushing, static_cast<int>(state_of_element(model, bushing))));
}

/// Including the springs of Maxwell branches.
template <class T>
T stored_energy(const EnergyWork<T>& work, const Bushing& bushing) {
  const System<T>& system = work.system;
  const BushingState<T>& state = state_of(system, work.forces, bushing);
  auto branch = state_of_element(system.model, bushing);
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
