#pragma once
// Models whose parameters a study varies.

#include <optional>
#include <string>
#include <vector>

#include "compiler/model/model.hpp"

namespace mbgen {

/// A parameter that is read otherwise than it is written.
struct VariedParameter {
  std::string name;             ///< ignored where the model has no such parameter
  std::optional<double> value;  ///< in place of the file's, also where that follows from other parameters
  bool tunable = false;         ///< whether it can be changed in a solver
};

/// A name that is no parameter: the step of the motion, s, which loads of frictions without a period follow.
constexpr const char* kStepOfMotion = "--step";

/// Reads a model from a file. Tunable parameters may stand in `initial`, which is then that of their values: who varies
/// parameters reads the model for each value. Fails: as read_model_file, and where a tunable parameter stands for a
/// number that has to be constant.
Result<Model> read_varied_model(const std::string& path, const std::vector<VariedParameter>& varied);

}  // namespace mbgen
