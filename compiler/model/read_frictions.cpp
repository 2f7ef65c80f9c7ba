// Friction on coordinates and along springs.

#include <fmt/format.h>

#include "compiler/model/output_sources.hpp"
#include "compiler/model/raw.hpp"
#include "compiler/model/reader.hpp"

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
  const bool joint = find(value, "joint"), spring = find(value, "spring");
  if (joint != spring) return true;
  if (joint) {
    report(reader, *find(value, "spring"), "friction acts on a joint and on a spring", "leave out one of them");
  } else {
    report(reader, value, "key \"joint\" is missing", "or \"spring\" for friction along the line of a spring");
  }
  return false;
}

}  // namespace

void read_frictions(Reader& reader, const Entries& entries) {
  std::vector<FrictionFields> frictions;
  read_list(reader, entries, frictions, [](Reader& r, const Value& value, FrictionFields& friction) {
    check_law(r, value, friction);
    check_levels(r, value, friction);
    if (!check_place(r, value)) return;
    if (friction.pressing_spring) friction.normal = find_element(r, value, "normal", r.names.springs);
    if (friction.spring) {
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
}

}  // namespace mbgen::reading
