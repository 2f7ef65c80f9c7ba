#pragma once
// Parameters that a study varies.

#include <optional>
#include <string>

namespace mbgen {

/// A parameter with a value other than written.
struct VariedParameter {
  std::string name;             ///< ignored if the model has no such parameter
  std::optional<double> value;  ///< instead of the file's, also for a dependent parameter
  bool tunable = false;         ///< whether it can be changed in a solver
};

/// A name that is no parameter: the step of the motion, s, default period of frictions' loads.
constexpr const char* kStepOfMotion = "--step";

}  // namespace mbgen
