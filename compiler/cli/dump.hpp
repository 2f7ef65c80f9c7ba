#pragma once
// The result of each stage of the pipeline, as text for people: --dump=STAGE.

#include <optional>
#include <string>
#include <vector>

#include "compiler/emit/emit.hpp"
#include "compiler/model/model.hpp"
#include "compiler/solver/programs.hpp"

namespace mbgen::cli {

/// Names of the stages, in the order of the pipeline: those of the compiler, code, and passes, which lists the stages
/// with operations and times.
std::vector<std::string> dump_stages();

/// Runs the pipeline up to the stage and gives its result as text. form, options: as the solver is asked for.
/// Fails: UserError for an unknown stage and for a model that does not reach it.
std::string dump_stage(Model model, const std::string& stage, std::optional<Form> form = {}, EmitOptions options = {});

}  // namespace mbgen::cli
