// Good models: bushings and bump stops, their axes and what they take from others.
#include <gtest/gtest.h>

#include "compiler/model/auxiliary_states.hpp"
#include "tests/support/model_support.hpp"

namespace mbgen {
namespace {

const std::string kBetween = R"("from": "ground.T", "to": "arm.B")";

TEST(Bushings, AxesAndFreedoms) {
  const Model model =
      read(arm_model(R"("bushings": {
    "plain": { )" + kBetween +
                     R"(, "tz": { "stiffness": 100, "preload": -4 } },
    "sleeve": { )" + kBetween +
                     R"(, "axis": "-y", "radial": { "stiffness": 7, "maxwell_stiffness": 5, "maxwell_time": 0.2 },
                "conical": { "force": "deflection^3 + rate" } },
    "turned": { )" + kBetween +
                     R"(, "axis": [0, 0, 2], "axis2": [0, 3, 1], "rz": { "damping": 2 } } })"));
  ASSERT_EQ(model.bushings.size(), 3u);
  EXPECT_EQ(model.bushings[0].axes, (Matrix3{1, 0, 0, 0, 1, 0, 0, 0, 1}));
  EXPECT_EQ(model.bushings[0].freedoms[2]->preload.value, -4);
  EXPECT_FALSE(model.bushings[0].freedoms[0]);
  EXPECT_FALSE(model.bushings[0].is_mirrored);
  // Columns x, y, z: z against y, x the letter after it.
  EXPECT_EQ(model.bushings[1].axes, (Matrix3{0, -1, 0, 0, 0, -1, 1, 0, 0}));
  for (const int i : {0, 1}) {
    EXPECT_EQ(std::get<Quantity>(*model.bushings[1].freedoms[i]->stiffness).value, 7);
    EXPECT_TRUE(has_maxwell_branch(model.bushings[1], i));
  }
  EXPECT_TRUE(model.bushings[1].freedoms[4]->force);
  EXPECT_EQ(model.bushings[2].axes, (Matrix3{0, -1, 0, 1, 0, 0, 0, 0, 1}));
  const std::vector<AuxiliaryState> states = auxiliary_states(model);
  ASSERT_EQ(states.size(), 2u);
  EXPECT_EQ(states[0].name, "sleeve_tx");
  EXPECT_EQ(states[1].name, "sleeve_ty");
}

TEST(BumpStops, TakeTheEndsOfSprings) {
  const Model model = read(arm_model(R"("springs": { "strut": { )" + kBetween + R"(, "stiffness": 5 } }, "bump_stops": {
    "bump": { "spring": "strut", "clearance": 0.1, "stiffness": 9 },
    "turn": { "joint": "pin", "side": "below", "clearance": { "deg": 180 }, "stiffness": 9, "exponent": 2 } },
    "outputs": { "a": { "bump_stop": "turn" }, "b": { "bump_stop": "turn", "quantity": "rate" },
                 "c": { "bump_stop": "bump", "quantity": "deflection" } })"));
  ASSERT_EQ(model.bump_stops.size(), 2u);
  EXPECT_EQ(model.bump_stops[0].from.body, model.springs[0].from.body);
  EXPECT_EQ(model.bump_stops[0].to.point, model.springs[0].to.point);
  EXPECT_EQ(model.bump_stops[0].side, BumpStop::Side::compression);
  EXPECT_NEAR(model.bump_stops[1].clearance.value, 3.14159265358979, 1e-14);
  EXPECT_EQ(model.outputs[0].unit, "N m");
  EXPECT_EQ(model.outputs[1].unit, "rad/s");
  EXPECT_EQ(model.outputs[2].unit, "m");
}

}  // namespace
}  // namespace mbgen
