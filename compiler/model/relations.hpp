#pragma once
// Relations between coordinates, and prescribed motions.

#include <optional>
#include <string>
#include <vector>

#include "compiler/expressions/table.hpp"
#include "compiler/model/bodies.hpp"

namespace mbgen {

/// A constraint between coordinates: an expression over them is zero, or one is a curve over another.
struct Coupling {
  std::string name;
  Where where;
  Quantity relation;                           ///< over positions and parameters, zero; unused for a curve
  std::optional<CoordinateReference> joint;    ///< of a curve: z(joint) = curve(z(follows))
  std::optional<CoordinateReference> follows;  ///< of a curve
  std::optional<Table> curve;                  ///< cubic or spline, rad or m over rad or m
  /// its coordinates, each once, in order of appearance; for a curve `joint` and `follows`
  std::vector<CoordinateReference> coordinates;
};

/// A prescribed coordinate z(t); its first and second derivatives come from the expression.
struct Motion {
  std::string name;
  Where where;
  CoordinateReference joint;
  Quantity position;  ///< rad or m, of t, parameters, inputs
  bool is_actuated = false;  ///< inverse dynamics finds forces of actuators in place of the driving force
};

}  // namespace mbgen
