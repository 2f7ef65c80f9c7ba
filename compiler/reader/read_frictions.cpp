// Friction on coordinates and along springs.

#include <fmt/format.h>

#include "compiler/reader/output_sources.hpp"
#include "compiler/reader/raw.hpp"
#include "compiler/reader/reaction_loads.hpp"
#include "compiler/reader/reader.hpp"

namespace mbgen::reading {
namespace {

constexpr double kStribeckOverVelocity = 10;

/// Complains about fields that the law does not have, and about one that it needs and has not.
void check_law(Reader& reader, const Value& value, const FrictionFields& friction) {
  const bool bristle = friction.has_bristle();
  const auto refuse_field = [&](std::string_view key, const char* law) {
    if (const Value* member = find(value, key))
      report(reader, *member, fmt::format("{} is of friction with law {}", in_quotes(key), law),
             "leave it out, or give \"law\"");
  };
  if (bristle) {
    refuse_field("velocity", "smooth");
  } else {
    for (const std::string_view key : {"stiffness", "damping", "elastic", "lag"})
      refuse_field(key, "elasto_plastic or lugre");
  }
  if (friction.kind == FrictionLaw::Kind::lugre) refuse_field("elastic", "elasto_plastic");
  const char* needed = bristle ? "stiffness" : "velocity";
  if (!find(value, needed)) report(reader, value, fmt::format("key {} is missing", in_quotes(needed)));
  if (friction.elastic.value >= 1)
    report(reader, *find(value, "elastic"), fmt::format("must be below 1, got {}", friction.elastic.value));
}

/// Levels of friction, and the speed over which one goes over to the other.
void check_levels(Reader& reader, const Value& value, FrictionFields& friction) {
  if (!find(value, "coulomb") && !find(value, "stiction") && !find(value, "viscous"))
    report(reader, value, "friction has no coulomb, stiction or viscous");
  if (!find(value, "stiction")) friction.stiction = friction.coulomb;
  if (!find(value, "stribeck_velocity")) {
    if (!friction.has_bristle()) {
      friction.stribeck_velocity = scaled(reader, kStribeckOverVelocity, friction.velocity);
    } else if (find(value, "stiction")) {
      report(reader, value, "key \"stribeck_velocity\" is missing", "give the speed over which stiction fades");
    } else {
      friction.stribeck_velocity = 1.0;  // without an effect
    }
  }
  if (friction.stiction.value < friction.coulomb.value) {
    report(reader, *find(value, "stiction"),
           fmt::format("stiction {} is below coulomb {}", friction.stiction.value, friction.coulomb.value));
  }
}

/// Complains unless it acts on exactly one thing. Result: whether it does.
bool check_place(Reader& reader, const Value& value) {
  std::string_view first;
  for (const std::string_view key : {"joint", "spring", "rod"}) {
    const Value* place = find(value, key);
    if (!place) continue;
    if (!first.empty()) {
      report(reader, *place, fmt::format("friction acts on a {} and on a {}", first, key), "leave out one of them");
      return false;
    }
    first = key;
  }
  if (first.empty())
    report(reader, value, "key \"joint\" is missing",
           "or \"spring\" for friction along the line of a spring, or \"rod\" for friction in its end");
  return !first.empty();
}

/// Friction in the end of a rod.
RodFriction rod_friction(Reader& reader, const Value& value, const FrictionFields& friction) {
  if (friction.has_bristle())
    report(reader, *find(value, "law"), "friction in the end of a rod is smooth: it has no one direction to stick in");
  if (!friction.end) report(reader, value, "key \"end\" is missing", "from or to: the ball of the rod that turns hard");
  RodFriction result{friction, friction.name, friction.where, find_element(reader, value, "rod", reader.names.rods)};
  result.at_from = friction.end == ReactionOutput::End::from;
  return result;
}

/// The load of a friction as a value that is set at instants; -1 without one.
int add_load(Reader& reader, const Value& value, const FrictionFields& friction) {
  if (!friction.reaction) {
    for (const std::string_view key : {"quantity", "direction", "period"})
      if (const Value* member = find(value, key))
        report(reader, *member, in_quotes(std::string(key)) + " is of friction with \"reaction\"", "leave it out");
    return -1;
  }
  if (find(value, "normal"))
    report(reader, *find(value, "reaction"), "friction has both normal and reaction", "leave out one of them");
  SampledValue load;
  load.name = friction.name + "_load";
  load.where = friction.where;
  load.period = friction.period.value_or(0);  // finish_frictions knows the step
  load.load = read_reaction(reader, value, friction);
  load.unit = unit_of(*load.load);
  load.shown.description = "reaction that presses " + friction.name;
  reader.model.sampled.push_back(std::move(load));
  return static_cast<int>(reader.model.sampled.size()) - 1;
}

}  // namespace

void read_frictions(Reader& reader, const Entries& entries) {
  std::vector<FrictionFields> frictions;
  read_list(reader, entries, frictions, [](Reader& r, const Value& value, FrictionFields& friction) {
    check_law(r, value, friction);
    check_levels(r, value, friction);
    if (!check_place(r, value)) return;
    friction.load = add_load(r, value, friction);
    if (friction.pressing_spring) friction.normal = find_element(r, value, "normal", r.names.springs);
    if (!friction.rod)
      if (const Value* end = find(value, "end"))
        report(r, *end, "\"end\" is of friction in the end of a rod", "leave it out");
    if (friction.rod) {
      r.model.rod_frictions.push_back(rod_friction(r, value, friction));
    } else if (friction.spring) {
      const int spring = find_element(r, value, "spring", r.names.springs);
      r.model.spring_frictions.push_back({friction, friction.name, friction.where, spring});
    } else {
      r.model.frictions.push_back({friction, friction.name, friction.where, *friction.joint});
    }
  });
}

void finish_frictions(Reader& reader) {
  const double step = reader.model.solver.step;
  for (JointFriction& friction : reader.model.frictions) friction.lag = friction.lag.value_or(step);
  for (SpringFriction& friction : reader.model.spring_frictions) friction.lag = friction.lag.value_or(step);
  for (RodFriction& friction : reader.model.rod_frictions) friction.lag = friction.lag.value_or(step);
  double period = step;
  for (const VariedParameter& varied : reader.varied)
    if (varied.name == kStepOfMotion) period = varied.value.value_or(step);
  for (SampledValue& value : reader.model.sampled)
    if (value.load && value.period == 0) value.period = period;
}

}  // namespace mbgen::reading
