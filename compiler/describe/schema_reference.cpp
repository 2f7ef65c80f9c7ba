#include "compiler/describe/schema_reference.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <vector>

namespace mbgen {
namespace {

using Json = nlohmann::ordered_json;

std::string joined(const std::vector<std::string>& parts, const char* between) {
  std::string text;
  for (const std::string& part : parts) text += (text.empty() ? "" : between) + part;
  return text;
}

/// A cell of a table: no bar ends it before its time.
std::string cell(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '|') escaped += '\\';
    escaped += c;
  }
  return escaped;
}

bool has_section(const Json& definition) { return definition.contains("properties"); }

/// Allowed values, in words; names of objects link to their sections.
std::string kind_text(const Json& schema, const Json& value);

std::string reference_text(const Json& schema, const std::string& reference) {
  const std::string name = reference.substr(reference.rfind('/') + 1);
  const Json& definition = schema["$defs"][name];
  if (has_section(definition)) return fmt::format("[{0}](#{0})", name);
  if (name == "quantity") return "number";
  if (name == "attachment") return "body.point";
  return name;
}

std::string array_text(const Json& schema, const Json& value) {
  const std::string item = value.contains("items") ? kind_text(schema, value["items"]) : "any";
  const bool has_size =
      value.contains("minItems") && value.contains("maxItems") && value["minItems"] == value["maxItems"];
  return has_size ? fmt::format("{} of [{}]", value["minItems"].get<int>(), item) : fmt::format("list of [{}]", item);
}

std::string object_text(const Json& schema, const Json& value) {
  const auto members = value.find("additionalProperties");
  if (members != value.end() && members->is_object()) return fmt::format("{{name: {}}}", kind_text(schema, *members));
  return value.contains("properties") && value["properties"].contains("deg") ? "{\"deg\": number}" : "object";
}

std::string kind_text(const Json& schema, const Json& value) {
  if (value.contains("const")) return value["const"].dump();
  if (value.contains("$ref")) return reference_text(schema, value["$ref"].get<std::string>());
  std::vector<std::string> parts;
  if (value.contains("anyOf")) {
    for (const Json& choice : value["anyOf"]) parts.push_back(kind_text(schema, choice));
    return joined(parts, " or ");
  }
  if (value.contains("enum")) {
    for (const Json& word : value["enum"]) parts.push_back(word.dump());
    return joined(parts, ", ");
  }
  const std::string type = value.value("type", "any");
  if (type == "array") return array_text(schema, value);
  if (type == "object") return object_text(schema, value);
  if (type == "string") return value.contains("minLength") ? "expression" : "text";
  return type == "boolean" ? "true or false" : type;
}

/// Bounds and default, after the meaning.
std::string limits_text(const Json& value) {
  std::vector<std::string> parts;
  if (value.contains("minimum")) parts.push_back(fmt::format("at least {}", value["minimum"].dump()));
  if (value.contains("exclusiveMinimum")) parts.push_back(fmt::format("above {}", value["exclusiveMinimum"].dump()));
  if (value.contains("default")) parts.push_back(fmt::format("default {}", value["default"].dump()));
  return parts.empty() ? "" : "; " + joined(parts, ", ");
}

std::string fields_table(const Json& schema, const Json& object) {
  const Json required = object.value("required", Json::array());
  std::string text = "| field | value | meaning |\n|---|---|---|\n";
  for (const auto& [name, value] : object["properties"].items()) {
    const bool is_required = std::find(required.begin(), required.end(), name) != required.end();
    text += fmt::format("| `{}`{} | {} | {}{} |\n", name, is_required ? " (required)" : "",
                        cell(kind_text(schema, value)), cell(value.value("description", "")), limits_text(value));
  }
  return text;
}

}  // namespace

std::string schema_reference(const Json& schema) {
  std::string text =
      "# Model reference\n\n"
      "Every field of the model format, made from its schema: `mbgen schema --markdown`.\n\n"
      "A number may be an expression over parameters above it (`\"2*k*sin(pi*t)\"`), and where forces, motions and "
      "outputs "
      "are meant over inputs, coordinates and t. Units are SI. An angle is in radians, or {\"deg\": number}. A point "
      "is "
      "written `body.point`. An axis is a letter, `\"-y\"`, or a vector. Comments are allowed.\n\n## model\n\n" +
      fields_table(schema, schema);
  for (const auto& [name, definition] : schema["$defs"].items()) {
    if (!has_section(definition)) continue;
    text += fmt::format("\n## {}\n\n{}.\n\n{}", name, definition.value("description", ""),
                        fields_table(schema, definition));
  }
  return text;
}

}  // namespace mbgen
