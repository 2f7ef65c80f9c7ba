// The user's states, and values set at instants of time.
#include "compiler/reader/read_states.hpp"

#include <fmt/format.h>

#include <cmath>
#include <set>

#include "compiler/expressions/named_functions.hpp"
#include "compiler/model/auxiliary_states.hpp"
#include "compiler/reader/presentation.hpp"
#include "compiler/reader/raw.hpp"
#include "compiler/reader/reaction_loads.hpp"
#include "compiler/reader/reader.hpp"

namespace mbgen::reading {
namespace {

constexpr double kLongestDelay = 1000;  ///< instants; each is an auxiliary state

void name_entries(Reader& reader, const Entries& entries) {
  for (const Entry& entry : entries) {
    const InScope in_scope(reader, entry.scope);
    check_value_name(reader, entry);
    reader.names.values.emplace(entry.name, static_cast<int>(reader.names.values.size()));
  }
}

int read_delay(Reader& reader, const Value& value, const SampledValueFields& sampled) {
  const double delay = sampled.written_delay;
  if (std::isnan(delay) || delay < 0) return 0;
  if (delay == std::nearbyint(delay) && delay <= kLongestDelay) return static_cast<int>(delay);
  report(reader, *find(value, "delay"),
         fmt::format("must be a whole number of instants, 0 to {:g}, got {:g}", kLongestDelay, delay));
  return 0;
}

/// Source of a sampled value that is a reaction.
void read_source(Reader& reader, const Value& value, SampledValueFields& one) {
  if (one.written && one.reaction) {
    report(reader, *find(value, "reaction"), "sampled value has both \"value\" and \"reaction\"",
           "leave out one of them");
  } else if (one.reaction) {
    one.load = read_reaction(reader, value, one);
    if (one.unit.empty()) one.unit = unit_of(*one.load);
  } else if (!one.written) {
    report(reader, value, "key \"value\" is missing", "or \"reaction\" for the load of a joint or rod");
  }
}

/// Reads the expressions, after all initial values. written: of each element of `list` from `first` on.
template <class Element>
void read_expressions(Reader& reader, const Entries& entries, const std::vector<const Value*>& written,
                      const FieldInfo& info, Quantity Element::*target, std::vector<Element>& list,
                      std::size_t first = 0) {
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const InScope in_scope(reader, entries[i].scope);
    Quantity value;
    if (written[i]) read_value(reader, *written[i], info, value);
    if (written[i]) list[first + i].*target = value;
  }
}

}  // namespace

void check_value_name(Reader& reader, const Entry& entry) {
  const Names& names = reader.names;
  const char* other = names.parameters.contains(entry.name)     ? "a parameter"
                      : names.inputs.contains(entry.name)       ? "an input"
                      : names.values.contains(entry.name)       ? "a state or sampled value"
                      : names.named_values.contains(entry.name) ? "a delayed or named value"
                                                                : nullptr;
  if (is_reserved_name(entry.name) || is_reserved_name(entry.written)) {
    report(reader, entry.place, "name " + in_quotes(entry.written) + " is reserved, expressions use it");
  } else if (other) {
    report(reader, entry.place, in_quotes(entry.name) + " is the name of " + other + ", too", "rename one of them");
  }
}

void read_states(Reader& reader, const StateEntries& entries) {
  const Entries &states = entries.states, &sampled = entries.sampled;
  name_entries(reader, states);
  name_sensors(reader, entries.sensors, entries.delays);
  name_entries(reader, sampled);
  std::vector<UserStateFields> state_fields;
  read_list(reader, states, state_fields, [](Reader& r, const Value& value, UserStateFields& state) {
    check_presentation(r, value, state.unit, state, state.initial);
  });
  std::vector<SampledValueFields> sampled_fields;
  read_list(reader, sampled, sampled_fields, [](Reader& r, const Value& value, SampledValueFields& one) {
    check_presentation(r, value, one.unit, one, one.initial);
    one.delay = read_delay(r, value, one);
    read_source(r, value, one);
  });
  std::vector<const Value*> derivatives, values;
  for (UserStateFields& state : state_fields) {
    state.shown = state;
    derivatives.push_back(state.written);
    reader.model.states.push_back(std::move(state));
  }
  read_sensors(reader, entries.values, entries.sensors, entries.delays);
  const std::size_t before = reader.model.sampled.size();
  for (SampledValueFields& one : sampled_fields) {
    one.shown = one;
    values.push_back(one.written);
    reader.model.sampled.push_back(std::move(one));
  }
  reader.own_sampled = reader.model.sampled.size();
  read_expressions(reader, states, derivatives, {.name = "derivative"}, &UserState::derivative, reader.model.states);
  read_expressions(reader, sampled, values, {.name = "value", .sees_accelerations = true}, &SampledValue::value,
                   reader.model.sampled, before);
}

void check_state_names(Reader& reader, const StateEntries& entries) {
  const std::vector<std::string> all = auxiliary_state_names(reader.model);
  const auto own = all.begin() + first_user_state(reader.model);
  std::set<std::string> others(all.begin(), own);
  others.insert(own + static_cast<std::ptrdiff_t>(entries.states.size() + reader.own_sampled), all.end());
  for (const Entries* of : {&entries.states, &entries.sensors, &entries.delays, &entries.sampled})
    for (const Entry& entry : *of) {
      const InScope in_scope(reader, entry.scope);
      if (others.contains(entry.name))
        report(reader, entry.place, in_quotes(entry.name) + " is the name of another auxiliary state, too",
               "rename it: tyres have NAME_u and NAME_v, loads NAME_load, delays NAME_in1 and so on");
    }
}

}  // namespace mbgen::reading
