#pragma once
// Hardpoints: named positions, defined once and used by any body, joint, pose or instance. A body gets a point at a
// hardpoint by a reference to it, as "arm.lower_ball".

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "compiler/expressions/names.hpp"
#include "compiler/model/model.hpp"
#include "compiler/text/document.hpp"

namespace mbgen::reading {

struct Hardpoint {
  std::string name;          ///< in the model
  std::size_t scope = 0;     ///< that defines it
  Place place;               ///< of its key
  Vector3Quantity position;  ///< m, axes of its scope, reference configuration
  bool is_used = false;
};

struct Hardpoints {
  std::vector<Hardpoint> list;
  NameMap<int> names;  ///< as the model knows them
  /// Body and hardpoint -> the body's point there, index into Body::points.
  std::map<std::pair<int, int>, int> points;
};

}  // namespace mbgen::reading
