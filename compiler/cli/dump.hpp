#pragma once
// What each stage of the pipeline made, as text for people: --dump=STAGE.

#include <string>
#include <vector>

namespace mbgen::cli {

/// Names of the stages, in the order of the pipeline.
const std::vector<std::string>& dump_stages();

/// Runs the pipeline up to the stage and prints what it made.
/// Fails: UserError for an unknown stage and for a model that does not reach it.
std::string dump_stage(const std::string& path, const std::string& stage);

}  // namespace mbgen::cli
