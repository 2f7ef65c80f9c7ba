#pragma once
// name=value as typed: values of inputs, and of parameters instead of the values in the file.

#include <string>
#include <vector>

#include "compiler/model/model.hpp"
#include "compiler/reader/varied.hpp"

namespace mbgen {

/// A hint with the nearest known name, or "".
std::string nearest_hint(const std::string& word, const std::vector<std::string>& candidates);

/// Value of every input of the model: its default, or its value in `assignments` (name=value). Fails: UserError for an
/// unknown name or a value that is no finite number.
std::vector<double> input_values(const Model& model, const std::vector<std::string>& assignments);

/// Parameters given on the command line, sorted by name; each keeps its tunability, and the ones named in `tuned`
/// become tunable. option: that names them, for messages. Fails: UserError as read_set_model.
std::vector<VariedParameter> set_parameters(const Model& model, const std::vector<std::string>& assignments,
                                            const std::vector<std::string>& tuned = {}, const std::string& option = "");

/// The hash of a model with these values, from the hash of its files; that itself for no values. set: sorted by name.
std::string hash_of_set(const std::string& hash, const std::vector<VariedParameter>& set);

/// The model of a file with changed parameters: name=value replaces the file's values before constant folding, and
/// dependent values follow. Its hash covers file and values. Fails: UserError for a name that is no parameter (the
/// nearest is named), a value that is not a finite number, a repeated name, and as read_model_file.
/// tuned, option: see set_parameters.
Model read_set_model(const std::string& path, const std::vector<std::string>& assignments,
                     const std::vector<std::string>& tuned = {}, const std::string& option = "");

}  // namespace mbgen
