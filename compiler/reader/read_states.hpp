#pragma once
// States of the user's own, sampled values, and all that is put together from them.

#include "compiler/reader/reader.hpp"

namespace mbgen::reading {

/// States, sampled values, and all that is put together from them.
struct StateEntries {
  Entries states, values, sensors, delays, sampled;
};
void read_states(Reader& reader, const StateEntries& entries);
/// Reports a name that expressions know already.
void check_value_name(Reader& reader, const Entry& entry);
/// Makes the sampled values of sensors and delays known to expressions.
void name_sensors(Reader& reader, const Entries& sensors, const Entries& delays);
/// Expressions under a name, each after the ones that it uses. Reports values that use themselves.
void read_named_values(Reader& reader, const Entries& entries);
/// Named values, then the sampled values of sensors and delays.
void read_sensors(Reader& reader, const Entries& values, const Entries& sensors, const Entries& delays);
/// Reports states with the name of another auxiliary state. Requires: tyres are read.
void check_state_names(Reader& reader, const StateEntries& entries);

}  // namespace mbgen::reading
