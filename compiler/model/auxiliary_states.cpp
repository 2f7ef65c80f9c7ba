#include "compiler/model/auxiliary_states.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "compiler/model/element_access.hpp"

namespace mbgen {
namespace {

constexpr double kSlipOfRadius = 0.1;  // of a tyre's radius: typical size of its slip states
constexpr double kTurn = 0.01;         // rad: typical rotation of a contact patch before sliding
constexpr int kSlipsOfTyre = 2;

AuxiliaryState hidden(const std::string& name, const std::string& unit, double size) {
  return {name, unit, unit + "/s", "auxiliary state", 0, {}, size};
}

/// Unit of the coordinate that an element acts on, "m" without one. Units are needed while a model is read: a reference
/// to a coordinate may be invalid.
const char* unit_of_place(const Model& model, const Connection& connection) {
  const OnCoordinate* on = std::get_if<OnCoordinate>(&connection);
  return !on ? "m" : on->joint.joint < 0 ? "" : unit_of(freedom_of(model, on->joint).kind);
}

/// Number of states of a nature.
int states_by_nature(const Model& model, StateNature nature) {
  int count = 0;
  StatefulKinds::each([&](auto kind) {
    if (kind.nature == nature)
      for (const auto& element : kind.list(model)) count += state_count(element);
  });
  return count;
}

/// A value of the user's own; all without unit are numbers.
template <class Value>
AuxiliaryState own(const Value& value, const std::string& name, const char* kind) {
  const bool has_unit = !value.unit.empty() && value.unit != "1";
  const std::string& description = value.shown.description;
  return {name,
          has_unit ? value.unit : "1",
          has_unit ? value.unit + "/s" : "1/s",
          description.empty() ? kind : description,
          value.initial,
          value.shown.nominal,
          1};
}

}  // namespace

std::vector<AuxiliaryState> auxiliary_states(const Model& model) {
  std::vector<AuxiliaryState> states;
  for (const Tyre& tyre : model.tyres) {
    for (const char* suffix : {"_u", "_v"})
      states.push_back(hidden(tyre.name + suffix, "m", kSlipOfRadius * tyre.radius.value));
  }
  for (const Tyre& tyre : model.tyres)
    if (tyre.parking) states.push_back(hidden(tyre.name + "_turn", "rad", kTurn));
  StatefulKinds::each([&](auto kind) {
    for (const auto& element : kind.list(model))
      kind.states(element, [&](const HiddenState& state) {
        const char* unit = state.unit ? state.unit : unit_of_place(model, connection_of(element));
        states.push_back(hidden(element.name + state.suffix, unit, state.size));
      });
  });
  for (const UserState& state : model.states) states.push_back(own(state, state.name, "state"));
  for (const SampledValue& value : model.sampled) states.push_back(own(value, value.name, "sampled value"));
  for (const SampledValue& value : model.sampled)
    for (int k = 1; k <= value.delay; ++k)
      states.push_back(own(value, value.name + "_in" + std::to_string(k), "sampled value that waits"));
  return states;
}

int auxiliary_state_count(const Model& model) {
  return first_user_state(model) + static_cast<int>(model.states.size()) + held_state_count(model);
}

int first_turn(const Model& model) { return kSlipsOfTyre * static_cast<int>(model.tyres.size()); }

int turn_state(const Model& model, std::size_t tyre) {
  const auto has_turn = [](const Tyre& t) { return t.parking.has_value(); };
  const auto before = std::ranges::count_if(std::span(model.tyres).first(tyre), has_turn);
  return first_turn(model) + static_cast<int>(before);
}

int first_bristle(const Model& model) {
  return turn_state(model, model.tyres.size()) + states_by_nature(model, StateNature::slip);
}

int slip_state_count(const Model& model) {
  return first_bristle(model) + states_by_nature(model, StateNature::bristle);
}

std::vector<std::string> auxiliary_state_names(const Model& model) {
  std::vector<std::string> names;
  for (AuxiliaryState& state : auxiliary_states(model)) names.push_back(std::move(state.name));
  return names;
}

std::vector<double> initial_auxiliary_states(const Model& model) {
  std::vector<double> values;
  for (const AuxiliaryState& state : auxiliary_states(model)) values.push_back(state.initial);
  return values;
}

int first_user_state(const Model& model) {
  return slip_state_count(model) + states_by_nature(model, StateNature::relaxing);
}

int first_sampled_value(const Model& model) { return first_user_state(model) + static_cast<int>(model.states.size()); }

int held_state_count(const Model& model) {
  int count = 0;
  for (const SampledValue& value : model.sampled) count += 1 + value.delay;
  return count;
}

bool takes_reactions(const Model& model) {
  return std::ranges::any_of(model.sampled, [&](const SampledValue& sampled) {
    const int expression = sampled.value.expression;
    return sampled.load ||
           (expression >= 0 &&
            round_after(model, model.expressions[static_cast<std::size_t>(expression)]) == kAfterForces);
  });
}

double magnitude_of(const AuxiliaryState& state) {
  const double size = state.nominal.value_or(std::abs(state.initial));
  return size > 0 ? size : state.size;
}

}  // namespace mbgen
