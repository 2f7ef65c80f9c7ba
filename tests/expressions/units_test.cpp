// Units of the model file: in terms of the base units, and where they contradict.

#include <gtest/gtest.h>

#include "compiler/expressions/unit_exponents.hpp"
#include "tests/support/model_support.hpp"

namespace mbgen {
namespace {

using Exponents = std::array<int, 8>;  // kg m s A K mol cd rad

void expect_unit(const char* unit, const Exponents& exponents, double factor = 1) {
  const std::optional<UnitExponents> meaning = unit_exponents(unit);
  ASSERT_TRUE(meaning.has_value()) << unit;
  EXPECT_EQ(meaning->exponents, exponents) << unit;
  EXPECT_DOUBLE_EQ(meaning->factor, factor) << unit;
}

TEST(UnitExponents, ReadsProductsAndQuotients) {
  expect_unit("m", {0, 1});
  expect_unit("N m", {1, 2, -2});
  expect_unit("N*m", {1, 2, -2});
  expect_unit("N.m", {1, 2, -2});
  expect_unit("N m s/rad", {1, 2, -1, 0, 0, 0, 0, -1});
  expect_unit("N/(m/s)", {1, 0, -1});
  expect_unit("kg m^2", {1, 2});
  expect_unit("1/s", {0, 0, -1});
  expect_unit("m s^-2", {0, 1, -2});
  expect_unit("rad/s^2", {0, 0, -2, 0, 0, 0, 0, 1});
  expect_unit("1", {});
}

TEST(UnitExponents, ScalesWhatIsNotSi) {
  expect_unit("km/h", {0, 1, -1}, 1000.0 / 3600);
  expect_unit("mm", {0, 1}, 1e-3);
  expect_unit("bar", {1, -1, -2}, 1e5);
  expect_unit("mm^2", {0, 2}, 1e-6);
}

TEST(UnitExponents, KnowsWhatItDoesNotKnow) {
  for (const char* unit : {"", "furlong", "N/", "N m)", "(N", "m^", "m^x", "/s", "^2"}) {
    EXPECT_FALSE(unit_exponents(unit).has_value()) << unit;
  }
}

TEST(Units, UnknownOnesAreNotedWithTheirPlace) {
  const Model model = read(arm_model(R"("inputs": { "push": { "unit": "kn" }, "pull": { "unit": "N" } },
    "outputs": { "angle": { "joint": "pin", "unit": "rad" } })"));
  ASSERT_EQ(model.notes.size(), 1u);
  EXPECT_EQ(model.notes[0].where.pointer, "/inputs/push/unit");
  EXPECT_EQ(model.notes[0].where.line, 6);
  EXPECT_TRUE(model.notes[0].message.starts_with("unit \"kn\" is not known")) << model.notes[0].message;
}

TEST(Units, ThoseOfAnotherScaleAreRefusedAndThoseOfTheSameAreNot) {
  const auto of_output = [](const char* unit) {
    return messages(
        arm_model(std::string(R"("outputs": { "x": { "point": "arm.B", "axis": "x", "unit": ")") + unit + R"(" } })"));
  };
  EXPECT_EQ(of_output("m"), "");
  EXPECT_EQ(of_output("N m/N"), "");
  EXPECT_NE(of_output("mm").find("/outputs/x/unit: the unit is \"mm\", the unit of the value is \"m\""),
            std::string::npos);
  EXPECT_NE(of_output("mm").find("\"display_unit\": \"mm\""), std::string::npos);
  EXPECT_NE(of_output("m/s").find("the unit of the value is"), std::string::npos);
}

TEST(Presentation, IsReadForWhatIsExported) {
  const Model model = read(arm_model(R"("description": "an arm", "author": "Eve", "version": "2", "licence": "none",
    "inputs": { "push": { "unit": "N", "min": -1, "max": 1, "nominal": 0.5, "description": "by hand" } },
    "outputs": { "w": { "joint": "pin", "quantity": "velocity", "display_unit": "rpm" } },
    "solver": { "tolerance": 1e-4 })"));
  EXPECT_EQ(model.about.description, "an arm");
  EXPECT_EQ(model.about.author, "Eve");
  EXPECT_EQ(model.about.version, "2");
  EXPECT_EQ(model.about.licence, "none");
  ASSERT_EQ(model.inputs.size(), 1u);
  EXPECT_EQ(model.inputs[0].shown.min, -1);
  EXPECT_EQ(model.inputs[0].shown.max, 1);
  EXPECT_EQ(model.inputs[0].shown.nominal, 0.5);
  EXPECT_EQ(model.inputs[0].shown.description, "by hand");
  EXPECT_EQ(model.outputs.at(0).shown.display_unit, "rpm");
  EXPECT_EQ(model.outputs.at(0).unit, "rad/s");
  EXPECT_EQ(model.solver.tolerance, 1e-4);
}

TEST(Presentation, ParametersOfTheStartStandInVelocities) {
  const Model model = read(arm_model(R"("parameters": { "v": { "value": 3, "at_start": true } },
    "initial": { "velocities": { "pin": "2*v" } })"));
  ASSERT_EQ(model.initial.velocities.size(), 1u);
  EXPECT_EQ(model.initial.velocities[0].value, 6);
  EXPECT_GE(model.initial.velocities[0].expression, 0);
}

}  // namespace
}  // namespace mbgen
