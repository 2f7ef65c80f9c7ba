// JSON Schema of the model format, from the tables of fields.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "compiler/expressions/named_functions.hpp"
#include "compiler/model/model.hpp"
#include "compiler/reader/read_model.hpp"
#include "compiler/reader/reader.hpp"

namespace mbgen {
namespace reading {
namespace {

using Json = nlohmann::ordered_json;

Json reference(std::string_view definition) { return {{"$ref", fmt::format("#/$defs/{}", definition)}}; }

Json array_of(const Json& item, int smallest, int largest) {
  return {{"type", "array"}, {"items", item}, {"minItems", smallest}, {"maxItems", largest}};
}

Json map_of(const Json& item) {
  return {{"type", "object"}, {"propertyNames", reference("name")}, {"additionalProperties", item}};
}

Json either(const Json& first, const Json& second) { return {{"anyOf", Json::array({first, second})}}; }

Json letters() { return {{"enum", {"x", "y", "z", "-x", "-y", "-z"}}}; }

/// Definitions used by several fields.
Json shared_definitions() {
  const Json expression = {{"type", "string"},
                           {"minLength", 1},
                           {"description", fmt::format("expression, for example \"2*k*sin(pi*t)\"; + - * / ^ ( ), pi, "
                                                       "names of parameters, and functions: {}, table('NAME', x)",
                                                       signatures_of_functions())}};
  const Json degrees = {{"type", "object"},
                        {"properties", {{"deg", reference("quantity")}}},
                        {"required", {"deg"}},
                        {"additionalProperties", false},
                        {"description", "angle in degrees"}};
  return {
      {"name",
       {{"type", "string"},
        {"pattern", "^[A-Za-z_][A-Za-z0-9_]*$"},
        {"maxLength", kLongestName},
        {"description", kNameRule}}},
      {"expression", expression},
      {"quantity", either({{"type", "number"}}, reference("expression"))},
      {"angle", {{"anyOf", Json::array({{{"type", "number"}}, reference("expression"), degrees})}}},
      {"vector", array_of(reference("quantity"), 3, 3)},
      {"position",
       {{"anyOf", Json::array({reference("vector"), reference("name")})},
        {"description", "three numbers, or the name of a hardpoint"}}},
      {"axis", {{"anyOf", Json::array({letters(), reference("vector"), reference("axis_by_points")})}}},
      {"attachment",
       {{"type", "string"},
        {"pattern", "^[A-Za-z_][A-Za-z0-9_]*\\.[A-Za-z_][A-Za-z0-9_]*$"},
        {"description", "body.point"}}},
  };
}

/// Schema of a field with several values.
Json shape_of_several(const FieldInfo& info) {
  switch (info.shape) {
    case Shape::quaternion:
      return array_of(reference("quantity"), 4, 4);
    case Shape::inertia:
      return either(array_of(reference("quantity"), 3, 3), array_of(reference("quantity"), 6, 6));
    case Shape::six_by_six:
      return array_of(array_of(reference("quantity"), 6, 6), 6, 6);
    case Shape::attachments:
      return array_of(reference("attachment"), 2, static_cast<int>(info.most));
    case Shape::table_points:
      return {{"type", "array"}, {"items", array_of(reference("quantity"), 2, 2)}, {"minItems", 2}};
    case Shape::numbers:
      return {{"type", "array"}, {"items", reference("quantity")}, {"minItems", 2}};
    case Shape::rows:
      return {{"type", "array"},
              {"items", {{"type", "array"}, {"items", reference("quantity")}, {"minItems", 2}}},
              {"minItems", 2}};
    case Shape::object:
      return reference(info.of);
    case Shape::map:
      return map_of(reference(info.of));
    case Shape::points:
    case Shape::positions:
      return map_of(reference(info.shape == Shape::points ? "vector" : "position"));
    case Shape::parameters:
    case Shape::values:
    case Shape::overrides:
      return map_of(info.shape == Shape::overrides ? reference("angle")
                                                   : either(reference("angle"), reference(info.of)));
    case Shape::names:
      return map_of({{"type", "string"}});
    case Shape::rotations:
      return either(reference(info.of), {{"type", "array"}, {"items", reference(info.of)}});
    case Shape::coefficients:
      return {{"type", "object"},
              {"additionalProperties",
               either(reference("quantity"), {{"type", "array"}, {"items", reference("quantity")}})}};
    case Shape::paths:
      return {{"type", "array"},
              {"items", info.of.empty() ? Json{{"type", "string"}} : either({{"type", "string"}}, reference(info.of))}};
    case Shape::contents:
      return {{"type", "object"}};
    default:
      return {};
  }
}

/// Allowed values of a field, without its description.
Json shape_of(const FieldInfo& info) {
  switch (info.shape) {
    case Shape::boolean:
    case Shape::text:
    case Shape::coordinate:
    case Shape::reference:
      return {{"type", info.shape == Shape::boolean ? "boolean" : "string"}};
    case Shape::word:
      return {{"enum", info.words}};
    case Shape::number:
    case Shape::quantity:
    case Shape::force:
      return reference(info.angle ? "angle" : "quantity");
    case Shape::vector:
    case Shape::quantity_vector:
    case Shape::position:
      return reference(info.shape == Shape::position ? "position" : "vector");
    case Shape::place:
      return either(reference("position"), reference("attachment"));
    case Shape::axis:
      return info.by_points ? reference("axis") : either(letters(), reference("vector"));
    case Shape::attachment:
      return reference("attachment");
    case Shape::equation:
      return either({{"type", "integer"}, {"minimum", 0}}, {{"type", "string"}});
    case Shape::law:
      return either(reference("quantity"), reference("table"));
    case Shape::table:
      return reference("table");
    default:
      return shape_of_several(info);
  }
}

Json field_schema(const FieldInfo& info) {
  Json schema = shape_of(info);
  std::string description(info.doc);
  if (!info.unit.empty()) description += fmt::format(" [{}]", info.unit);
  if (!info.locals.empty()) description += "; an expression";
  schema["description"] = description;
  if (info.shape == Shape::boolean && info.fallback) schema["default"] = *info.fallback != 0;
  if (info.shape != Shape::boolean && info.fallback) schema["default"] = *info.fallback;
  if (!info.fallback_word.empty()) schema["default"] = info.fallback_word;
  // Bounds apply to numbers; a text under the same keyword is not affected.
  if (info.bound == Bound::positive) schema["exclusiveMinimum"] = 0;
  if (info.bound == Bound::not_negative) schema["minimum"] = 0;
  return schema;
}

Json kind_schema(const ObjectKind& kind) {
  Json properties = Json::object(), required = Json::array();
  for (const FieldInfo& info : kind.fields) {
    properties[std::string(info.name)] = field_schema(info);
    if (info.need == Need::required) required.push_back(info.name);
  }
  Json schema = {{"type", "object"}, {"description", kind.doc}, {"properties", properties}};
  if (!required.empty()) schema["required"] = required;
  Json alternatives = Json::array();
  for (const std::string_view name : kind.exactly_one) alternatives.push_back({{"required", Json::array({name})}});
  if (!alternatives.empty()) schema["oneOf"] = alternatives;
  for (const auto& [name, needed] : kind.needs) schema["dependentRequired"][std::string(name)].push_back(needed);
  schema["additionalProperties"] = false;
  return schema;
}

Json definitions_of(const std::vector<ObjectKind>& kinds) {
  Json definitions = shared_definitions();
  for (const ObjectKind& kind : kinds) definitions[std::string(kind.name)] = kind_schema(kind);
  return definitions;
}

}  // namespace

std::string schema_definitions(const std::vector<ObjectKind>& kinds) { return definitions_of(kinds).dump(); }

}  // namespace reading

std::string model_schema() {
  using namespace reading;
  const std::vector<ObjectKind> kinds = object_kinds();
  Json schema = {{"$schema", "https://json-schema.org/draft/2020-12/schema"}, {"title", "mbgen model"}};
  schema.update(kind_schema(kinds.front()));
  schema["properties"]["mbgen"]["const"] = 1;
  schema["$defs"] = definitions_of({kinds.begin() + 1, kinds.end()});
  constexpr int kIndent = 2;
  return schema.dump(kIndent) + "\n";
}

}  // namespace mbgen
