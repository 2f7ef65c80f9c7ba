#pragma once
// Values of a rig for people: degrees, mm, N/mm and kN in place of SI units.

#include <string>
#include <vector>

#include "workbench/kc/kc_data.hpp"

namespace mbgen::kc {

/// A unit for people, and the factor to it.
struct Shown {
  std::string unit;
  double factor = 1;
};

/// The unit in which values of an SI unit are shown.
Shown shown(const std::string& unit);

/// Five digits; "-" for a value that does not exist.
std::string shown_number(double value);

/// A column in its shown unit.
Column drawn(const Column& column);

/// SI unit of a matrix's element.
std::string unit_of(const KcMatrix& matrix, std::size_t row, std::size_t column);

/// The part of a matrix with the rows of one wheel and the columns of one case of loads.
struct MatrixBlock {
  std::string wheel, loads;  ///< "left", "both"
  std::vector<std::size_t> rows, columns;
};

/// All blocks, wheel by wheel.
std::vector<MatrixBlock> blocks_of(const KcMatrix& matrix);

/// Name of a matrix's row or column without its wheel: "steer_angle" of "steer_angle_left".
std::string plain_name(const Heading& heading);

/// A line of a comparison: values at the start, left before right, and their differences from the report's, SI units.
struct KcDifference {
  std::string name, unit;
  std::vector<double> values, differences;
  double rms = 0;  ///< difference along the curve; of measured points only
};

/// Differences of an overlay from its report: of figures, or of measured columns, at the start and along the curve.
std::vector<KcDifference> differences_of(const KcReport& report, const KcOverlay& overlay);

}  // namespace mbgen::kc
