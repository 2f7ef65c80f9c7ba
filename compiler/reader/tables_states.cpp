// Tables of fields: states and sampled values.
#include <array>

#include "compiler/reader/presentation.hpp"
#include "compiler/reader/raw.hpp"
#include "compiler/reader/reaction_loads.hpp"
#include "compiler/reader/reader.hpp"

namespace mbgen::reading {
namespace {

constexpr FieldInfo kUnit{.name = "unit", .shape = Shape::text, .doc = "unit, for people"};
constexpr FieldInfo kInitial{
    .name = "initial", .shape = Shape::number, .doc = "value at the start", .fallback = 0, .depends = Depends::nothing};

}  // namespace

template <>
std::span<const Field<UserStateFields>> fields<UserStateFields>() {
  using F = UserStateFields;
  static const std::array table =
      joined(std::array{field<F, &F::written>({.name = "derivative",
                                               .doc = "rate of the state, an expression like a force",
                                               .unit = "unit of the state over s",
                                               .need = Need::required}),
                        field<F, &F::initial>(kInitial), field<F, &F::unit>(kUnit)},
             presentation_fields<F>());
  return table;
}

template <>
std::span<const Field<SampledValueFields>> fields<SampledValueFields>() {
  using F = SampledValueFields;
  static const std::array table = joined(
      std::array{
          field<F, &F::period>({.name = "period",
                                .shape = Shape::number,
                                .doc = "time between the instants, a multiple of the solver's step",
                                .unit = "s",
                                .need = Need::required,
                                .bound = Bound::positive}),
          field<F, &F::written>({.name = "value",
                                 .doc = "new value at an instant; it may use the new values of sampled values above "
                                        "it, and the old values of itself and of those below"}),
          field<F, &F::initial>(kInitial),
          field<F, &F::written_delay>({.name = "delay",
                                       .shape = Shape::number,
                                       .doc = "number of instants until a computed value takes effect",
                                       .fallback = 0,
                                       .bound = Bound::not_negative}),
          field<F, &F::unit>(kUnit),
      },
      joined(reaction_fields<F>("instead of value: joint or rod; the value is set to its transmitted force"),
             presentation_fields<F>()));
  return table;
}

}  // namespace mbgen::reading
