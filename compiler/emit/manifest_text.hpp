#pragma once
// The manifest: a solver's sizes, names and costs for machines.

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "compiler/emit/context.hpp"

namespace mbgen {

/// The manifest: sizes, names, loop blocks, operation counts of every section of every program, worst case.
nlohmann::ordered_json manifest_json(const EmitContext& context, const std::vector<ShapedProgram>& programs);

/// `<model>.json`.
std::string manifest_text(const nlohmann::ordered_json& manifest);

}  // namespace mbgen
