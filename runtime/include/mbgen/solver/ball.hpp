#pragma once
// A ball joint whose angles have two charts, see charts.hpp.

namespace mbgen {

/// A ball whose chart is changed: its coordinates in the order of the tree.
struct Ball {
  int coordinate[3];
  int hand;  ///< 1 where first, second and third axis are right-handed, else -1
};

}  // namespace mbgen
