#pragma once
// Auxiliary states of a model, in their order: two slip deflections per tyre (m), the rotation of each tyre with a
// moment of its patch against turning (rad), the slip of each rope in a groove with friction (m), the deflection of
// each bristle of a friction (rad or m, frictions on coordinates first), two deflections of bristles per contact with
// friction (m), the extension of the spring of each Maxwell branch of a six-freedom element (m or rad), the user's
// states, the sampled values (the user's before loads of frictions), and the pending values of sampled values with a
// delay.

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

/// Number of leading states that are slips and rotations of tyres, slips of ropes or bristles of frictions and
/// contacts. At rest these keep any value; the others then have the values at which their rates are zero.
int slip_state_count(const Model& model);

/// Position of the first extension of the Maxwell branches of a six-freedom element; the elements follow one another.
int first_extension(const Model& model, std::size_t element);

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
/// value, else its initial one, else the typical size of slips, bristles and Maxwell branches, else 1.
double magnitude_of(const AuxiliaryState& state);

/// The first rotation state of the tyres, after their slips, and the one of a tyre. Requires: this tyre has one.
int first_turn(const Model& model);
int turn_state(const Model& model, std::size_t tyre);

/// The first slip of a rope in a groove; its grooves with friction follow one another along its path.
int first_slip(const Model& model, std::size_t rope);

/// The first state of the bristles, and the state of a friction. Requires: a friction of the model; without bristles
/// the result is the state of the next friction.
int first_bristle(const Model& model);
std::size_t bristle_state(const Model& model, const FrictionLaw& friction);

/// The first of the two bristles of a contact (index into Model::contacts), after those of frictions. Requires: the
/// contact has friction.
int contact_state(const Model& model, std::size_t contact);

}  // namespace mbgen
