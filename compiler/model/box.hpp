#pragma once
// Bounding boxes of points.

#include <algorithm>
#include <cmath>

#include "compiler/model/bodies.hpp"

namespace mbgen {

/// Smallest axis-aligned box around all added points.
struct Box {
  Vector3 low{HUGE_VAL, HUGE_VAL, HUGE_VAL}, high{-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};

  bool is_empty() const { return low[0] > high[0]; }
  /// margin: the point is the centre of a cube with edges of twice this.
  void add(const Vector3& point, double margin = 0) {
    for (std::size_t i = 0; i < 3; ++i) {
      low[i] = std::min(low[i], point[i] - margin);
      high[i] = std::max(high[i], point[i] + margin);
    }
  }
  Vector3 centre() const { return {(low[0] + high[0]) / 2, (low[1] + high[1]) / 2, (low[2] + high[2]) / 2}; }
  /// Length of the diagonal; 0 for an empty box.
  double diagonal() const { return is_empty() ? 0 : std::hypot(high[0] - low[0], high[1] - low[1], high[2] - low[2]); }
};

}  // namespace mbgen
