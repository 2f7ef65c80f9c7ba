#pragma once
// JSON output.

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace mbgen {

/// A report as printed, with a final newline. Bytes that are no UTF-8, possible in file names, are replaced; control
/// characters of terminals are escaped.
std::string json_text(const nlohmann::ordered_json& report);

}  // namespace mbgen
