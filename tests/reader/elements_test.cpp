// Good models: rods, force elements, tyres, motions, outputs, initial state; their defaults and what they refer to.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "compiler/expressions/evaluate.hpp"
#include "compiler/model/element_access.hpp"
#include "mbgen/tyres/tyre.hpp"
#include "tests/support/model_support.hpp"

namespace mbgen {
namespace {

const std::string kEnds = R"("from": "ground.T", "to": "arm.B")";
const std::string kTyreData = R"("tyre_data": { "rubber": { "model": "pac2002",
  "coefficients": { "UNLOADED_RADIUS": 0.5, "FNOMIN": 30000, "PCX1": 1.6, "LMUX": "0.5*2" } } })";

std::size_t field_index(const std::string& name) {
  std::size_t index = 0;
  while (kPac2002Fields[index].name != name) ++index;
  return index;
}

TEST(Rods, Defaults) {
  const Model model =
      read(arm_model("\"rods\": { \"a\": { " + kEnds + " }, \"b\": { " + kEnds + ", \"mass\": 2, \"length\": 3 } }"));
  EXPECT_EQ(model.rods[0].mass.value, 0);
  EXPECT_FALSE(model.rods[0].length);
  EXPECT_EQ(model.rods[1].mass.value, 2);
  EXPECT_EQ(model.rods[1].length->value, 3);
  EXPECT_EQ(model.rods[0].from.body, 0);
  EXPECT_EQ(model.rods[0].from.point, 1);
  EXPECT_EQ(model.rods[0].to.body, 1);
  EXPECT_EQ(model.rods[0].to.point, 1);
}

TEST(Couplings, KnowTheCoordinatesOfTheirRelation) {
  const Model model = read(R"json({ "mbgen": 1, "parameters": { "r": { "value": 0.2, "tunable": true } },
    "bodies": { "ground": { "points": { "O": [0, 0, 0] } }, "rack": { "points": { "O": [0, 0, 0] } },
                "pinion": { "points": { "O": [0, 0, 0] } } },
    "joints": { "pin": { "type": "revolute", "from": "ground.O", "to": "pinion.O", "axis": "y" },
                "slide": { "type": "prismatic", "from": "ground.O", "to": "rack.O", "axis": "x" } },
    "couplings": { "teeth": { "relation": "z.slide - r*z.pin + 0.1*z.slide^3" } },
    "outputs": { "force": { "multiplier": "teeth" } } })json");
  ASSERT_EQ(model.couplings.size(), 1u);
  EXPECT_EQ(model.couplings[0].coordinates, (std::vector<CoordinateReference>{{1, 0}, {0, 0}}));
  EXPECT_EQ(std::get<MultiplierOutput>(model.outputs[0].source).coupling, 0);
  EXPECT_EQ(model.outputs[0].unit, "");
}

TEST(Springs, LawsTablesAndExpressions) {
  const Model model =
      read(arm_model(R"("inputs": { "level": { "default": 0.5 } }, "springs": {
    "linear": { )" + kEnds +
                     R"(, "stiffness": 100, "damping": "10 + 2*level", "free_length": 0.3, "preload": -4 },
    "table": { )" + kEnds +
                     R"(, "stiffness": { "table": [[-1, "-2^3"], [0, 0], [2, 5]], "interpolation": "monotone_cubic" } },
    "law": { )" + kEnds +
                     R"(, "force": "3*length + rate*z.pin" } })"));
  const PointSpring& linear = model.springs[0];
  EXPECT_EQ(std::get<Quantity>(*linear.stiffness).value, 100);
  EXPECT_EQ(std::get<Quantity>(*linear.damping).value, 11);
  EXPECT_GE(std::get<Quantity>(*linear.damping).expression, 0);
  EXPECT_EQ(linear.free_length->value, 0.3);
  EXPECT_EQ(linear.preload.value, -4);
  EXPECT_FALSE(linear.force);
  const Table& table = std::get<Table>(*model.springs[1].stiffness);
  EXPECT_EQ(table.interpolation, Table::Interpolation::monotone_cubic);
  EXPECT_EQ(table.x, (std::vector<double>{-1, 0, 2}));
  EXPECT_EQ(table.y, (std::vector<double>{-8, 0, 5}));
  EXPECT_FALSE(model.springs[1].free_length);
  ASSERT_TRUE(model.springs[2].force);
  EXPECT_EQ(model.expressions[static_cast<std::size_t>(*model.springs[2].force)].text, "3*length + rate*z.pin");
}

TEST(JointSprings, DegreesAndRelativeCoordinate) {
  const Model model =
      read(arm_model(R"("joint_springs": { "s": { "joint": "pin", "stiffness": 1, "free": { "deg": 180 } } })"));
  EXPECT_EQ(model.joint_springs[0].free.value, std::numbers::pi);
  EXPECT_EQ(model.joint_springs[0].preload.value, 0);
  EXPECT_FALSE(model.joint_springs[0].relative_to);
  EXPECT_EQ(model.joint_springs[0].joint, (CoordinateReference{0, 0}));
}

struct TwoParameters {
  double parameter(int) const { return 0.5; }
  double input(int) const { return 0; }
  double time() const { return 0; }
  double position(CoordinateReference) const { return 0; }
  double velocity(CoordinateReference) const { return 0; }
  double local(int) const { return 0; }
};

TEST(Frictions, StictionAndStribeckVelocityHaveDefaults) {
  const Model model = read(arm_model(R"("parameters": { "v": { "value": 0.01, "tunable": true } }, "frictions": {
    "a": { "joint": "pin", "coulomb": 3, "velocity": 0.02 },
    "b": { "joint": "pin", "coulomb": 3, "stiction": 4, "velocity": "v", "viscous": 5 } })"));
  EXPECT_EQ(model.frictions[0].stiction.value, 3);
  EXPECT_EQ(model.frictions[0].viscous.value, 0);
  EXPECT_EQ(model.frictions[0].stribeck_velocity.value, 0.2);
  EXPECT_EQ(model.frictions[1].stiction.value, 4);
  EXPECT_EQ(model.frictions[1].stribeck_velocity.value, 0.1);
  // The default follows the tunable parameter.
  EXPECT_EQ(evaluate<double>(model.frictions[1].stribeck_velocity, model.expressions, TwoParameters{}), 5);
}

TEST(AirSprings, VolumeIsANumberOrATable) {
  const Model model = read(arm_model(R"("air_springs": {
    "a": { )" + kEnds + R"(, "pressure": 6e5, "area": 0.01, "volume": 0.002 },
    "b": { )" + kEnds + R"(, "pressure": 6e5, "area": { "table": [[0.1, 0.01], [0.3, 0.02]] },
           "volume": { "table": [[0.1, 0.001], [0.3, 0.003]] }, "length": 0.2, "ambient": 9e4, "exponent": 1.3 } })"));
  EXPECT_EQ(model.air_springs[0].volume0.value, 0.002);
  EXPECT_FALSE(model.air_springs[0].volume);
  EXPECT_FALSE(model.air_springs[0].length);
  EXPECT_EQ(model.air_springs[0].ambient.value, 101325);
  EXPECT_EQ(model.air_springs[0].exponent.value, 1.38);
  EXPECT_EQ(model.air_springs[1].volume->y[1], 0.003);
  EXPECT_EQ(std::get<Table>(model.air_springs[1].area).x[1], 0.3);
  EXPECT_EQ(model.air_springs[1].length->value, 0.2);
  EXPECT_EQ(model.air_springs[1].exponent.value, 1.3);
}

TEST(Forces, AxesAndExpressions) {
  const Model model = read(arm_model(R"("forces": {
    "a": { "at": "arm.B", "force": [0, 0, "-2*t"] },
    "b": { "at": "arm.B", "torque": [1, 2, 3], "axes": "body" } },
    "joint_forces": { "m": { "joint": "pin", "force": "-3*zd.pin" } })"));
  EXPECT_FALSE(model.forces[0].in_body_axes);
  EXPECT_GE(model.forces[0].force[2].expression, 0);
  EXPECT_EQ(model.forces[0].torque[0].value, 0);
  EXPECT_TRUE(model.forces[1].in_body_axes);
  EXPECT_EQ(model.forces[1].torque[2].value, 3);
  EXPECT_GE(model.joint_forces[0].force.expression, 0);
}

TEST(Tyres, DefaultsAndCoefficients) {
  const Model model =
      read(arm_model(kTyreData + R"(, "tyres": { "w": { "centre": "arm.B", "data": "rubber", "stiffness": 1e6 },
    "twin": { "centre": "arm.B", "axis": "x", "data": "rubber", "stiffness": 1e6,
      "count": 2, "side": -1, "radius": 0.6 } })"));
  const Tyre& tyre = model.tyres[0];
  EXPECT_EQ(tyre.model, TyreModel::pac2002);
  ASSERT_EQ(tyre.coefficients.size(), std::size(kPac2002Fields));
  EXPECT_EQ(tyre.coefficients[field_index("PCX1")].value, 1.6);
  EXPECT_EQ(tyre.coefficients[field_index("FNOMIN")].value, 30000);
  EXPECT_EQ(tyre.coefficients[field_index("LMUX")].value, 1);
  EXPECT_EQ(tyre.coefficients[field_index("LKY")].value, 1) << "scaling factors are 1 unless given";
  EXPECT_EQ(tyre.coefficients[field_index("PDY1")].value, 0) << "all others are 0";
  EXPECT_EQ(tyre.axis, (Vector3{0, 1, 0}));
  EXPECT_EQ(tyre.radius.value, 0.5) << "UNLOADED_RADIUS";
  EXPECT_EQ(tyre.damping.value, 0);
  EXPECT_EQ(tyre.road_height.value, 0);
  EXPECT_EQ(tyre.friction.value, 1);
  EXPECT_EQ(tyre.rolling_resistance.value, 0.007);
  EXPECT_EQ(tyre.relaxation_x.value, 0.3);
  EXPECT_EQ(tyre.relaxation_y.value, 0.6);
  EXPECT_EQ(tyre.low_speed.value, 2);
  EXPECT_EQ(tyre.side, 1);
  EXPECT_EQ(tyre.count, 1);
  EXPECT_EQ(model.tyres[1].side, -1);
  EXPECT_EQ(model.tyres[1].count, 2);
  EXPECT_EQ(model.tyres[1].radius.value, 0.6);
  EXPECT_EQ(model.tyres[1].axis, (Vector3{1, 0, 0}));
}

TEST(Tyres, Pac89TakesArraysInOrder) {
  const auto array = [](int first, int count) {
    std::string text;
    for (int i = 0; i < count; ++i) text += (i ? ", " : "") + std::to_string(first + i);
    return "[" + text + "]";
  };
  const Model model =
      read(arm_model(R"("tyre_data": { "old": { "model": "pac89", "coefficients": { "c": )" + array(300, kPac89CCount) +
                     R"(, "a": )" + array(100, kPac89ACount) + R"(, "b": )" + array(200, kPac89BCount) + R"( } } },
    "tyres": { "w": { "centre": "arm.B", "data": "old", "stiffness": 1e6, "radius": 0.5 } })"));
  const std::vector<Quantity>& coefficients = model.tyres[0].coefficients;
  ASSERT_EQ(coefficients.size(), 43u);
  EXPECT_EQ(coefficients[13].value, 113);
  EXPECT_EQ(coefficients[14].value, 200);
  EXPECT_EQ(coefficients[24].value, 210);
  EXPECT_EQ(coefficients[25].value, 300);
  EXPECT_EQ(coefficients[42].value, 317);
}

TEST(Outputs, SourcesAndUnits) {
  const Model model =
      read(arm_model(kTyreData + R"(, "tyres": { "w": { "centre": "arm.B", "data": "rubber", "stiffness": 1e6 } },
    "springs": { "s": { )" +
                     kEnds + R"(, "stiffness": 1 } }, "motions": { "d": { "joint": "pin", "angle": "0.1*t^2" } },
    "outputs": {
      "e": { "unit": "J", "expression": "z.pin^2" },
      "p": { "point": "arm.B", "quantity": "acceleration", "axis": "z", "frame": "body" },
      "q": { "joint": "pin", "quantity": "velocity" },
      "l": { "tyre": "w", "quantity": "lateral_force" },
      "r": { "spring": "s", "quantity": "rate" },
      "m": { "motion": "d" },
      "position": { "joint": "pin" } })"));
  const std::vector<Output>& outputs = model.outputs;
  EXPECT_GE(std::get<ExpressionOutput>(outputs[0].source).value.expression, 0);
  EXPECT_EQ(outputs[0].unit, "J");
  const auto& point = std::get<PointOutput>(outputs[1].source);
  EXPECT_EQ(point.what, PointOutput::What::acceleration);
  EXPECT_EQ(point.axis, 2);
  EXPECT_TRUE(point.in_body_axes);
  EXPECT_EQ(outputs[1].unit, "m/s^2");
  EXPECT_EQ(std::get<CoordinateOutput>(outputs[2].source).what, CoordinateOutput::What::velocity);
  EXPECT_EQ(outputs[2].unit, "rad/s");
  const auto element = [&](std::size_t i) { return std::get<ElementOutput>(outputs[i].source); };
  EXPECT_EQ(element(3).kind, kKindIndex<Tyre>);
  EXPECT_STREQ(quantity_of(element(3)).name, "lateral_force");
  EXPECT_EQ(element(3).element, 0);
  EXPECT_EQ(element(4).kind, kKindIndex<PointSpring>);
  EXPECT_STREQ(quantity_of(element(4)).name, "rate");
  EXPECT_EQ(element(4).element, 0);
  EXPECT_EQ(outputs[4].unit, "m/s");
  EXPECT_EQ(std::get<DriveOutput>(outputs[5].source).motion, 0);
  EXPECT_EQ(outputs[5].unit, "N m");
  EXPECT_EQ(std::get<CoordinateOutput>(outputs[6].source).what, CoordinateOutput::What::position);
}

TEST(Initial, PositionsVelocitiesAndSolver) {
  const Model model = read(arm_model(R"("initial": { "equilibrium": true, "positions": { "pin": { "deg": 90 } },
    "velocities": { "pin": "2*pi" } }, "solver": { "integrator": "abm4", "step": "1e-3/2",
      "duration": 0, "closure_tolerance": 1e-9 })"));
  EXPECT_TRUE(model.initial.equilibrium);
  EXPECT_EQ(model.initial.positions[0].value, std::numbers::pi / 2);
  EXPECT_EQ(model.initial.velocities[0].value, 2 * std::numbers::pi);
  EXPECT_EQ(model.solver.integrator, SolverSettings::Integrator::abm4);
  EXPECT_EQ(model.solver.step, 5e-4);
  EXPECT_EQ(model.solver.duration, 0);
  EXPECT_EQ(model.solver.closure_tolerance, 1e-9);
}

TEST(Initial, ValuesSayWhatGivesWay) {
  const Model model = read(arm_model(R"("parameters": { "w": 3 }, "initial": {
    "positions": { "pin": { "value": { "deg": 90 }, "weight": "2*w" } },
    "velocities": { "pin": { "value": 4, "locked": true } } })"));
  EXPECT_EQ(model.initial.positions[0].value, std::numbers::pi / 2);
  EXPECT_EQ(model.initial.positions[0].weight, 6);
  EXPECT_FALSE(model.initial.positions[0].locked);
  EXPECT_EQ(model.initial.velocities[0].value, 4);
  EXPECT_EQ(model.initial.velocities[0].weight, 1);
  EXPECT_TRUE(model.initial.velocities[0].locked);
}

}  // namespace
}  // namespace mbgen
