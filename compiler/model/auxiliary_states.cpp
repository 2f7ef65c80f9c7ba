#include "compiler/model/auxiliary_states.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "compiler/model/element_access.hpp"

namespace mbgen {
namespace {

constexpr double kSlipOfRadius = 0.1;  // of a tyre's radius: typical size of its slip states
constexpr double kExtension = 1e-3;    // m or rad, of the spring of a Maxwell branch
constexpr double kBristle = 1e-4;      // m or rad: typical deflection of bristles before sliding
constexpr double kTurn = 0.01;         // rad: typical rotation of a contact patch before sliding
constexpr double kRopeSlip = 1e-3;     // m: typical slip of a rope in a groove
constexpr int kSlipsOfTyre = 2;
constexpr int kBristlesOfContact = 2;

AuxiliaryState hidden(const std::string& name, const std::string& unit, double size) {
  return {name, unit, unit + "/s", "auxiliary state", 0, {}, size};
}

/// Units are needed while a model is read: a reference to a coordinate may be invalid.
const char* unit_of_coordinate(const Model& model, const CoordinateReference& coordinate) {
  return coordinate.joint < 0 ? "" : unit_of(freedom_of(model, coordinate).kind);
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
  for (const Rope& rope : model.ropes)
    for (int i = 0; i < rubbing_grooves(rope); ++i)
      states.push_back(hidden(rope.name + "_slip" + std::to_string(i + 1), "m", kRopeSlip));
  each_friction(model, [&](const auto& friction) {
    if (!friction.has_bristle()) return;
    const Connection connection = connection_of(friction);
    const OnCoordinate* on = std::get_if<OnCoordinate>(&connection);
    states.push_back(hidden(friction.name + "_bristle", on ? unit_of_coordinate(model, on->joint) : "m", kBristle));
  });
  for (const SurfaceContact& contact : model.contacts)
    for (const char* suffix : {"_bristle1", "_bristle2"})
      if (contact.has_friction()) states.push_back(hidden(contact.name + suffix, "m", kBristle));
  for (const Bushing& bushing : model.bushings) {
    for (int i = 0; i < kBushingFreedoms; ++i) {
      if (!has_maxwell_branch(bushing, i)) continue;
      const std::string name(kBushingFreedomNames[static_cast<std::size_t>(i)]);
      states.push_back(hidden(bushing.name + "_" + name, i < 3 ? "m" : "rad", kExtension));
    }
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

int first_turn(const Model& model) { return kSlipsOfTyre * static_cast<int>(model.tyres.size()); }

int turn_state(const Model& model, std::size_t tyre) {
  const auto has_turn = [](const Tyre& t) { return t.parking.has_value(); };
  const auto before = std::ranges::count_if(std::span(model.tyres).first(tyre), has_turn);
  return first_turn(model) + static_cast<int>(before);
}

int first_slip(const Model& model, std::size_t rope) {
  int place = turn_state(model, model.tyres.size());
  for (std::size_t i = 0; i < rope; ++i) place += rubbing_grooves(model.ropes[i]);
  return place;
}

int first_bristle(const Model& model) { return first_slip(model, model.ropes.size()); }

std::size_t bristle_state(const Model& model, const FrictionLaw& friction) {
  auto state = static_cast<std::size_t>(first_bristle(model));
  bool is_before = true;
  each_friction(model, [&](const FrictionLaw& other) {
    is_before = is_before && &other != &friction;
    if (is_before && other.has_bristle()) ++state;
  });
  return state;
}

int contact_state(const Model& model, std::size_t contact) {
  int state = first_bristle(model);
  each_friction(model, [&](const FrictionLaw& friction) { state += friction.has_bristle() ? 1 : 0; });
  const auto has_friction = [](const SurfaceContact& c) { return c.has_friction(); };
  const auto before = std::ranges::count_if(std::span(model.contacts).first(contact), has_friction);
  return state + kBristlesOfContact * static_cast<int>(before);
}

int slip_state_count(const Model& model) { return contact_state(model, model.contacts.size()); }

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

int first_extension(const Model& model, std::size_t bushing) {
  int place = slip_state_count(model);
  for (std::size_t b = 0; b < bushing; ++b) place += maxwell_branches(model.bushings[b]);
  return place;
}

int first_user_state(const Model& model) { return first_extension(model, model.bushings.size()); }

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
