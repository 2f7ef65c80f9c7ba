#pragma once
// Presentation of a value of the interface beside its name: its description, range and units.

#include <algorithm>
#include <array>

#include "compiler/reader/reader.hpp"

namespace mbgen::reading {

constexpr std::size_t kLongestDescription = 4096;

/// "springs, tyres and forces". Requires: there are some.
inline std::string enumeration(const std::vector<std::string>& names) {
  std::string text = names.front();
  for (std::size_t i = 1; i < names.size(); ++i) text += (i + 1 == names.size() ? " and " : ", ") + names[i];
  return text;
}

/// A text for people.
inline FieldInfo prose_field(std::string_view name, std::string_view doc) {
  return {.name = name, .shape = Shape::text, .doc = doc, .longest = kLongestDescription};
}

/// The rows of Presentation, for the table of a kind that has it.
template <class F>
std::array<Field<F>, 5> presentation_fields() {
  const auto number = [](std::string_view name, std::string_view doc, Bound bound) {
    return FieldInfo{.name = name, .shape = Shape::number, .doc = doc, .bound = bound, .depends = Depends::nothing};
  };
  return {
      field<F, &F::description>(
          {.name = "description", .shape = Shape::text, .doc = "for people", .longest = kLongestDescription}),
      field<F, &F::display_unit>({.name = "display_unit",
                                  .shape = Shape::text,
                                  .doc = "unit that importers of an FMU show it in; its values stay in `unit`"}),
      field<F, &F::min>(number("min", "least value that is meant; FMUs and the C interface refuse less", Bound::none)),
      field<F, &F::max>(
          number("max", "largest value that is meant; FMUs and the C interface refuse more", Bound::none)),
      field<F, &F::nominal>(number("nominal", "usual magnitude", Bound::positive))};
}

/// Rows of a table, then more.
template <class F, std::size_t n, std::size_t m>
std::array<Field<F>, n + m> joined(const std::array<Field<F>, n>& first, const std::array<Field<F>, m>& second) {
  std::array<Field<F>, n + m> all{};
  std::copy(second.begin(), second.end(), std::copy(first.begin(), first.end(), all.begin()));
  return all;
}

/// Checks a range and the units of a value of the interface: display_unit must be of the dimension of `unit`. Notes a
/// unit that mbgen does not know. value: the object that is written; given: the value itself, where it has one.
void check_presentation(Reader& reader, const Value& value, const std::string& unit, const Presentation& shown,
                        std::optional<double> given);

/// Complains about a unit other than that in which the value is: no value is ever converted.
void check_unit_of(Reader& reader, const Value& value, const std::string& unit, std::string_view known);

}  // namespace mbgen::reading
