#pragma once
// Forces of actuators along a path: positions of coordinates over time, from a table.

#include <string>

#include "workbench/engines/engine.hpp"
#include "workbench/motion/inputs_over_time.hpp"
#include "workbench/motion/path_of_coordinates.hpp"
#include "workbench/results/results.hpp"

namespace mbgen {

/// Adds the outputs actuator.NAME.force, .speed and .power of every actuator.
void add_actuator_outputs(Model& model);

/// Rows of a table along a path.
struct RowsOfPath {
  double step = 0;  ///< s, at most
  long every = 1;   ///< each n-th row is kept, and the last
};

/// Time, the coordinates, all outputs of the model and actuator.NAME.beyond_limit of actuators with a limit, along a
/// path, with the forces that it needs as inputs of the actuators. Other coordinates continue from `start`, loops
/// closed. Requires: the engine has inverse dynamics. Fails: UserError with file and time: the path leaves coordinates
/// open, or leads where loops do not close or forces have no solution.
Results forces_along(const PathOfCoordinates& path, const Engine& engine, const Compilation& compilation,
                     const InputsOverTime& inputs, GenericState start, const RowsOfPath& rows);

/// A column of an actuator: NAME.force, NAME.speed, ...
struct ColumnOfActuators {
  Heading heading;
  double smallest = 0, largest = 0, root_mean_square = 0;
};
std::vector<ColumnOfActuators> columns_of_actuators(const Results& table);

/// These columns for people.
std::string forces_text(const Results& table);

/// A line for each actuator whose force is beyond its limit.
std::vector<std::string> limits_passed(const Model& model, const Results& table);

}  // namespace mbgen
