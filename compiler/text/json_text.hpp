#pragma once
// Reports for machines.

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace mbgen {

/// A report as it is printed, a line feed at its end. Bytes that are no UTF-8, as file names may hold, are replaced;
/// characters that would command a terminal are escaped.
std::string json_text(const nlohmann::ordered_json& report);

}  // namespace mbgen
