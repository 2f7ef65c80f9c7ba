#pragma once
// Tables: curves by points, maps by grids of points.

#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace mbgen {

/// Where the pieces of a table of many points stand as data.
struct TableData {
  std::shared_ptr<const std::vector<double>> samples;  ///< Model::samples
  int first = 0;                                       ///< index of the first of its numbers among them, see pieces_of
  double spacing = 0;                                  ///< see spacing_of
};

/// y(x) by points; outside the range the end segments (linear) or end slopes (cubic) are continued as straight lines,
/// or the points are one period.
struct Table {
  enum class Interpolation { linear, monotone_cubic, spline };
  Interpolation interpolation = Interpolation::linear;
  std::vector<double> x, y;         ///< x strictly increasing, at least two points
  bool periodic = false;            ///< the curve goes on as it came, each period higher by the last y less the first
  std::vector<double> slopes = {};  ///< at the points, see slopes_of; empty where linear
  std::optional<TableData> data = std::nullopt;  ///< of a table of many points
};

/// z(x, y) by a grid of points: in each cell a polynomial of the places between the lines of the grid, from 0 to 1;
/// beyond the grid it goes on straight.
struct CharacteristicMap {
  Table along_x, along_y;  ///< number of the lines before an argument, and the place behind the last of them
  int degree = 1;          ///< of the polynomials in each place: 1, or 3 for a smooth map
  std::shared_ptr<const std::vector<double>> samples;  ///< Model::samples
  /// index of the first coefficient there: cell by cell, along y first, (degree + 1)^2 each, powers of the place along
  /// y first
  int first = 0;
};

/// A table that expressions name.
struct NamedTable {
  std::variant<Table, CharacteristicMap> table;
  bool holds = false;      ///< beyond its points it keeps the value at their edge
  bool is_chosen = false;  ///< the model says how it goes on there
  std::string name = {};
  int arity() const { return std::holds_alternative<Table>(table) ? 1 : 2; }
};

/// Whether the slope of a table jumps at its points.
inline bool has_straight_pieces(const NamedTable& named) {
  const auto* curve = std::get_if<Table>(&named.table);
  return curve ? curve->interpolation == Table::Interpolation::linear
               : std::get<CharacteristicMap>(named.table).degree == 1;
}

}  // namespace mbgen
