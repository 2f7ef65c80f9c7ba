#pragma once
// Private to the topology room: which coordinates the model refers to, and from where.

#include <string>
#include <vector>

#include "compiler/model/model.hpp"

namespace mbgen {

/// One reference to a coordinate: a joint whose coordinate is used must stay in the tree.
struct CoordinateUse {
  CoordinateReference coordinate;
  std::string user;  ///< as people say it, for example "motion steer"
};

/// Coordinates that something in the model is on: motions, springs, frictions and forces of joints, couplings. An
/// expression looks at coordinates, and is on none.
std::vector<CoordinateUse> coordinates_of_laws(const Model& model);

/// Every reference of the model, in order: motions, forces on joints, expressions, initial values, outputs.
std::vector<CoordinateUse> coordinate_uses(const Model& model);

}  // namespace mbgen
