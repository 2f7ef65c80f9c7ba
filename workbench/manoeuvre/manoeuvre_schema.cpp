// JSON Schema and reference of manoeuvre files, from the tables of fields.

#include <nlohmann/json.hpp>

#include "workbench/describe/schema_reference.hpp"
#include "workbench/manoeuvre/tables_manoeuvre.hpp"

namespace mbgen {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view kIntroduction = R"text(# Manoeuvre reference

Every field of manoeuvre files, made from the tables of their reader: `mbgen schema --manoeuvre --markdown`. How they
are used stands in [manoeuvres.md](manoeuvres.md).

Units are SI. A number may be an expression without names, as `"80/3.6"`; an angle is in radians, or
`{"deg": number}`. Comments are allowed. The field `type` says which of the tables holds.
)text";

Json schema_of_files() {
  Json definitions = Json::parse(reading::schema_definitions(reading::manoeuvre_kinds()));
  Json types = Json::array();
  for (const std::string_view type : reading::manoeuvre_types()) {
    Json& properties = definitions[std::string(type)]["properties"];
    properties["mbgen_manoeuvre"]["const"] = 1;
    properties["type"]["const"] = type;
    types.push_back({{"$ref", "#/$defs/" + std::string(type)}});
  }
  return {{"$schema", "https://json-schema.org/draft/2020-12/schema"},
          {"title", "mbgen manoeuvre"},
          {"oneOf", types},
          {"$defs", definitions}};
}

}  // namespace

std::string manoeuvre_schema() {
  constexpr int kIndent = 2;
  return schema_of_files().dump(kIndent) + "\n";
}

std::string manoeuvre_reference() { return std::string(kIntroduction) + definitions_reference(schema_of_files()); }

}  // namespace mbgen
