#pragma once
// A strip of road along the path of wheels, with a resolution adapted to its shape.

#include <array>
#include <cstddef>
#include <functional>
#include <vector>

#include "runtime/generic/generic.hpp"

namespace mbgen {

using GroundPlace = std::array<double, 2>;  ///< global x and y, m

/// A station of the path: the strip has a row of points across it here.
struct Station {
  double x = 0, y = 0;          ///< m, global
  double cosine = 1, sine = 0;  ///< of the path's angle to the global x axis
};

/// Rows across the path, with a point at every offset to its left.
struct Strip {
  std::vector<Station> stations;
  std::vector<double> offsets;  ///< m, increasing
  std::vector<RoadBelow> road;  ///< station by station, right to left

  /// Point at an offset to the left of a station.
  static GroundPlace place(const Station& station, double offset) {
    return {station.x - offset * station.sine, station.y + offset * station.cosine};
  }
};

/// Request for a strip: path of the wheels, and resolution.
struct StripRequest {
  std::vector<std::vector<GroundPlace>> wheels;  ///< the same wheels in every frame, at least one wheel and frame
  double radius = 1;                             ///< m, of the largest wheel: unit of lengths
  double heading = 0;                            ///< rad, of the strip for wheels at rest
  std::size_t most = 0;                          ///< places
};

/// The strip under the wheels and some radii around them, extended as far at both ends. Rows and offsets belong to a
/// grid of a 25th of a radius, or of 200 000 points; grid lines are omitted if linear interpolation between the kept
/// ones is within a tolerance: a 500th of a radius, more for a strip with too many points. look: the road below points.
Strip strip_along(const StripRequest& request,
                  const std::function<std::vector<RoadBelow>(const std::vector<GroundPlace>&)>& look);

}  // namespace mbgen
