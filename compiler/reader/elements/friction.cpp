// Friction on coordinates, along springs and in rod ends.
#include <fmt/format.h>

#include <array>

#include "compiler/reader/elements/sections.hpp"
#include "compiler/reader/output_sources.hpp"
#include "compiler/reader/presentation.hpp"
#include "compiler/reader/raw.hpp"
#include "compiler/reader/reaction_loads.hpp"
#include "compiler/reader/reader.hpp"

namespace mbgen::reading {

/// Friction on a coordinate, along a spring or in the ball joint at a rod's end.
struct FrictionFields : FrictionLaw, ReactionFields {
  std::string name;
  Where where;
  std::optional<CoordinateReference> joint, relative_to;
  std::optional<std::string> spring, rod, pressing_spring;
  std::optional<ReactionOutput::End> end;
  std::optional<double> period;
};

template <>
std::span<const Field<FrictionFields>> fields<FrictionFields>();
namespace {

constexpr std::array<std::string_view, 3> kFrictionLaws = {"smooth", "elasto_plastic", "lugre"};
/// In the order of ReactionOutput::End.
constexpr std::array<std::string_view, 2> kRodEnds = {"to", "from"};

/// Fields of the attachment and of the levels.
auto friction_level_fields() {
  using S = FrictionFields;
  return std::array{
      field<S, &S::joint>({.name = "joint", .shape = Shape::coordinate, .doc = "coordinate it acts on"}),
      field<S, &S::relative_to>({.name = "relative_to",
                                 .shape = Shape::coordinate,
                                 .doc = "coordinate whose rate is subtracted, and that the opposite force acts on: a "
                                        "clutch between two shafts"}),
      field<S, &S::spring>({.name = "spring",
                            .shape = Shape::reference,
                            .doc = "spring with friction along its line, instead of a coordinate",
                            .of = "springs"}),
      field<S, &S::rod>(
          {.name = "rod",
           .shape = Shape::reference,
           .doc = "rod with friction at its end, against the rotation of the body there; its rates are rad/s",
           .of = "rods"}),
      field<S, &S::end>({.name = "end", .shape = Shape::word, .doc = "end of the rod", .words = kRodEnds}),
      field<S, &S::kind>(
          {.name = "law",
           .shape = Shape::word,
           .doc = "smooth: depends on the speed only, and creeps at rest; elasto_plastic, lugre: bristles, which stick",
           .fallback_word = "smooth",
           .words = kFrictionLaws}),
      field<S, &S::coulomb>(
          {.name = "coulomb",
           .doc = "sliding friction; with normal or reaction the coefficient of friction (m on a rotation)",
           .unit = "N m or N",
           .fallback = 0,
           .bound = Bound::not_negative}),
      field<S, &S::stiction>({.name = "stiction",
                              .doc = "friction at the start of sliding, as coulomb; default: coulomb",
                              .unit = "N m or N",
                              .bound = Bound::not_negative}),
      field<S, &S::viscous>({.name = "viscous",
                             .doc = "friction that grows with speed",
                             .unit = "N m s/rad or N s/m",
                             .fallback = 0,
                             .bound = Bound::not_negative}),
      field<S, &S::velocity>({.name = "velocity",
                              .doc = "of law smooth: regularisation speed",
                              .unit = "rad/s or m/s",
                              .bound = Bound::positive}),
  };
}

/// Fields of bristles and of the normal force.
auto friction_bristle_fields() {
  using S = FrictionFields;
  return std::array{
      field<S, &S::stribeck_velocity>({.name = "stribeck_velocity",
                                       .doc = "speed over which stiction fades; default: 10 times velocity",
                                       .unit = "rad/s or m/s",
                                       .bound = Bound::positive}),
      field<S, &S::stiffness>({.name = "stiffness",
                               .doc = "of bristles before they slide; with normal or reaction per N of it",
                               .unit = "N m/rad or N/m",
                               .bound = Bound::positive}),
      field<S, &S::damping>({.name = "damping",
                             .doc = "of bristles; with normal or reaction per N of it",
                             .unit = "N m s/rad or N s/m",
                             .fallback = 0,
                             .bound = Bound::not_negative}),
      field<S, &S::elastic>({.name = "elastic",
                             .doc = "of law elasto_plastic: share of the largest deflection up to which bristles bend "
                                    "without sliding, below 1",
                             .unit = "1",
                             .fallback = 0.8,
                             .bound = Bound::not_negative}),
      field<S, &S::lag>({.name = "lag",
                         .shape = Shape::number,
                         .doc = "least time constant of bristles; default: the step of solver",
                         .unit = "s",
                         .bound = Bound::not_negative}),
      field<S, &S::pressing_spring>({.name = "normal",
                                     .shape = Shape::reference,
                                     .doc = "spring with the normal force (without its friction)",
                                     .of = "springs"}),
      field<S, &S::period>(
          {.name = "period",
           .shape = Shape::number,
           .doc = "sampling period of the reaction, a multiple of the solver's step; default: the step of solver",
           .unit = "s",
           .bound = Bound::positive})};
}

}  // namespace

template <>
std::span<const Field<FrictionFields>> fields<FrictionFields>() {
  static const std::array table = joined(
      joined(friction_level_fields(), friction_bristle_fields()),
      reaction_fields<FrictionFields>("joint or rod with the normal force as transmitted force, instead of normal"));
  return table;
}

namespace {

constexpr double kStribeckOverVelocity = 10;

/// Reports fields without effect on the law, and missing fields of the law.
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

/// Levels of friction, and the speed of the transition between them.
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

/// Reports a friction without exactly one attachment. Result: whether it has one.
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
           "or \"spring\" for friction along the line of a spring, or \"rod\" for friction at its end");
  return !first.empty();
}

/// Friction in a rod end.
RodFriction rod_friction(Reader& reader, const Value& value, const FrictionFields& friction) {
  if (friction.has_bristle())
    report(reader, *find(value, "law"), "friction at the end of a rod is smooth: it has no one direction to stick in");
  if (!friction.end) report(reader, value, "key \"end\" is missing", "from or to: the ball of the rod that turns hard");
  RodFriction result{friction, friction.name, friction.where, find_element(reader, value, "rod", reader.names.rods)};
  result.at_from = friction.end == ReactionOutput::End::from;
  return result;
}

/// Adds the normal force of a friction as a sampled value; -1 without one.
int add_load(Reader& reader, const Value& value, const FrictionFields& friction) {
  if (!friction.reaction) {
    for (const std::string_view key : {"quantity", "direction", "period"})
      if (const Value* member = find(value, key))
        report(reader, *member, in_quotes(std::string(key)) + " is of friction with \"reaction\"", "leave it out");
    return -1;
  }
  if (find(value, "normal"))
    report(reader, *find(value, "reaction"), "friction has both \"normal\" and \"reaction\"", "leave out one of them");
  SampledValue load;
  load.name = friction.name + "_load";
  load.where = friction.where;
  load.period = friction.period.value_or(0);  // set by finish_lags, which knows the step
  load.load = read_reaction(reader, value, friction);
  load.unit = unit_of(*load.load);
  load.shown.description = "reaction that presses " + friction.name;
  reader.model.sampled.push_back(std::move(load));
  return static_cast<int>(reader.model.sampled.size()) - 1;
}

void read_frictions(Reader& reader, const Entries& entries) {
  std::vector<FrictionFields> frictions;
  read_list(reader, entries, frictions, [](Reader& r, const Value& value, FrictionFields& friction) {
    check_law(r, value, friction);
    check_levels(r, value, friction);
    if (!check_place(r, value)) return;
    friction.load = add_load(r, value, friction);
    if (friction.pressing_spring) friction.normal = find_element(r, value, "normal", names_of<PointSpring>(r));
    if (!friction.rod)
      if (const Value* end = find(value, "end"))
        report(r, *end, "\"end\" is of friction at the end of a rod", "leave it out");
    if (const Value* other = find(value, "relative_to"); other && !friction.joint)
      report(r, *other, "\"relative_to\" is of friction on a coordinate", "leave it out, or give \"joint\"");
    if (friction.joint && friction.relative_to)
      check_coordinate_pair(r, value, "friction", *friction.joint, *friction.relative_to);
    if (friction.rod) {
      r.model.rod_frictions.push_back(rod_friction(r, value, friction));
    } else if (friction.spring) {
      const int spring = find_element(r, value, "spring", names_of<PointSpring>(r));
      r.model.spring_frictions.push_back({friction, friction.name, friction.where, spring});
    } else {
      r.model.frictions.push_back({friction, friction.name, friction.where, *friction.joint, friction.relative_to});
    }
  });
}

}  // namespace

void finish_lags(Reader& reader) {
  const double step = reader.model.solver.step;
  double period = step;
  for (const VariedParameter& varied : reader.varied)
    if (varied.name == kStepOfMotion) period = varied.value.value_or(step);
  const double lag = std::max(step, period);  // bristles of a lag below the step go past their end
  each_element(reader.model, [lag](auto& element) {
    if constexpr (requires { element.lag.value_or(lag); }) element.lag = element.lag.value_or(lag);
  });
  for (SampledValue& value : reader.model.sampled)
    if (value.load && value.period == 0) value.period = period;
}

ElementSection section_of(Leader<JointFriction>) {
  return {"friction on coordinates and springs",
          [] {
            return std::vector<ObjectKind>{kind_of<FrictionFields>(
                "friction",
                "friction on a coordinate, along a spring or at the end of a rod; exactly one of joint, "
                "spring and rod",
                {"joint", "spring", "rod"}, {{"rod", "end"}, {"end", "rod"}})};
          },
          read_frictions};
}

}  // namespace mbgen::reading
