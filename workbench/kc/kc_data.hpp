#pragma once
// Figures, curves and matrices of a rig on an axle.

#include <string>
#include <vector>

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
  std::vector<std::string> rates = {};  ///< names of the columns that are derivatives along the curve
};

/// Derivatives of the rows' quantities by the columns' loads, at the start; SI units.
struct KcMatrix {
  std::string name, title;
  std::vector<Heading> rows, columns;
  std::vector<std::vector<double>> values;  ///< per row
};

/// Figures and curves of another model, or measured ones, beside those of a report.
struct KcOverlay {
  std::string label;
  bool is_measured = false;
  std::vector<KcFigure> figures = {};  ///< none of measured ones
  std::vector<KcTable> tables = {};    ///< of measured ones: columns of the report's tables, in any number
  std::vector<std::string> notes = {};
};

struct KcReport {
  std::string model, axle;
  std::vector<KcFigure> figures = {};
  std::vector<KcTable> tables = {};
  std::vector<KcMatrix> matrices = {};  ///< compliance
  std::vector<std::string> notes = {};  ///< early ends of curves, and missing curves
  std::vector<KcOverlay> overlays = {};
};

/// The curve of this name, null where the report has none.
const KcTable* table_named(const KcReport& report, const std::string& name);

}  // namespace mbgen
