#pragma once
// When a model has so many free directions that nothing may hold a matrix of them.

#include <cstddef>
#include <vector>

#include "compiler/analysis/findings.hpp"
#include "compiler/formulation/formulation.hpp"

namespace mbgen {

/// Operations of dense equations of the free directions, which grow with the cube, over the least operations of the
/// recursive form (see least_operations), from which on numbers of a model are computed by the latter: from 139 joints
/// of a chain, 149 of a ring and 240 separate four-bars on. Both took the same time at about 70, 200 and 220.
constexpr double kDenseOverRecursive = 100;

constexpr bool has_many_directions(std::size_t free, double least_of_recursion) {
  const auto f = static_cast<double>(free);
  return f * f * f / 3 >= kDenseOverRecursive * least_of_recursion;
}

/// Inertia that each of the coordinates that are asked for moves, while those further out are free, in a position, by
/// the recursive form: kg or kg m^2, of driven coordinates 0. asked: free_coordinates, which name the free directions
/// of the blocks. Cost: linear in bodies, cubic in the free directions of a block that is not opened.
std::vector<double> inertias_by_recursion(const System<double>& system, const Analysis& analysis,
                                          const std::vector<int>& asked);

}  // namespace mbgen
