#pragma once
// Relations between coordinates, and motions that drive them.

#include <optional>
#include <string>
#include <vector>

#include "compiler/expressions/table.hpp"
#include "compiler/model/bodies.hpp"

namespace mbgen {

/// A relation between coordinates that always holds: the value of an expression over them stays zero, or one of them
/// is a curve over another.
struct Coupling {
  std::string name;
  Where where;
  Quantity relation;                           ///< over positions and parameters; zero; without a curve
  std::optional<CoordinateReference> joint;    ///< of a curve: z(joint) = curve(z(follows))
  std::optional<CoordinateReference> follows;  ///< of a curve
  std::optional<Table> curve;                  ///< cubic or spline, rad or m over rad or m
  /// that stand in it, each once, as they come; of a curve `joint` and `follows`
  std::vector<CoordinateReference> coordinates;
};

/// A driven coordinate: z(t) prescribed; first and second derivatives come from the expression.
struct Motion {
  std::string name;
  Where where;
  CoordinateReference joint;
  Quantity position;  ///< rad or m, of t, parameters, inputs
};

}  // namespace mbgen
