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

/// Names of the stages, in the order of the pipeline: the compiler's, then `code` and `passes`, a list of the stages
/// with operations and times.
std::vector<std::string> dump_stages();

/// Initial state of emitted code; none for a model without a start.
using StartOf = std::function<std::optional<InitialState>(const Compilation&)>;

/// Runs the pipeline up to the stage; its result as text. start: called for `code` alone. form, options: of the solver.
/// Fails: UserError for an unknown stage and for a model that does not reach it.
std::string dump_stage(Model model, const std::string& stage, const StartOf& start, std::optional<Form> form = {},
                       EmitOptions options = {});

}  // namespace mbgen
