#pragma once
// Paths: positions of coordinates over time, from a table.

#include <string>
#include <vector>

#include "compiler/compile.hpp"
#include "workbench/motion/course.hpp"

namespace mbgen {

/// Coordinates over time.
struct PathOfCoordinates {
  std::string file;              ///< for messages, "" for none
  std::vector<int> coordinates;  ///< of the tree
  std::vector<Course> positions, rates, accelerations;
  double start = 0, end = 0;  ///< s
};

/// Reads a table whose header is `t` and names of coordinates, NAME or z.NAME, each with an optional unit in brackets:
/// cubic splines through the rows. Columns zd.NAME and zdd.NAME together join their coordinate: polynomials of order
/// five. Fails: UserError that names file, place and column; fewer than three rows; rates or accelerations that
/// contradict the positions.
PathOfCoordinates read_path(const std::string& path, const Compilation& compilation);

}  // namespace mbgen
