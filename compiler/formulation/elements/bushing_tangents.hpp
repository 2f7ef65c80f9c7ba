#pragma once
// Tangents of bushings, by their deflections, rates and the extensions of Maxwell branches, and of bump stops.

#include "compiler/formulation/elements/bump_stops.hpp"
#include "compiler/formulation/elements/bushings.hpp"
#include "compiler/formulation/elements/element_tangents.hpp"

namespace mbgen {
namespace detail {

/// How a coordinate between two bodies moves with the tree's coordinates: what a unit force along it does, turned
/// round. force, moment: on `to`, in the axes of the body of `from`.
template <class T>
std::vector<T> row_between(const ForceWork<T>& work, const SeenPlace<T>& s, const Vector<T>& force,
                           const Vector<T>& moment) {
  const System<T>& system = work.system;
  std::vector<T> row(system.topology.bodies.size(), T(0.0));
  const auto seen = [&](const Vector<T>& v) { return direction_in(system, work.k, s.from.body, v, s.frame); };
  add_force(work, s.to, s.from.body, s.frame, seen(force), seen(moment), row);
  add_force(work, s.from, s.to.body, s.frame, seen(-force), seen(-moment - cross(s.gap, force)), row);
  return row;
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
ElementTangents<T> bushing_element(ForceWork<T>& work, const Bushing& bushing, int first_state) {
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
void bushing_tangents(ForceWork<T>& work, std::vector<ElementTangents<T>>& elements) {
  int next = slip_state_count(work.system.model);
  for (const Bushing& bushing : work.system.model.bushings) {
    const auto heading = work.system.scribe.within(OwnerKind::bushing, index_in(work.system.model.bushings, bushing));
    elements.push_back(bushing_element(work, bushing, next));
    next += static_cast<int>(elements.back().states.size());
  }
}

/// The tangents of a bump stop on a coordinate, between points or along an axis.
template <class T>
ElementTangents<T> bump_stop_element(ForceWork<T>& work, const BumpStop& stop) {
  using S = Slope<T>;
  const auto push = [&](const S& travel, const S& rate) { return -bump_stop_law(work, stop, travel, rate).force; };
  if (stop.is_on_joint()) {
    const Environment<T>& e = work.system.environment;
    const T sign(stop.side == BumpStop::Side::below ? -1.0 : 1.0);
    LocalCoordinate<T> along{tree_local(work.system, stop.joint).row};
    for (T& entry : along.row) entry = S::times(sign, entry);
    return scalar_element(work, std::move(along), T(sign * e.position(stop.joint)), T(sign * e.velocity(stop.joint)),
                          expressions_of(stop.force), push);
  }
  if (stop.axis) {
    const TravelAlongAxis<T> t = travel_along_axis(work, stop);
    return scalar_element(work, {row_between(work, t.seen, t.axis, Vector<T>{})}, t.travel, t.rate,
                          expressions_of(stop.force), push);
  }
  const S sign(stop.side == BumpStop::Side::compression ? -1.0 : 1.0);
  const LocalLine<T> line = local_line(work, stop.from, stop.to, -1);
  return scalar_element(
      work, line.coordinate, line.length, line.rate, expressions_of(stop.force), [&](const S& length, const S& rate) {
        return -(sign * bump_stop_law(work, stop, S(sign * (length - S(line.reference))), S(sign * rate)).force);
      });
}

template <class T>
void bump_stop_tangents(ForceWork<T>& work, std::vector<ElementTangents<T>>& elements) {
  for (const BumpStop& stop : work.system.model.bump_stops) {
    const auto heading = work.system.scribe.within(OwnerKind::bump_stop, index_in(work.system.model.bump_stops, stop));
    elements.push_back(bump_stop_element(work, stop));
  }
}

}  // namespace detail
}  // namespace mbgen
