// Numbers of a .tir file that give impossible sizes in its units.
#include <fmt/format.h>

#include "compiler/model/tyres.hpp"
#include "compiler/reader/tir_file.hpp"
#include "compiler/reader/tyre_notes.hpp"

namespace mbgen::reading {
namespace {

/// Possible sizes of tyres, from a toy's to a dumper's, in SI.
struct TirSize {
  std::string_view key, unit;
  double least, most;
};

constexpr TirSize kTirSizes[] = {{"UNLOADED_RADIUS", "m", 0.02, 3},
                                 {"FNOMIN", "N", 1, 2e6},
                                 {"NOMPRES", "Pa", 1e4, 3e6},
                                 {"INFLPRES", "Pa", 1e4, 3e6},
                                 {"LONGVL", "m/s", 0.5, 150}};
/// Deflection under the nominal load over the radius.
constexpr double kLeastDeflection = 0.001, kMostDeflection = 0.7;

double factor_of(std::string_view key, const TirUnits& units) {
  if (key == "FNOMIN") return units.force;
  if (key == "UNLOADED_RADIUS") return units.length;
  return key == "LONGVL" ? units.length / units.time : units.force / (units.length * units.length);
}

/// "with LENGTH = 'mm'", or a text for a missing unit.
std::string by_unit(const TirEntries& entries, const char* quantity, const char* fallback) {
  const auto unit = entries.keys.find(quantity);
  return unit == entries.keys.end() ? fmt::format("without {} in [UNITS], that is in {}", quantity, fallback)
                                    : fmt::format("with {} = '{}'", quantity, unit->second.value);
}

}  // namespace

void note_sizes(Reader& reader, const TirEntries& entries, const TirUnits& units, const TirTyre& tyre) {
  const std::string by_length = by_unit(entries, "LENGTH", "m"), by_force = by_unit(entries, "FORCE", "N");
  const std::string hint = "is the number in the unit that [UNITS] says?";
  for (const TirSize& size : kTirSizes) {
    const auto entry = entries.keys.find(size.key);
    if (entry == entries.keys.end() || !entry->second.used) continue;
    const double number = number_of(entry->second).value_or(0) * factor_of(size.key, units);
    if (number == 0 || (number >= size.least && number <= size.most)) continue;
    note_once(reader, entry->second.place,
              fmt::format("{} = {} is {:.6g} {} {}, tyres have {:g} to {:g} {}", size.key, entry->second.value, number,
                          size.unit, size.key == "FNOMIN" ? by_force : by_length, size.least, size.most, size.unit),
              hint);
  }
  const auto stiffness = entries.keys.find("VERTICAL_STIFFNESS");
  if (stiffness == entries.keys.end() || tyre.stiffness.value_or(0) <= 0) return;
  const auto of = [&](const char* name) {
    return tyre.coefficients[tyre_field_index(tyre_fields(tyre.model), name)].value;
  };
  const double deflection = of("FNOMIN") / *tyre.stiffness, share = deflection / of("UNLOADED_RADIUS");
  if (share >= kLeastDeflection && share <= kMostDeflection) return;
  note_once(reader, stiffness->second.place,
            fmt::format("VERTICAL_STIFFNESS = {} is {:.6g} N/m {}: FNOMIN presses the tyre by {:.4g} m, {:.3g} of its "
                        "radius",
                        stiffness->second.value, *tyre.stiffness, by_length, deflection, share),
            hint);
}

}  // namespace mbgen::reading
