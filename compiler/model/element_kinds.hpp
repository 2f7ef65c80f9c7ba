#pragma once
// List of the kinds of elements, for all loops over elements. Forces are added in its order, which changes the bits of
// emitted code.

#include <string_view>
#include <type_traits>

#include "compiler/model/elements/actuator.hpp"
#include "compiler/model/elements/air_spring.hpp"
#include "compiler/model/elements/applied_force.hpp"
#include "compiler/model/elements/bump_stop.hpp"
#include "compiler/model/elements/bushing.hpp"
#include "compiler/model/elements/contact.hpp"
#include "compiler/model/elements/friction.hpp"
#include "compiler/model/elements/joint_force.hpp"
#include "compiler/model/elements/joint_spring.hpp"
#include "compiler/model/elements/point_spring.hpp"
#include "compiler/model/elements/rope.hpp"
#include "compiler/model/elements/tyre.hpp"

namespace mbgen {

template <class... Kind>
struct Kinds {
  static constexpr int count = sizeof...(Kind);
  template <class Use>
  static constexpr void each(const Use& use) {
    (use(KindOf<Kind>{}), ...);
  }
  /// Index in the list, `count` for a type not in it.
  template <class Element>
  static constexpr int index_of() {
    int index = 0;
    static_cast<void>(((std::is_same_v<Element, Kind> ? false : (++index, true)) && ...));
    return index;
  }
};

using ElementKinds = Kinds<PointSpring, AirSpring, JointSpring, JointFriction, SpringFriction, RodFriction, JointForce,
                           AppliedForce, Tyre, Bushing, BumpStop, Rope, SurfaceContact, Actuator>;

/// Kinds with auxiliary states besides tyres, in the order of these: by nature.
using StatefulKinds = Kinds<Rope, JointFriction, SpringFriction, RodFriction, SurfaceContact, Bushing>;

/// Index of a kind in the list.
template <class Element>
requires(ElementKinds::index_of<Element>() <
         ElementKinds::count) constexpr int kKindIndex = ElementKinds::index_of<Element>();

/// Calls use(KindOf<Kind>{}) for every kind.
template <class Use>
constexpr void each_kind(const Use& use) {
  ElementKinds::each(use);
}

/// Calls use(KindOf<Kind>{}) for the kind at an index of the list, for none at -1.
template <class Use>
void with_kind(int index, const Use& use) {
  int next = 0;
  each_kind([&](auto kind) {
    if (next++ == index) use(kind);
  });
}

/// Calls use(element) for every element of a model, in the order of the list.
template <class SomeModel, class Use>
void each_element(SomeModel& model, const Use& use) {
  each_kind([&](auto kind) {
    for (auto& element : kind.list(model)) use(element);
  });
}

/// Calls use(element) for the elements and rods with lengths in expressions, in the order of their numbers there.
template <class SomeModel, class Use>
void each_line(SomeModel& model, const Use& use) {
  each_kind([&](auto kind) {
    if constexpr (kind.has_length)
      for (auto& element : kind.list(model)) use(element);
  });
  for (auto& rod : model.rods) use(rod);
}

/// Number of kinds with lengths before one.
template <class Kind>
constexpr std::size_t length_place() {
  std::size_t place = 0;
  bool is_before = true;
  each_kind([&](auto other) {
    is_before = is_before && !std::is_same_v<typename decltype(other)::Element, Kind>;
    if (is_before && other.has_length) ++place;
  });
  return place;
}

template <class Element>
Connection connection_of(const Element& element) {
  return KindOf<Element>::connection(element);
}

/// Whether a rig can remove elements of a kind.
template <class Kind>
constexpr bool can_be_silent(Kind kind) {
  return requires(typename Kind::Element & element) { kind.silence(element); };
}

/// Name of the output field for an element of a kind.
template <class Kind>
constexpr std::string_view source_key(Kind) {
  return Kind::source ? Kind::source : Kind::key;
}

/// Index of a quantity in the table of its kind, -1 for a quantity not in it.
template <class Kind>
constexpr int quantity_index(Kind, std::string_view name) {
  for (std::size_t i = 0; i < Kind::quantities.size(); ++i)
    if (Kind::quantities[i].name == name) return static_cast<int>(i);
  return -1;
}

}  // namespace mbgen
