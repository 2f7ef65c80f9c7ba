#pragma once
// name=value, as typed: inputs of a model, and parameters in place of the values in its file.

#include <string>
#include <vector>

#include "compiler/model/model.hpp"
#include "compiler/reader/varied.hpp"

namespace mbgen {

/// A line with the name that was probably meant, or "".
std::string nearest_hint(const std::string& word, const std::vector<std::string>& candidates);

/// Value of every input of the model: its default, or what `assignments` (name=value) say.
/// Fails: UserError for a name that the model does not have or a value that is no finite number.
std::vector<double> input_values(const Model& model, const std::vector<std::string>& assignments);

/// The parameters that the command line gives, in the order of their names; each stays tunable where it is. Fails:
/// UserError as read_set_model.
std::vector<VariedParameter> set_parameters(const Model& model, const std::vector<std::string>& assignments);

/// The model of a file with other values of parameters: name=value replaces the file's values before anything is
/// folded, and dependent values follow. Its hash then covers file and values. Fails: UserError for a name that is no
/// parameter of the model (the nearest is named), a value that is not a finite number, a name given twice, and as
/// read_model_file.
Model read_set_model(const std::string& path, const std::vector<std::string>& assignments);

}  // namespace mbgen
