// The JSON Schema comes from the reader's table of fields: it must be sound and know every field that the reader knows.
#include <gtest/gtest.h>

#include <functional>
#include <nlohmann/json.hpp>
#include <set>

#include "compiler/model/model.hpp"
#include "compiler/reader/fields.hpp"
#include "compiler/reader/read_model.hpp"

namespace mbgen {
namespace {

using Json = nlohmann::json;

TEST(Schema, ReferencesOnlyWhatItDefines) {
  const Json schema = Json::parse(model_schema());
  EXPECT_EQ(schema["$schema"], "https://json-schema.org/draft/2020-12/schema");
  std::set<std::string> used;
  const std::function<void(const Json&)> walk = [&](const Json& node) {
    if (node.is_object() && node.contains("$ref"))
      used.insert(node["$ref"].get<std::string>().substr(std::string("#/$defs/").size()));
    for (const Json& child : node) {
      if (child.is_structured()) walk(child);
    }
  };
  walk(schema);
  std::set<std::string> defined;
  for (const auto& [name, definition] : schema["$defs"].items()) defined.insert(name);
  EXPECT_EQ(used, defined);
}

TEST(Schema, HasEveryFieldOfTheReaderWithADescription) {
  const Json schema = Json::parse(model_schema());
  std::size_t count = 0;
  for (const reading::ObjectKind& kind : reading::object_kinds()) {
    const Json& definition = kind.name == "model" ? schema : schema["$defs"][std::string(kind.name)];
    EXPECT_EQ(definition["additionalProperties"], false) << kind.name;
    for (const reading::FieldInfo& field : kind.fields) {
      const std::string name(field.name);
      ++count;
      ASSERT_TRUE(definition["properties"].contains(name)) << kind.name << "." << name;
      EXPECT_FALSE(definition["properties"][name]["description"].get<std::string>().empty())
          << kind.name << "." << name;
    }
  }
  EXPECT_GT(count, 100u);
}

TEST(Schema, CarriesUnitsDefaultsWordsAndRequirements) {
  const Json definitions = Json::parse(model_schema())["$defs"];
  EXPECT_EQ(definitions["rod"]["required"], Json({"from", "to"}));
  EXPECT_EQ(definitions["air_spring"]["properties"]["ambient"]["default"], 101325);
  EXPECT_EQ(definitions["rod"]["properties"]["mass"]["description"], "mass, uniform along the rod [kg]");
  EXPECT_EQ(definitions["rod"]["properties"]["mass"]["minimum"], 0);
  EXPECT_EQ(definitions["solver"]["properties"]["integrator"]["enum"], Json({"rk4", "abm4", "rosenbrock"}));
  EXPECT_EQ(definitions["solver"]["properties"]["integrator"]["default"], "rk4");
  EXPECT_EQ(definitions["initial"]["properties"]["equilibrium"]["default"], false);
}

}  // namespace
}  // namespace mbgen
