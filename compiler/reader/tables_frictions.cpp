// Table of fields: friction.

#include <array>

#include "compiler/reader/presentation.hpp"
#include "compiler/reader/raw.hpp"
#include "compiler/reader/reaction_loads.hpp"
#include "compiler/reader/reader.hpp"

namespace mbgen::reading {
namespace {

constexpr std::array<std::string_view, 3> kFrictionLaws = {"smooth", "elasto_plastic", "lugre"};
/// In the order of ReactionOutput::End.
constexpr std::array<std::string_view, 2> kRodEnds = {"to", "from"};

}  // namespace

template <>
std::span<const Field<FrictionFields>> fields<FrictionFields>() {
  using S = FrictionFields;
  static const std::array table = joined(
      std::array{
          field<S, &S::joint>({.name = "joint", .shape = Shape::coordinate, .doc = "coordinate it acts on"}),
          field<S, &S::spring>({.name = "spring",
                                .shape = Shape::reference,
                                .doc = "spring along whose line it acts, in place of a coordinate",
                                .of = "springs"}),
          field<S, &S::rod>({.name = "rod",
                             .shape = Shape::reference,
                             .doc = "rod in whose end it acts, against the turn of the body there; its rates are rad/s",
                             .of = "rods"}),
          field<S, &S::end>({.name = "end", .shape = Shape::word, .doc = "end of the rod", .words = kRodEnds}),
          field<S, &S::kind>({.name = "law",
                              .shape = Shape::word,
                              .doc = "smooth: a force of the speed alone, which creeps at rest; elasto_plastic, lugre: "
                                     "bristles, which hold",
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
                                  .doc = "of law smooth: speed over which the sign of friction is smoothed",
                                  .unit = "rad/s or m/s",
                                  .bound = Bound::positive}),
          field<S, &S::stribeck_velocity>({.name = "stribeck_velocity",
                                           .doc = "speed over which stiction fades; default: 10 times velocity",
                                           .unit = "rad/s or m/s",
                                           .bound = Bound::positive}),
          field<S, &S::stiffness>({.name = "stiffness",
                                   .doc = "of bristles before they slide; with normal or reaction per N of it",
                                   .unit = "N m/rad or N/m",
                                   .bound = Bound::positive}),
          field<S, &S::damping>({.name = "damping",
                                 .doc = "of bristles that bend; with normal or reaction per N of it",
                                 .unit = "N m s/rad or N s/m",
                                 .fallback = 0,
                                 .bound = Bound::not_negative}),
          field<S, &S::elastic>({.name = "elastic",
                                 .doc =
                                     "of law elasto_plastic: share of the largest deflection up to which bristles bend "
                                     "without sliding, below 1",
                                 .unit = "1",
                                 .fallback = 0.8,
                                 .bound = Bound::not_negative}),
          field<S, &S::lag>({.name = "lag",
                             .shape = Shape::number,
                             .doc = "bristles follow no faster; default: the step of solver",
                             .unit = "s",
                             .bound = Bound::not_negative}),
          field<S, &S::pressing_spring>({.name = "normal",
                                         .shape = Shape::reference,
                                         .doc = "spring whose force, without its friction, presses the parts together",
                                         .of = "springs"}),
          field<S, &S::period>({.name = "period",
                                .shape = Shape::number,
                                .doc = "time between the instants at which the reaction is taken, a multiple of the "
                                       "solver's step; default: the step of solver",
                                .unit = "s",
                                .bound = Bound::positive})},
      reaction_fields<S>("joint or rod whose transmitted force presses the parts together, in place of normal"));
  return table;
}

}  // namespace mbgen::reading
