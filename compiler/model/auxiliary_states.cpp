#include "compiler/model/auxiliary_states.hpp"

#include <cmath>

namespace mbgen {
namespace {

constexpr int kStatesOfTyre = 2;

AuxiliaryState slip_of(const std::string& name) { return {name, "m", "m/s", "auxiliary state", 0, {}}; }

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
          value.shown.nominal};
}

}  // namespace

std::vector<AuxiliaryState> auxiliary_states(const Model& model) {
  std::vector<AuxiliaryState> states;
  for (const Tyre& tyre : model.tyres) {
    states.push_back(slip_of(tyre.name + "_u"));
    states.push_back(slip_of(tyre.name + "_v"));
  }
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

int first_user_state(const Model& model) { return kStatesOfTyre * static_cast<int>(model.tyres.size()); }

int held_state_count(const Model& model) {
  int count = 0;
  for (const SampledValue& value : model.sampled) count += 1 + value.delay;
  return count;
}

double magnitude_of(const AuxiliaryState& state) {
  const double size = state.nominal.value_or(std::abs(state.initial));
  return size > 0 ? size : 1;
}

}  // namespace mbgen
