#pragma once
// Parameters of a model, and how values of its interface are shown.

#include <optional>
#include <string>

#include "compiler/text/diagnostic.hpp"

namespace mbgen {

/// Texts for people beside the name and unit of a value of the interface; without effect on the motion.
struct Presentation {
  std::string description = {};
  std::string display_unit;        ///< that it is shown in, of the same dimension as its unit; none: its unit
  std::optional<double> min, max;  ///< range that is meant, in its unit
  std::optional<double> nominal;   ///< usual magnitude, in its unit
};

/// A number with a name, of which expressions are made.
struct Parameter {
  std::string name;
  Where where;
  double value = 0;  ///< with the tunable ones at theirs
  std::string unit;
  bool tunable = false;
  int expression =
      -1;  ///< index into Model::expressions: what it is of tunable ones; expressions that use it contain it
  bool at_start = false;  ///< acts on the velocities at the start only: an FMU takes it before the initialisation
  Presentation shown = {};
};

}  // namespace mbgen
