#pragma once
// What each stage of the pipeline made, as text for people: --dump=STAGE.

#include <optional>
#include <string>
#include <vector>

#include "compiler/trace/trace.hpp"

namespace mbgen::cli {

/// Names of the stages, in the order of the pipeline.
const std::vector<std::string>& dump_stages();

/// Runs the pipeline up to the stage and prints what it made. set: parameters, see read_set_model; form: of the
/// accelerations from the stage "optimised" on, none for the cheaper one.
/// Fails: UserError for an unknown stage and for a model that does not reach it.
std::string dump_stage(const std::string& path, const std::vector<std::string>& set, const std::string& stage,
                       std::optional<Form> form = {});

}  // namespace mbgen::cli
