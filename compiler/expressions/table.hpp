#pragma once
// Tables: curves by points.

#include <memory>
#include <optional>
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
  std::vector<double> x, y;    ///< x strictly increasing, at least two points
  bool periodic = false;       ///< the curve goes on as it came, each period higher by the last y less the first
  std::vector<double> slopes;  ///< at the points, see slopes_of; empty where linear
  std::optional<TableData> data = std::nullopt;  ///< of a table of many points
};

}  // namespace mbgen
