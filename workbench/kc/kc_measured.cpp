// Measured points beside the curves of a rig.

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "workbench/kc/kc_report.hpp"
#include "workbench/kc/kc_shown.hpp"
#include "workbench/results/results.hpp"

namespace mbgen {
namespace {

using namespace kc;

std::string known_columns(const KcTable& table) {
  std::string known;
  for (const Column& column : table.columns) known += (known.empty() ? "" : ", ") + column.heading.name;
  return known;
}

/// A measured column in the SI unit of the computed one. Fails: Diagnostic if it has another unit.
Result<Column> in_si(const Column& measured, const Heading& computed, const std::string& file) {
  const std::string& unit = measured.heading.unit;
  const Shown as = shown(computed.unit);
  const bool is_si = unit.empty() || unit == computed.unit || (computed.unit == "1" && unit == "-");
  if (!is_si && unit != as.unit)
    return table_fault(
        file, 1,
        fmt::format("{}: its unit must be {}, found {}", computed.name,
                    as.unit.empty() || as.unit == computed.unit ? computed.unit
                                                                : fmt::format("{} or {}", computed.unit, as.unit),
                    unit));
  Column column{computed, measured.values};
  if (!is_si)
    for (double& value : column.values) value /= as.factor;
  return column;
}

}  // namespace

std::string curve_of_file(const KcReport& report, const std::string& file) {
  const std::string stem = std::filesystem::path(file).stem().string();
  for (const KcTable& table : report.tables)
    if (stem.find(table.name) != std::string::npos) return table.name;
  return "";
}

Result<KcOverlay> measured_overlay(const KcReport& report, const std::string& curve, const Results& table,
                                   const std::string& file) {
  const auto computed =
      std::find_if(report.tables.begin(), report.tables.end(), [&](const KcTable& one) { return one.name == curve; });
  if (computed == report.tables.end()) {
    std::string known;
    for (const KcTable& one : report.tables) known += (known.empty() ? "" : ", ") + one.name;
    return table_fault(file, 0,
                       curve.empty() ? fmt::format("its name does not tell the curve; known: {}", known)
                                     : fmt::format("axle {} has no curve \"{}\"; known: {}", report.axle, curve, known),
                       "call the file like the table of the curve, or write --measured CURVE=FILE.csv");
  }
  KcTable measured{computed->name, computed->title, {}};
  for (const Column& column : table.columns) {
    const auto is_same = [&](const Column& other) { return other.heading.name == column.heading.name; };
    const auto same = std::find_if(computed->columns.begin(), computed->columns.end(), is_same);
    if (same == computed->columns.end())
      return table_fault(file, 1,
                         fmt::format("{} of axle {} has no column \"{}\"; known: {}", curve, report.axle,
                                     column.heading.name, known_columns(*computed)));
    if (std::any_of(measured.columns.begin(), measured.columns.end(), is_same))
      return table_fault(file, 1, fmt::format("column \"{}\" stands twice", column.heading.name));
    Result<Column> read = in_si(column, same->heading, file);
    if (!read) return read.problems();
    const bool is_abscissa = same == computed->columns.begin();
    measured.columns.insert(is_abscissa ? measured.columns.begin() : measured.columns.end(), std::move(*read));
  }
  const std::string& abscissa = computed->columns.front().heading.name;
  if (measured.columns.front().heading.name != abscissa)
    return table_fault(file, 1, fmt::format("needs the column \"{}\", over which {} is drawn", abscissa, curve));
  if (measured.columns.size() == 1)
    return table_fault(file, 1,
                       fmt::format("has no column beside \"{}\"; known: {}", abscissa, known_columns(*computed)));
  KcOverlay overlay{.label = std::filesystem::path(file).filename().string(), .is_measured = true};
  overlay.tables.push_back(std::move(measured));
  return overlay;
}

}  // namespace mbgen
