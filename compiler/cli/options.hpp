#pragma once
// Arguments that several commands share.

#include <optional>
#include <string>
#include <vector>

#include "compiler/cli/command_line.hpp"
#include "compiler/cli/engine.hpp"

namespace mbgen::cli {

/// MODEL, the first argument of most commands.
void add_model_argument(NamedCommand command, std::string& path);

/// --json
void add_json_option(NamedCommand command, bool& json);

/// --form recursive|matrix
void add_form_option(NamedCommand command, std::string& form);

/// The form that was typed, none for "". Fails: UserError for a form that there is not.
std::optional<Form> chosen_form(const std::string& typed);

/// --dump=STAGE
void add_dump_option(NamedCommand command, std::string& stage);

/// --batch: 4 or 8 instances a call, 0 when it is not given.
void add_batch_option(NamedCommand command, int& lanes);

/// --scalar double|float
void add_scalar_option(NamedCommand command, std::string& scalar);

/// Engine and inputs as typed.
struct EngineArguments {
  EngineChoice choice;
  std::string linear_algebra, factorisation, stabilisation;  ///< "" for the default
  std::vector<std::string> inputs;                           ///< name=value
};

/// A line with the name that was probably meant, or "".
std::string nearest_hint(const std::string& word, const std::vector<std::string>& candidates);

/// --input
void add_input_option(NamedCommand command, std::vector<std::string>& inputs);

/// --input, --no-cache
void add_run_options(NamedCommand command, EngineArguments& arguments);

/// --engine, --linear-algebra, --factorisation, --stabilisation and the run options
void add_engine_options(NamedCommand command, EngineArguments& arguments);

/// The engine that the arguments choose. Fails: UserError for a linear algebra, factorisation or stabilisation that is
/// unknown, or that the engine does not let one choose, and for QR without Eigen.
EngineChoice chosen_engine(const EngineArguments& arguments);

/// Value of every input of the model: its default, or its value in `assignments` (name=value).
/// Fails: UserError for a name that the model does not have or a value that is no finite number.
std::vector<double> input_values(const Model& model, const std::vector<std::string>& assignments);

}  // namespace mbgen::cli
