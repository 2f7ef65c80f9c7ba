#pragma once
// How far a curve through points swings beyond them.

#include <algorithm>
#include <cstddef>
#include <vector>

namespace mbgen {

struct Overshoot {
  double beyond = 0;      ///< of the range of the points; 0: nowhere
  double at = 0;          ///< argument where it is farthest
  std::size_t piece = 0;  ///< index of the point before it
};

/// The farthest of the places that divide each piece into `parts`. x: arguments of the points; smallest, largest: of
/// their values; curve(piece, x): value of the curve.
template <class Curve>
Overshoot farthest_overshoot(const std::vector<double>& x, double smallest, double largest, int parts,
                             const Curve& curve) {
  Overshoot farthest;
  for (std::size_t i = 0; i + 1 < x.size(); ++i) {
    for (int k = 1; k < parts; ++k) {
      const double at = x[i] + k * (x[i + 1] - x[i]) / parts, value = curve(i, at);
      const double beyond = std::max(smallest - value, value - largest);
      if (beyond > farthest.beyond) farthest = {beyond, at, i};
    }
  }
  return farthest;
}

}  // namespace mbgen
