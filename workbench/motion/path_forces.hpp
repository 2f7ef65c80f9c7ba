#pragma once
// Forces of actuators along a path: positions of coordinates over time, from a table.

#include <string>

#include "workbench/engines/engine.hpp"
#include "workbench/motion/course.hpp"
#include "workbench/motion/inputs_over_time.hpp"
#include "workbench/results/results.hpp"

namespace mbgen {

/// Coordinates over time as cubic splines through the rows of a table.
struct PathOfCoordinates {
  std::vector<int> coordinates;  ///< of the tree
  std::vector<Course> positions, rates, accelerations;
  double start = 0, end = 0;  ///< s
};

/// Reads a table whose header is `t` and names of coordinates, each with an optional unit in brackets. Fails: UserError
/// that names file, place and column; fewer than three rows.
PathOfCoordinates read_path(const std::string& path, const Compilation& compilation);

/// Adds the outputs actuator.NAME.force, .speed and .power of every actuator.
void add_actuator_outputs(Model& model);

/// Time, the coordinates and all outputs of the model in steps of at most `step` seconds along a path, with the forces
/// that it needs as inputs of the actuators. Other coordinates continue from `start`, loops closed.
/// Requires: the engine has inverse dynamics. Fails: UserError with the time: the path leaves coordinates open, or
/// leads where loops do not close or forces have no solution.
Results forces_along(const PathOfCoordinates& path, const Engine& engine, const Compilation& compilation,
                     const InputsOverTime& inputs, GenericState start, double step);

/// Smallest, largest and root mean square value of the columns of actuators, for people.
std::string forces_text(const Results& table);

}  // namespace mbgen
