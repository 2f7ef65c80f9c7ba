#pragma once
// The model format as a document, from its schema.

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace mbgen {

/// The definitions of a schema as sections.
std::string definitions_reference(const nlohmann::ordered_json& schema);

/// A section in Markdown for every object of the schema, with a table of its fields: type, required or not, meaning.
std::string schema_reference(const nlohmann::ordered_json& schema);

}  // namespace mbgen
