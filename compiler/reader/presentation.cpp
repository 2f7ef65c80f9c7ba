#include "compiler/reader/presentation.hpp"

#include <fmt/format.h>

#include <cmath>

#include "compiler/expressions/unit_exponents.hpp"

namespace mbgen::reading {
namespace {

/// Factors that a unit may be off by rounding.
constexpr double kSameFactor = 1e-12;

/// Angles are numbers: rad counts as 1.
bool is_same_unit(const UnitExponents& a, const UnitExponents& b) {
  return std::equal(a.exponents.begin(), a.exponents.end() - 1, b.exponents.begin()) &&
         std::abs(a.factor - b.factor) <= kSameFactor * std::abs(b.factor);
}

void note_unknown(Reader& reader, const Value& unit) {
  reader.model.notes.push_back({where_of(reader.documents, unit.place),
                                fmt::format("unit {} is not known, so that an FMU or an A2L file gives no factor to "
                                            "base units",
                                            in_quotes(unit.text)),
                                did_you_mean(unit.text, known_units()),
                                {}});
}

void check_range(Reader& reader, const Value& value, const Presentation& shown, std::optional<double> given) {
  if (shown.min && shown.max && *shown.min > *shown.max) {
    report(reader, *find(value, "min"), fmt::format("min is above max: {} and {}", *shown.min, *shown.max));
    return;
  }
  if (!given) return;
  const char* name = find(value, "value") ? "value" : "default";
  const Value& place = member_or_object(value, name);
  if (shown.min && *given < *shown.min)
    report(reader, place, fmt::format("{} must be at least min, {}, got {}", name, *shown.min, *given));
  if (shown.max && *given > *shown.max)
    report(reader, place, fmt::format("{} must be at most max, {}, got {}", name, *shown.max, *given));
}

}  // namespace

void check_presentation(Reader& reader, const Value& value, const std::string& unit, const Presentation& shown,
                        std::optional<double> given) {
  check_range(reader, value, shown, given);
  const Value* written = find(value, "unit");
  const std::optional<UnitExponents> base = unit.empty() ? std::nullopt : unit_exponents(unit);
  if (written && !unit.empty() && !base) note_unknown(reader, *written);
  const Value* display = find(value, "display_unit");
  if (!display || shown.display_unit.empty()) return;
  const std::optional<UnitExponents> other = unit_exponents(shown.display_unit);
  if (!other) {
    report(reader, *display, fmt::format("unit {} is not known", in_quotes(shown.display_unit)),
           did_you_mean(shown.display_unit, known_units()));
  } else if (!base) {
    report(reader, *display, "display_unit needs a \"unit\" that is known, to convert from");
  } else if (other->exponents != base->exponents) {
    report(reader, *display,
           fmt::format("display_unit {} is of another dimension than the unit, {}", in_quotes(shown.display_unit),
                       in_quotes(unit)));
  }
}

void check_unit_of(Reader& reader, const Value& value, const std::string& unit, std::string_view known) {
  const Value* written = find(value, "unit");
  const std::optional<UnitExponents> given = unit_exponents(unit), right = unit_exponents(known);
  if (!written || !given || !right || is_same_unit(*given, *right)) return;
  report(reader, *written,
         fmt::format("the unit is {}, the unit of the value is {}", in_quotes(unit), in_quotes(known)),
         given->exponents == right->exponents
             ? fmt::format("values are not converted; write \"unit\": \"{}\", \"display_unit\": \"{}\"", known, unit)
             : "");
}

}  // namespace mbgen::reading
