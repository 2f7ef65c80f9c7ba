#pragma once
// Private to the topology room: references of the model to coordinates.

#include <string>
#include <vector>

#include "compiler/model/model.hpp"

namespace mbgen {

/// One reference to a coordinate; its joint must stay in the tree.
struct CoordinateUse {
  CoordinateReference coordinate;
  std::string user;  ///< for messages, for example "motion steer"
};

/// Coordinates with a law on them: motions, springs, frictions and forces of joints, couplings. An expression that only
/// reads a coordinate does not count.
std::vector<CoordinateUse> coordinates_of_laws(const Model& model);

/// Every reference of the model, in order: motions, forces on joints, expressions, initial values, outputs.
std::vector<CoordinateUse> coordinate_uses(const Model& model);

}  // namespace mbgen
