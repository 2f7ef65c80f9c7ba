#pragma once
// The door of the schedule room: the last decisions about a program: the order of its values, calls for many arguments,
// loops over equal subsystems, and its division into functions. Whoever writes it decides nothing more.

#include <cstddef>
#include <limits>
#include <set>

#include "compiler/program/program.hpp"
#include "compiler/schedule/scheduled_program.hpp"

namespace mbgen {

struct ScheduleOptions {
  Division division = Division::cheapest;
  ValueOrder order = ValueOrder::by_section;
  /// Operations and outputs, together, above which equal subsystems become loops when that saves half of the text.
  std::size_t roll_above = std::numeric_limits<std::size_t>::max();
  std::set<SlotGroup> indexed = {};  ///< groups whose slots are an array in the text, see roll
  bool shares_places = false;        ///< a value that crosses parts takes the place of one that no later part needs
  Gathering gathering = Gathering::in_lanes;  ///< of elementary functions into calls
};

/// Whether loops over equal subsystems are worth it.
bool is_rolled(const Program& program, const ScheduleOptions& options);

/// Schedules a program.
/// Straight code: the order that is asked for, with the cosine of an angle right after its sine (or the other way
/// round) where both are in one section; then gather_calls. The cheapest division has the fewest values that cross from
/// one part to the next; a cut inside a section counts as kSectionCost more values, one between the two functions of an
/// angle or inside a call for many arguments is never made. Results of such a call are in memory anyway and do not
/// count as crossing. Loops: those of roll, in the order of the program, without calls for many arguments. Values that
/// cross slices, loops or parts stand in one array, those of a slice side by side. The rule for loops is in
/// docs/evidence/growth.md.
Schedule schedule(const Program& program, const ScheduleOptions& options = {});

}  // namespace mbgen
