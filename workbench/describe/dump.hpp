#pragma once
// The result of each stage of the pipeline, as text for people: --dump=STAGE.

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "compiler/compile.hpp"
#include "compiler/emit/emit.hpp"
#include "compiler/model/model.hpp"
#include "compiler/solver/programs.hpp"

namespace mbgen {

/// Names of the stages, in the order of the pipeline: those of the compiler, code, and passes, which lists the stages
/// with operations and times.
std::vector<std::string> dump_stages();

/// The state that emitted code begins with; none where a model has no start.
using StartOf = std::function<std::optional<InitialState>(const Compilation&)>;

/// Runs the pipeline up to the stage and gives its result as text. start: asked for `code` alone. form, options: as the
/// solver is asked for. Fails: UserError for an unknown stage and for a model that does not reach it.
std::string dump_stage(Model model, const std::string& stage, const StartOf& start, std::optional<Form> form = {},
                       EmitOptions options = {});

}  // namespace mbgen
