#pragma once
// Interface of the reader: JSON text -> Model, or all diagnostics at once.

#include <string>
#include <string_view>
#include <vector>

#include "compiler/model/model.hpp"
#include "compiler/reader/varied.hpp"

namespace mbgen {

/// Reads and checks a model.
/// text: JSON with comments; file_name: its path, used in messages and as the base of `include` paths.
/// Ensures: names resolve, numbers are finite and in range, joints close at the reference configuration.
/// Fails: with every syntactic and semantic problem found, in order of position.
Result<Model> read_model(std::string_view text, const std::string& file_name);

/// Reads a model from a file. Fails as read_model, and if the file cannot be read, is empty or larger than 64 MB.
Result<Model> read_model_file(const std::string& path);

/// JSON Schema (draft 2020-12) of the model format, from the reader's own table of fields.
std::string model_schema();

/// Reads a model from a file. Tunable parameters are allowed in `initial`, which is then valid for their present
/// values: a study reads the model for each value. Fails: as read_model_file, and for a tunable parameter in place of a
/// constant.
Result<Model> read_varied_model(const std::string& path, const std::vector<VariedParameter>& varied);

}  // namespace mbgen
