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

template <>
std::span<const Field<SensorFields>> fields<SensorFields>() {
  using F = SensorFields;
  const auto number = [](std::string_view name, std::string_view doc, std::optional<double> fallback, Bound bound) {
    return FieldInfo{.name = name,
                     .doc = doc,
                     .unit = "unit of the value",
                     .fallback = fallback,
                     .bound = bound,
                     .depends = Depends::parameters};
  };
  static const std::array table = joined(
      std::array{
          field<F, &F::written>({.name = "value", .doc = "measured value, an expression", .need = Need::required}),
          field<F, &F::period>({.name = "period",
                                .shape = Shape::number,
                                .doc = "time between measurements, a multiple of the solver's step",
                                .unit = "s",
                                .need = Need::required,
                                .bound = Bound::positive}),
          field<F, &F::filter>({.name = "filter",
                                .doc = "cut-off frequency of a low-pass filter of first order before the sampling",
                                .unit = "Hz",
                                .bound = Bound::positive,
                                .depends = Depends::parameters}),
          field<F, &F::gain>({.name = "gain",
                              .doc = "factor of the value",
                              .unit = "1",
                              .fallback = 1,
                              .depends = Depends::parameters}),
          field<F, &F::bias>(number("bias", "is added", 0, Bound::none)),
          field<F, &F::noise>(
              number("noise", "standard deviation of a normally distributed error", 0, Bound::not_negative)),
          field<F, &F::seed>({.name = "seed",
                              .shape = Shape::number,
                              .doc = "of the noise, a whole number; sensors of one seed have different noise",
                              .unit = "1",
                              .fallback = 1,
                              .bound = Bound::not_negative}),
          field<F, &F::least>(number("least", "least value that is shown", std::nullopt, Bound::none)),
          field<F, &F::most>(number("most", "largest value that is shown", std::nullopt, Bound::none)),
          field<F, &F::quantisation>(
              number("quantisation", "step between values that are shown, 0 for none", 0, Bound::not_negative)),
          field<F, &F::delay>({.name = "delay",
                               .shape = Shape::number,
                               .doc = "time between measurement and effect, a multiple of the period",
                               .unit = "s",
                               .fallback = 0,
                               .bound = Bound::not_negative}),
          field<F, &F::initial>(kInitial),
          field<F, &F::unit>(kUnit),
      },
      presentation_fields<F>());
  return table;
}

template <>
std::span<const Field<DelayFields>> fields<DelayFields>() {
  using F = DelayFields;
  static const std::array table = joined(
      std::array{
          field<F, &F::written>({.name = "value", .doc = "delayed value, an expression", .need = Need::required}),
          field<F, &F::delay>({.name = "delay",
                               .shape = Shape::number,
                               .doc = "a multiple of the period, at least two",
                               .unit = "s",
                               .need = Need::required,
                               .bound = Bound::positive}),
          field<F, &F::period>({.name = "period",
                                .shape = Shape::number,
                                .doc = "time between the values that are stored, a multiple of the solver's step",
                                .unit = "s",
                                .need = Need::required,
                                .bound = Bound::positive}),
          field<F, &F::initial>(kInitial),
          field<F, &F::unit>(kUnit),
      },
      presentation_fields<F>());
  return table;
}

}  // namespace mbgen::reading
