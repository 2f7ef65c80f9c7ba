#pragma once
// Tyre property files of Adams and TNO (.tir).

#include <optional>
#include <vector>

#include "compiler/model/reader.hpp"

namespace mbgen::reading {

/// What a .tir file says of a tyre, in SI units.
struct TirTyre {
  std::vector<Quantity> coefficients;                ///< in the order of kPac2002Fields
  std::optional<double> stiffness, damping;          ///< N/m, N s/m: VERTICAL_STIFFNESS, VERTICAL_DAMPING
  std::optional<double> rolling_resistance;          ///< QSY1
  std::optional<double> relaxation_x, relaxation_y;  ///< m, at nominal load and upright: PTX1; PTY1 and PTY2
};

/// Reads a file of PAC2002 or Magic Formula 5.2, relative to the file that names it. Sections, units, comments ($ and
/// !) and texts in quotes are understood; coefficients without a part in the formulas of tyre.hpp are passed over.
/// Fails: nothing, with complaints at lines of the file: another tyre model, units that are unknown, a coefficient
/// that is no number or stands twice, no radius or nominal load.
std::optional<TirTyre> read_tir(Reader& reader, const Value& value);

}  // namespace mbgen::reading
