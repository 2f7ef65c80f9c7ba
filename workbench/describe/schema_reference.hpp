#pragma once
// The model format as a document, from its schema.

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace mbgen {

/// The definitions of a schema as sections.
std::string definitions_reference(const nlohmann::ordered_json& schema);

/// Every object of the schema as a section in Markdown, its fields as a table: type of the value, whether it is
/// required, and its meaning.
std::string schema_reference(const nlohmann::ordered_json& schema);

}  // namespace mbgen
