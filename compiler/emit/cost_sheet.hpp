#pragma once
// The cost of a solver before its compilation: operations by kind, and bounds of its loops.

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "compiler/emit/context.hpp"

namespace mbgen {

/// `worst_case` of the manifest: bounds of every loop whose length is not a size of the model, and sums over a call of
/// each function. programs: `programs` of the manifest. See docs/use/cost_sheet.md.
nlohmann::ordered_json worst_case_json(const EmitContext& context, const nlohmann::ordered_json& programs);

/// `<model>_cost.txt`: operations and worst_case of the manifest for people. banner: its first lines.
std::string cost_text(const nlohmann::ordered_json& manifest, const std::string& banner);

/// Operations by kind, and their total.
nlohmann::ordered_json operations_json(const OperationCount& count);

/// One table of operations by kind: a row per section, and the total. section_key: of a section's name.
std::string operations_table(const std::string& title, const nlohmann::ordered_json& sections,
                             const nlohmann::ordered_json& total, const char* section_key);

}  // namespace mbgen
