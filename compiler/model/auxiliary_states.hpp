#pragma once
// Auxiliary states of a model, in their order: two slip deflections per tyre (m), the rotation of each tyre with a
// moment of its patch against turning (rad), the states of other elements by StatefulKinds, the user's states, the
// sampled values (the user's before loads of frictions), and the pending values of sampled values with a delay.

#include <optional>
#include <string>
#include <vector>

#include "compiler/model/model.hpp"

namespace mbgen {

struct AuxiliaryState {
  std::string name;
  std::string unit, rate_unit;
  std::string description;
  double initial = 0;
  std::optional<double> nominal;  ///< typical magnitude given by the model
  double size = 1;                ///< typical magnitude if neither `nominal` nor the initial value gives one
};

std::vector<AuxiliaryState> auxiliary_states(const Model& model);

int auxiliary_state_count(const Model& model);

/// Number of leading states that are slips and rotations of tyres, and slips and bristles of other elements. At rest
/// these keep any value; the others then have the values at which their rates are zero.
int slip_state_count(const Model& model);

/// Names of the auxiliary states.
std::vector<std::string> auxiliary_state_names(const Model& model);

/// Values of the auxiliary states at the start.
std::vector<double> initial_auxiliary_states(const Model& model);

/// Position of the user's first state; sampled values follow them.
int first_user_state(const Model& model);

/// Position of the first sampled value.
int first_sampled_value(const Model& model);

/// Number of trailing auxiliary states that are constant between the instants at which they are set: sampled values.
int held_state_count(const Model& model);

/// Whether a sampled value is the load of a reaction or looks at an output over accelerations; setting it then needs
/// accelerations and multipliers.
bool takes_reactions(const Model& model);

/// Magnitude of a state equivalent to 1 rad or 1 m of a coordinate in searches, differences and tolerances: its nominal
/// value, else its initial one, else the typical size of an element's state, else 1.
double magnitude_of(const AuxiliaryState& state);

/// The first rotation state of the tyres, after their slips, and the one of a tyre. Requires: this tyre has one.
int first_turn(const Model& model);
int turn_state(const Model& model, std::size_t tyre);

/// The first state of the bristles.
int first_bristle(const Model& model);

template <class Element>
int state_count(const Element& element) {
  int count = 0;
  KindOf<Element>::states(element, [&](const HiddenState&) { ++count; });
  return count;
}

/// The first state of an element by its index among its kind; its states follow one another. Without states: the place
/// of the next ones.
template <class Element>
int first_state(const Model& model, std::size_t element) {
  int place = turn_state(model, model.tyres.size());
  bool is_before = true;
  StatefulKinds::each([&](auto kind) {
    const auto& list = kind.list(model);
    const bool is_own = std::is_same_v<typename decltype(kind)::Element, Element>;
    const std::size_t end = is_own ? element : list.size();
    for (std::size_t i = 0; is_before && i < end; ++i) place += state_count(list[i]);
    is_before = is_before && !is_own;
  });
  return place;
}

/// The first state of an element. Requires: it is in its list in the model.
template <class Element>
std::size_t state_of_element(const Model& model, const Element& element) {
  const auto index = static_cast<std::size_t>(&element - KindOf<Element>::list(model).data());
  return static_cast<std::size_t>(first_state<Element>(model, index));
}

}  // namespace mbgen
