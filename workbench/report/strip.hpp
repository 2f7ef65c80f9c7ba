#pragma once
// A strip of the road along the way of some wheels, with as many places as its shape needs.

#include <array>
#include <cstddef>
#include <functional>
#include <vector>

#include "runtime/generic/generic.hpp"

namespace mbgen {

using GroundPlace = std::array<double, 2>;  ///< global x and y, m

/// A place of the way: the strip's lines across lie there, across its direction.
struct Station {
  double x = 0, y = 0;          ///< m, global
  double cosine = 1, sine = 0;  ///< of the direction of the way from the global x axis
};

/// Rows across the way, each with a place at every offset to the left of it.
struct Strip {
  std::vector<Station> stations;
  std::vector<double> offsets;  ///< m, increasing
  std::vector<RoadBelow> road;  ///< station by station, right to left

  /// At an offset of the left of a station.
  static GroundPlace place(const Station& station, double offset) {
    return {station.x - offset * station.sine, station.y + offset * station.cosine};
  }
};

/// Request for a strip: the wheels' way and its fineness.
struct StripWish {
  std::vector<std::vector<GroundPlace>> wheels;  ///< frame by frame the same ones, at least one of each
  double radius = 1;                             ///< m, of the largest wheel: sizes are counted in it
  double heading = 0;                            ///< rad, of the strip where the wheels stay in place
  std::size_t most = 0;                          ///< places
};

/// The strip under the wheels and some radii around them, and as far before the first and behind the last frame.
/// Rows and offsets are those of a grid of a 25th of a radius, or of 200 000 places, that straight lines between the
/// kept ones miss by more than a tolerance: a 500th of a radius, more where there would be too many places.
/// look: the road below places.
Strip strip_along(const StripWish& wish,
                  const std::function<std::vector<RoadBelow>(const std::vector<GroundPlace>&)>& look);

}  // namespace mbgen
