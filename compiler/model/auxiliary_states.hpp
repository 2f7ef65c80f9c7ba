#pragma once
// Auxiliary states of a model, in their order: two slip deflections per tyre (m), the turn of each tyre whose patch has
// a moment against turning (rad), the deflection of each bristle of a friction (rad or m, those on coordinates first),
// the extension of the spring of each Maxwell branch of a six-freedom element (m or rad), the states of the user's own,
// the sampled values, those of the user before the loads that press frictions, and what sampled values with a delay
// will be.

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
  std::optional<double> nominal;  ///< usual magnitude, where the model says it
  double size = 1;                ///< usual magnitude where neither that nor the initial value tells it
};

std::vector<AuxiliaryState> auxiliary_states(const Model& model);

int auxiliary_state_count(const Model& model);

/// Number of the first of them that are slips and turns of tyres and bristles of frictions. At rest these hold by
/// themselves; the others then have the values at which their rates vanish.
int slip_state_count(const Model& model);

/// Place of the first extension of the Maxwell branches of an element of six freedoms; they follow element by element.
int first_extension(const Model& model, std::size_t element);

/// Names of the auxiliary states.
std::vector<std::string> auxiliary_state_names(const Model& model);

/// Values of the auxiliary states at the start.
std::vector<double> initial_auxiliary_states(const Model& model);

/// Place of the first state of the user's own; sampled values follow them.
int first_user_state(const Model& model);

/// Place of the first sampled value.
int first_sampled_value(const Model& model);

/// How many of the last auxiliary states hold between the instants at which they are set: sampled values.
int held_state_count(const Model& model);

/// Whether a sampled value is the load of a reaction, so that to set it takes accelerations and multipliers.
bool takes_reactions(const Model& model);

/// Size of a state that counts as much as 1 rad or 1 m of a coordinate: in searches, differences and tolerances. Its
/// nominal value, else its initial one, else what slips, bristles and Maxwell branches reach, else 1.
double magnitude_of(const AuxiliaryState& state);

/// The first turn of the tyres, behind their slips, and that of a tyre. Requires: this tyre has one.
int first_turn(const Model& model);
int turn_state(const Model& model, std::size_t tyre);

/// The first state of the bristles, and the state of a friction. Requires: it is one of the model's; where it has no
/// bristles its state is that of the next.
int first_bristle(const Model& model);
std::size_t bristle_state(const Model& model, const FrictionLaw& friction);

}  // namespace mbgen
