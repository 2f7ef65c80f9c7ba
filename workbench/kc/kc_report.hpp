#pragma once
// Report of a rig on an axle: figures and curves, as text, tables, pictures and a page.

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "workbench/host/files.hpp"
#include "workbench/results/table.hpp"

namespace mbgen {

/// A value of the axle at the start: of the axle or a single wheel, or two values, left and right.
struct KcFigure {
  std::string name, unit, meaning;
  std::vector<double> values;
};

/// One rig curve; its first column is the input of the rig. SI units, angles in rad.
struct KcTable {
  std::string name, title;
  std::vector<Column> columns;
};

struct KcReport {
  std::string model, axle;
  std::vector<KcFigure> figures;
  std::vector<KcTable> tables;
  std::vector<std::string> notes;  ///< early ends of curves, and missing curves
};

/// The figures for people: angles in degrees, small lengths in mm.
std::string kc_text(const KcReport& report);

/// The figures and tables for programs.
nlohmann::ordered_json kc_json(const KcReport& report);

/// A CSV table and an SVG picture for each curve, then the page AXLE.html with all of them.
std::vector<NamedText> kc_files(const KcReport& report);

}  // namespace mbgen
