#include "workbench/describe/schema_reference.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <vector>

#include "compiler/expressions/named_functions.hpp"
#include "compiler/model/model.hpp"

namespace mbgen {
namespace {

using Json = nlohmann::ordered_json;

std::string joined(const std::vector<std::string>& parts, const char* between) {
  std::string text;
  for (const std::string& part : parts) text += (text.empty() ? "" : between) + part;
  return text;
}

/// A cell of a table, with bars escaped.
std::string cell(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '|') escaped += '\\';
    escaped += c;
  }
  return escaped;
}

/// As code; empty for an empty text.
std::string quoted(std::string_view text) { return text.empty() ? std::string() : fmt::format("`{}`", text); }

bool has_section(const Json& definition) { return definition.contains("properties"); }

/// Allowed values in words; names of objects become links to their sections.
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

constexpr std::string_view kIntroduction =
    R"text(# Model reference

Every field of the model format, generated from the tables of its reader: `mbgen schema --markdown`.

Units are SI. An angle is in radians, or `{"deg": number}`. Comments are allowed. A number may be an
[expression](#expressions).

A *position* is three numbers, or the name of a hardpoint. Hardpoints are in global axes at the reference
configuration, hardpoints of a subsystem in the subsystem's axes; mbgen transforms them to a body's frame if needed. A
point of a body is written `body.point`; if the body has no such point, `body.hardpoint` is its point at the
hardpoint.

An *axis* is a letter, `"-y"`, a vector of any length, or [two points](#axis_by_points) `{"from": "a", "to": "b"}`.
A letter or a vector is in the frame named by the field, points are in global axes like hardpoints.

)text";

/// Syntax of expressions.
std::string expressions_text() {
  std::string text = R"text(## Expressions

`+ - * / ^`, brackets, numbers, `pi`, names and functions: `"2*k*sin(pi*t)"`. `^` comes first and may be
followed by a sign: `-x^2` is `-(x^2)`, `2^-1` is 0.5. Names are parameters; a parameter may use parameters above it.
Forces, motions and outputs may also use `t` and inputs. Forces, states, sampled values and outputs may use
`z.COORDINATE`, a position, and `zd.COORDINATE`, its velocity, `length.NAME`, the length of a spring, an air
spring or a rod, and `rate.NAME`, its rate, names of states and of sampled values, and the names listed by the field.

| function | value |
|---|---|
)text";
  for (const reading::NamedFunction& function : reading::named_functions())
    text += fmt::format("| `{}({})` | {} |\n", function.name, function.arguments, function.meaning);
  return text + '\n';
}

/// `a`, `b` of "a, b".
std::string quoted_names(std::string_view names) {
  std::string text;
  for (std::size_t start = 0; start < names.size();) {
    const std::size_t end = std::min(names.find(", ", start), names.size());
    text += fmt::format("{}`{}`", start == 0 ? "" : ", ", names.substr(start, end - start));
    start = end + 2;
  }
  return text;
}

/// Names and directions of the coordinates of joints.
std::string coordinates_text() {
  std::string text = R"text(## Coordinates of joints

A joint with one freedom has one coordinate with the name of the joint. A joint with several has these, in their order
from the body at `from` to the body at `to`. Each direction is in the frame of `from`, rotated by
the coordinates before it. Positions are in m and rad.

| joint | for example | coordinates of joint `NAME` | directions |
|---|---|---|---|
)text";
  for (const JointCoordinates& row : joint_coordinates()) {
    text += fmt::format("| {} | {} | {} | {} |\n", name_of(row.type), quoted(row.written),
                        row.names.empty() ? "none" : quoted_names(row.names), row.directions);
  }
  return text + R"text(
The sign of a letter does not matter: `"-x"` gives the names of `"x"`. For a planar joint with another normal, `e` is
the axis of the frame with the largest angle to the normal, projected on the plane and normalised. Names of coordinates
are used in `initial`, `motions`, `joint_springs`, `frictions`, `joint_forces`, outputs, and with `z.` and `zd.` in
expressions.

)text";
}

}  // namespace

std::string definitions_reference(const Json& schema) {
  std::string text;
  for (const auto& [name, definition] : schema["$defs"].items()) {
    if (!has_section(definition)) continue;
    text += fmt::format("\n## {}\n\n{}.\n\n{}", name, definition.value("description", ""),
                        fields_table(schema, definition));
  }
  return text;
}

std::string schema_reference(const Json& schema) {
  return std::string(kIntroduction) + expressions_text() + coordinates_text() + "## model\n\n" +
         fields_table(schema, schema) + definitions_reference(schema);
}

}  // namespace mbgen
