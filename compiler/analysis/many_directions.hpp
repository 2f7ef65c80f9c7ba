#pragma once
// When a model has so many free directions that nothing may hold a matrix of them.

#include <cstddef>
#include <vector>

#include "compiler/analysis/findings.hpp"
#include "compiler/formulation/formulation.hpp"

namespace mbgen {

/// Free directions from which on numbers are computed by the recursive form, where it takes fewer operations. The dense
/// equations grow with the square of the directions in memory and with the cube in time; below they are as fast.
constexpr std::size_t kManyDirections = 256;

/// Whether numbers of a model are computed by the recursive form. least: operations of the forms, see least_operations.
constexpr bool has_many_directions(std::size_t free, double least_of_recursion, double least_of_matrix) {
  return free >= kManyDirections && least_of_recursion < least_of_matrix;
}

/// Inertia that each of the coordinates that are asked for moves, while those further out are free, in a position, by
/// the recursive form: kg or kg m^2, of driven coordinates 0. asked: free_coordinates, which name the free directions
/// of the blocks. Cost: linear in bodies, cubic in the free directions of a block that is not opened.
std::vector<double> inertias_by_recursion(const System<double>& system, const Analysis& analysis,
                                          const std::vector<int>& asked);

}  // namespace mbgen
