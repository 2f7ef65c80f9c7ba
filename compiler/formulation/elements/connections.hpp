#pragma once
// Connections of elements with a law over one scalar: position and rate, loads on the bodies of a force against it, and
// derivatives by the tree's coordinates. A kind of such elements defines
//   connect(work, element, use)     calls use(connection) with its connection
//   law_of(work, element, at)       its law there: function of (position, rate), of T or of Slope<T>; the force against
//                                   the position, N or N m, or a struct with the force as `resistance`
//   law_expressions(work, element)  expressions in its law, see LawElement; default: all of its fields
//   seen_as(element, at, acting)    its quantities, for a kind with quantities
// and the drivers below compute its forces and tangents from them.

#include <utility>

#include "compiler/formulation/elements/element_tangents.hpp"
#include "compiler/model/element_access.hpp"

namespace mbgen {
namespace detail {

/// A coordinate, or its difference to another one; rad or m. sign: 1 or -1 for a sense of the element's own, else 0.
template <class T>
struct AlongCoordinate {
  CoordinateReference joint;
  std::optional<CoordinateReference> relative_to;
  int sign = 0;
  T position, rate;

  AlongCoordinate(const System<T>& system, const CoordinateReference& of,
                  const std::optional<CoordinateReference>& less)
      : joint(of), relative_to(less), position(system.environment.position(of)), rate(system.environment.velocity(of)) {
    if (!relative_to) return;
    position = position - system.environment.position(*relative_to);
    rate = rate - system.environment.velocity(*relative_to);
  }
  AlongCoordinate(const System<T>& system, const CoordinateReference& of,
                  const std::optional<CoordinateReference>& less, int counts)
      : AlongCoordinate(system, of, less) {
    sign = counts;
    position = T(sign) * position;
    rate = T(sign) * rate;
  }

  void resist(ForceWork<T>& work, const T& force) const {
    add_joint_force(work, joint, sign == 0 ? -force : T(-sign) * force);
    if (relative_to) add_joint_force(work, *relative_to, sign == 0 ? force : T(sign) * force);
  }
  LocalCoordinate<T> row(const ForceWork<T>& work) const {
    LocalCoordinate<T> along = tree_local(work.system, joint);
    if (relative_to || sign != 0) along.shared = -1;
    if (sign != 0)
      for (T& entry : along.row) entry = Slope<T>::times(T(sign), entry);
    if (!relative_to) return along;
    if (const int other = tree_coordinate(work.system.topology, *relative_to); other >= 0)
      along.row[other] = along.row[other] - T(sign == 0 ? 1.0 : sign);
    return along;
  }
};

/// Displacement of `to` along an axis fixed to the body of `from`, zero at the reference, m.
template <class T>
struct AlongAxis {
  const Attachment &from, &to;
  SeenPlace<T> seen;
  Vector<T> axis;  ///< in the axes of the body of `from`
  T position, rate;

  AlongAxis(const ForceWork<T>& work, const Attachment& a, const Attachment& b, const Vector<T>& direction)
      : from(a), to(b), seen(seen_place(work, a, b)), axis(direction) {
    const auto reference = [&](const Attachment& at, const Place<T>& place) {
      return place.at + carrier_origin(work.system.topology, work.system.constants, at.body);
    };
    position = dot(axis, seen.gap - (reference(to, seen.to) - reference(from, seen.from)));
    rate = dot(axis, seen.drift);
  }

  void resist(ForceWork<T>& work, const T& force) const {
    act_between(work, from, to, seen, force * axis, Vector<T>{});
  }
  LocalCoordinate<T> row(const ForceWork<T>& work) const { return {row_between(work, seen, axis, Vector<T>{})}; }
};

/// Number of an element's length in expressions.
template <class Kind>
int line_number(const Model& model, const Kind& element) {
  int number = 0;
  bool is_before = true;
  each_kind([&](auto kind) {
    if constexpr (std::is_same_v<typename decltype(kind)::Element, Kind>) is_before = false;
    if (is_before && kind.has_length) number += static_cast<int>(kind.list(model).size());
  });
  return number + static_cast<int>(index_in(KindOf<Kind>::list(model), element));
}

template <class T, class Kind>
std::vector<int> law_expressions(const ForceWork<T>&, const Kind& element) {
  std::vector<int> expressions;
  each_expression(element, [&](int expression) { expressions.push_back(expression); });
  return expressions;
}

/// The force of a law against the position.
template <class A>
const A& resistance_in(const A& force) {
  return force;
}
template <class Acting>
requires requires(const Acting& acting) { acting.resistance; }
const auto& resistance_in(const Acting& acting) { return acting.resistance; }

/// Quantities of an element between two points with no others.
template <class T, class Kind>
requires std::is_same_v<typename StateOf<Kind>::template type<T>, ElementState<T>> ElementState<T> seen_as(
    const Kind&, const AlongLine<T>& at, const T& tension) {
  ElementState<T> state;
  state.length = at.position;
  state.rate = at.rate;
  state.force = tension;
  return state;
}

template <class T, class Kind>
concept HasScalarLaw = requires(ForceWork<T>& work, const Kind& element) {
  connect(work, element, [](const auto&) {});
};

/// Names the line of an element in programs for reading.
template <class T>
void detail_connection(const ForceWork<T>& work, const AlongLine<T>& at, const std::string& element) {
  const System<T>& system = work.system;
  Annotator<T>& annotator = work.system.annotator;
  if (!annotator.has_details()) return;
  const Line<T>& line = at.line;
  const auto end = [&](const Place<T>& place, const char* which) {
    const Vector<T> own =
        velocity_at(velocity_of(system, work.v, place.body), arm_of(system, work.k, place, work.v.about));
    if (place.body != kGround)
      detail_name(annotator, direction_in(system, work.k, place.body, place.at, line.frame), "arm_", element, which);
    detail_name(annotator, position_in(system, work.k, place, line.frame), "place_", element, which);
    const Vector<T> velocity = velocity_in(system, work.k, work.v, place, line.frame);
    detail_name(annotator, velocity, "velocity_", element, which);
    detail_name(annotator, own, "velocity_", element, which, "_own");
    return velocity;
  };
  const Vector<T> from = end(line.from, "_from"), to = end(line.to, "_to");
  detail_name(annotator, line.gap, "gap_", element);
  detail_name(annotator, to - from, "vgap_", element);
  annotator.detail(line.reciprocal, "per_length_", element);
}

/// Names the displacement of an element along its axis in programs for reading.
template <class T>
void detail_connection(const ForceWork<T>& work, const AlongAxis<T>& at, const std::string& element) {
  detail_name(work.system.annotator, at.seen.gap, "gap_", element);
  detail_name(work.system.annotator, at.seen.drift, "vgap_", element);
}

/// A coordinate has its names already.
template <class T>
void detail_connection(const ForceWork<T>&, const AlongCoordinate<T>&, const std::string&) {}

/// Names the force of an element with a scalar law in programs for reading. force: against its position.
template <class T, class At>
void detail_force(const ForceWork<T>& work, const At& at, const T& force, const std::string& element) {
  work.system.annotator.detail(force, "force_", element);
  if constexpr (requires { at.line; })
    if (work.system.annotator.has_details())
      work.system.annotator.detail(force * at.line.reciprocal, "density_", element);
}

/// Forces of an element with a scalar law.
template <class T, class Kind>
requires HasScalarLaw<T, Kind>
void apply(ForceWork<T>& work, const Kind& element) {
  connect(work, element, [&](const auto& at) {
    detail_connection(work, at, element.name);
    work.system.annotator.detail(at.position, "length_", element.name);
    work.system.annotator.detail(at.rate, "rate_", element.name);
    const auto acting = law_of(work, element, at)(at.position, at.rate);
    detail_force(work, at, resistance_in(acting), element.name);
    at.resist(work, resistance_in(acting));
    if constexpr (requires { seen_as(element, at, acting); })
      state_for(work.system, work.forces, element) = seen_as(element, at, acting);
  });
}

/// Tangents of an element with a scalar law.
template <class T, class Kind>
requires HasScalarLaw<T, Kind>
void add_tangents(ForceWork<T>& work, const Kind& element, std::vector<ElementTangents<T>>& elements) {
  using S = Slope<T>;
  connect(work, element, [&](const auto& at) {
    LocalCoordinate<T> row = at.row(work);
    const auto law = law_of(work, element, at);
    elements.push_back(
        scalar_element(work, std::move(row), at.position, at.rate, law_expressions(work, element),
                       [&](const S& position, const S& rate) { return -resistance_in(law(position, rate)); }));
  });
}

}  // namespace detail
}  // namespace mbgen
