#pragma once
// Parameters that a study varies.

#include <optional>
#include <string>

namespace mbgen {

/// A parameter that is read otherwise than it is written.
struct VariedParameter {
  std::string name;             ///< ignored where the model has no such parameter
  std::optional<double> value;  ///< in place of the file's, also where that follows from other parameters
  bool tunable = false;         ///< whether it can be changed in a solver
};

/// A name that is no parameter: the step of the motion, s, which loads of frictions without a period follow.
constexpr const char* kStepOfMotion = "--step";

}  // namespace mbgen
