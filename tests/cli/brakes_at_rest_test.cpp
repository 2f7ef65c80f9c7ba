// Brakes in linear equations, steady motions and at rest: a bristle that nothing presses holds nothing, one that sticks
// holds what it can.

#include <cmath>
#include <complex>

#include "tests/support/cli_support.hpp"

namespace mbgen::cli_test {
namespace {

/// A wheel in the air with a brake.
std::string flywheel(double rate) {
  return fmt::format(
      R"({{ "mbgen": 1, "name": "fly", "gravity": [0, 0, 0], "inputs": {{ "brake": {{ "unit": "N m" }} }},
  "bodies": {{ "ground": {{ "points": {{ "o": [0, 0, 0] }} }}, "w": {{ "mass": 1, "inertia": [1, 1, 1], "points": {{ "o": [0, 0, 0] }} }} }},
  "joints": {{ "w": {{ "type": "revolute", "from": "ground.o", "to": "w.o", "axis": "y" }} }},
  "frictions": {{ "b": {{ "joint": "w", "law": "elasto_plastic", "coulomb": "brake", "stiffness": 2e4, "damping": 60 }} }},
  "outputs": {{ "rate": {{ "unit": "rad/s", "expression": "zd.w" }} }},
  "initial": {{ "velocities": {{ "w": {} }} }} }})",
      rate);
}

/// A wheel or two on a rail, in a car of 300 kg that drag slows; brake: whether the wheels have brakes.
std::string rail(bool has_two, bool has_brake) {
  const std::string brake = R"("law": "elasto_plastic", "coulomb": "brake", "stiffness": 3e4, "damping": 60 })";
  std::string text =
      R"({ "mbgen": 1, "name": "rail", "inputs": { "drive": { "unit": "N m" }, "brake": { "unit": "N m" } },
  "bodies": { "ground": { "points": { "start": [0, 0, 0.3] } }, "rail": { "points": { "slot": [0, 0, 0.3] } },
    "car": { "mass": 300, "com": [0, 0, 0.3], "inertia": [1, 1, 1], "points": { "hub": [0, 0, 0.3], "hub2": [-2, 0, 0.3] } },
)" +
      std::string(
          has_two
              ? R"(    "wheel2": { "mass": 18, "com": [-2, 0, 0.3], "inertia": [0.6, 1, 0.6], "points": { "centre": [-2, 0, 0.3] } },
)"
              : "") +
      R"(    "wheel": { "mass": 18, "com": [0, 0, 0.3], "inertia": [0.6, 1, 0.6], "points": { "centre": [0, 0, 0.3] } } },
  "joints": { "along": { "type": "prismatic", "from": "ground.start", "to": "rail.slot", "axis": "x" },
    "up": { "type": "prismatic", "from": "rail.slot", "to": "car.hub", "axis": "z" },
)" +
      std::string(has_two
                      ? R"(    "wheel2": { "type": "revolute", "from": "car.hub2", "to": "wheel2.centre", "axis": "y" },
)"
                      : "") +
      R"(    "wheel": { "type": "revolute", "from": "car.hub", "to": "wheel.centre", "axis": "y" } },
  "tyre_data": { "summer": { "model": "pac2002", "coefficients": { "UNLOADED_RADIUS": 0.3, "FNOMIN": 4000,
    "PCX1": 1.6, "PDX1": 1.1, "PKX1": 20, "PCY1": 1.3, "PDY1": 1, "PKY1": -15, "PKY2": 1.5 } } },
  "tyres": { "tyre": { "centre": "wheel.centre", "data": "summer", "stiffness": 2e5, "damping": 2000 })" +
      std::string(
          has_two ? R"(, "tyre2": { "centre": "wheel2.centre", "data": "summer", "stiffness": 2e5, "damping": 2000 })"
                  : "") +
      R"( },
  "joint_forces": { "drive": { "joint": "wheel", "force": "drive" }, "drag": { "joint": "along", "force": "-abs(zd.along)*zd.along*0.4" } },
)";
  if (has_brake) {
    text += R"(  "frictions": { "brake": { "joint": "wheel", )" + brake;
    if (has_two) text += R"(, "brake2": { "joint": "wheel2", )" + brake;
    text += " },\n";
  }
  return text +
         R"(  "outputs": { "slip": { "tyre": "tyre", "quantity": "longitudinal_slip" }, "fx": { "tyre": "tyre", "quantity": "longitudinal_force" } },
  "initial": { "positions": { "up": -0.0155 }, "velocities": { "along": 10, )" +
         std::string(has_two ? R"("wheel2": 33.8, )" : "") + R"("wheel": 33.8 } } })";
}

std::vector<std::complex<double>> eigenvalues_of(const Json& linear) {
  std::vector<std::complex<double>> values;
  for (const Json& mode : linear["modes"]) values.emplace_back(mode["eigenvalue"][0], mode["eigenvalue"][1]);
  return values;
}

TEST_F(CommandLine, ABrakeThatIsOpenHoldsNothing) {
  for (const double rate : {0.0, 5.0, -5.0}) {
    write("fly.json", flywheel(rate));
    const Json open = json_of("linearize fly.json --json");
    for (const std::complex<double> value : eigenvalues_of(open)) {
      EXPECT_EQ(value.imag(), 0) << rate;
      EXPECT_TRUE(value.real() == 0 || value.real() == -1000) << rate << ": " << value.real();
    }
    EXPECT_EQ(open["A"], Json({{0.0, 1.0, 0.0}, {0.0, 0.0, 0.0}, {0.0, 0.0, -1000.0}})) << rate;
    EXPECT_EQ(open["C"], Json({{0.0, 1.0, 0.0}}));
    // Closing it acts against the motion, where there is one.
    EXPECT_NEAR(open["B"][1][0].get<double>(), rate == 0 ? 0 : -std::copysign(1.0, rate), 1e-9) << rate;
    EXPECT_EQ(open["B"][2][0], 0.0) << rate;
  }
  const Outcome open = mbgen("linearize fly.json");
  EXPECT_EQ(open.out.find("unstable"), std::string::npos) << open.out;
  // Closed it holds: s^2 + 60 s + 2e4 = 0.
  write("fly.json", flywheel(0));
  const std::complex<double> held = eigenvalues_of(json_of("linearize fly.json --input brake=100 --json"))[0];
  EXPECT_NEAR(held.real(), -30, 1e-9);
  EXPECT_NEAR(held.imag(), std::sqrt(2e4 - 900), 1e-9);
}

// Closed and turning it slides at its end: J dw/dt = -brake, and what is bent follows the limit with the lag of 1 ms.
TEST_F(CommandLine, ABrakeThatSlidesHasItsSlope) {
  write("fly.json", flywheel(5));
  const Json linear = json_of("linearize fly.json --input brake=100 --json");
  EXPECT_NEAR(linear["drift"][1].get<double>(), -100, 1e-9);
  EXPECT_EQ(linear["drift"][2], 0.0);
  EXPECT_EQ(linear["A"][1][1], 0.0);
  EXPECT_NEAR(linear["A"][2][2].get<double>(), -1000, 1e-9);
  EXPECT_NEAR(linear["B"][2][0].get<double>(), 1000 / 2e4, 1e-12);
}

TEST_F(CommandLine, VehiclesWithOpenBrakesAreThoseWithout) {
  const std::string rig = kSource + "/models/coach_rig.json", driver = kSource + "/models/coach_driver.json";
  const Json without = json_of("linearize " + rig + " --at steady --solve drive_torque --json"),
             with = json_of("linearize " + driver + " --at steady --solve drive_torque --json");
  const double torque = without["input_values"]["drive_torque"];
  // By hand: the power of the drive is that of 1152 N of drag and of the rolling resistance, 0.006 of the load at a
  // radius of 0.548 m, of wheels with 59.94 and 90.21 kN; tyres that slip and toe in take less than 0.5 % beside.
  const Json& rates = without["velocities"];
  const auto mean = [&](const std::string& axle) {
    return (rates["wheel_" + axle + "_left"].get<double>() + rates["wheel_" + axle + "_right"].get<double>()) / 2;
  };
  const double power = 1152 * 20 + 0.006 * 0.548 * (59941 * mean("front") + 90211 * mean("rear"));
  EXPECT_GT(torque * mean("rear"), power);
  EXPECT_LT(torque * mean("rear"), 1.005 * power);
  EXPECT_NEAR(with["input_values"]["drive_torque"].get<double>(), torque, 1e-6);
  const Json rest_without = json_of("linearize " + rig + " --at equilibrium --json"),
             rest_with = json_of("linearize " + driver + " --at equilibrium --json");
  const auto oscillations = [](const Json& linear) {
    std::vector<std::complex<double>> values = eigenvalues_of(linear);
    std::erase_if(values, [](std::complex<double> value) { return value.imag() < 1; });
    return values;
  };
  const auto expected = oscillations(rest_without), found = oscillations(rest_with);
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) EXPECT_LT(std::abs(found[i] - expected[i]), 1e-6) << i;
}

// The drive of a wheel on a rail balances 40 N of drag: 40 N times the radius at which the tyre carries its load.
TEST_F(CommandLine, WheelsOnARailHaveSteadyMotions) {
  for (const bool has_two : {false, true}) {
    for (const bool has_brake : {false, true}) {
      write("rail.json", rail(has_two, has_brake));
      const Json linear = json_of("linearize rail.json --at steady --solve drive --json");
      EXPECT_EQ(linear["velocities"]["up"], 0.0);
      EXPECT_EQ(linear["velocities"]["along"], 10.0);
      EXPECT_NEAR(linear["velocities"]["wheel"].get<double>(), 33.8, 0.3);
      const double load = (318.0 + (has_two ? 18 : 0)) * 9.81 / (has_two ? 2 : 1), radius = 0.3 - load / 2e5;
      const double drive = linear["input_values"]["drive"];
      EXPECT_NEAR(drive, 40 * radius, 1.5 * 40 * radius) << "rolling resistance comes on top";
      EXPECT_GT(drive, 0);
      if (has_two) {
        EXPECT_NEAR(linear["velocities"]["wheel2"].get<double>(), 33.6, 0.3);
      }
    }
  }
}

TEST_F(CommandLine, AccelerationsOfLightPartsAreWeighed) {
  write("light.json",
        R"({ "mbgen": 1, "name": "light", "gravity": [0, 0, -9.81], "inputs": { "drive": { "unit": "N" } },
  "bodies": { "ground": { "points": { "o": [0, 0, 0] } },
    "car": { "mass": 1500, "inertia": [1, 1, 1], "points": { "o": [0, 0, 0] } },
    "needle": { "mass": 1e-6, "inertia": [1e-9, 1e-9, 1e-9], "points": { "o": [0, 0, 0] } } },
  "joints": { "along": { "type": "prismatic", "from": "ground.o", "to": "car.o", "axis": "x" },
    "needle": { "type": "revolute", "from": "car.o", "to": "needle.o", "axis": "z" } },
  "joint_forces": { "drive": { "joint": "along", "force": "drive - 0.4*zd.along^2" },
    "load": { "joint": "needle", "force": "1234.567 - sin(z.needle)*1e5 - cos(2*z.needle)*1e4" } },
  "initial": { "velocities": { "along": 10 } } })");
  const Json linear = json_of("linearize light.json --at steady --solve drive --json");
  EXPECT_NEAR(linear["input_values"]["drive"].get<double>(), 40, 1e-9);
  const double left = 1234.567 - 1e5 * std::sin(linear["positions"]["needle"].get<double>()) -
                      1e4 * std::cos(2 * linear["positions"]["needle"].get<double>());
  EXPECT_LT(std::abs(left), 1e-10) << "N m, of a needle that this turns at 0.1 rad/s^2";
}

/// A slider that goes on at 10 m/s, with a pin that a moment turns and a friction of 10 N m holds.
std::string pushed(double moment) {
  return fmt::format(
      R"({{ "mbgen": 1, "name": "pushed", "inputs": {{ "drive": {{ "unit": "N" }}, "other": {{ "unit": "N" }} }},
  "bodies": {{ "ground": {{ "points": {{ "o": [0, 0, 0] }} }},
    "car": {{ "mass": 1500, "inertia": [1, 1, 1], "points": {{ "o": [0, 0, 0] }} }},
    "pin": {{ "mass": 1, "inertia": [1, 1, 1], "points": {{ "o": [0, 0, 0] }} }} }},
  "joints": {{ "along": {{ "type": "prismatic", "from": "ground.o", "to": "car.o", "axis": "x" }},
    "pin": {{ "type": "revolute", "from": "car.o", "to": "pin.o", "axis": "z" }} }},
  "joint_forces": {{ "drive": {{ "joint": "along", "force": "drive + 2*other - 0.4*zd.along^2" }},
    "load": {{ "joint": "pin", "force": {} }} }},
  "frictions": {{ "pin": {{ "joint": "pin", "law": "elasto_plastic", "coulomb": 10, "stiffness": 1e4, "damping": 10 }} }},
  "initial": {{ "velocities": {{ "along": 10 }} }} }})",
      moment);
}

TEST_F(CommandLine, FrictionHoldsNoMoreThanItCan) {
  write("pushed.json", pushed(5));
  EXPECT_NEAR(json_of("linearize pushed.json --at steady --solve drive --json")["input_values"]["drive"].get<double>(),
              40, 1e-6);
  write("pushed.json", pushed(15));
  EXPECT_EQ(mbgen("linearize pushed.json --at steady --solve drive").err,
            "pushed.json: no steady motion found: friction \"pin\" would have to hold 1.5 times what it can\n"
            "  hint: let the coordinate move at the start, or hold it with --hold\n");
}

TEST_F(CommandLine, TooFewHoldsAreToldWithTheFreeDirection) {
  write("pushed.json", pushed(5));
  const Outcome both = mbgen("linearize pushed.json --at steady --solve drive --solve other");
  EXPECT_EQ(both.exit_code, 0);
  EXPECT_EQ(both.err,
            "pushed.json: note: too few rates are held for one steady motion; the one near the start is given, and one "
            "may go from it along\n  drive +1, other -0.5\n  hint: hold one more rate with --hold, or solve for one "
            "input less\n");
}

/// The three-wheeler on a slope of 10 % that stands with its brakes closed.
TEST_F(CommandLine, BrakesHoldAVehicleOnASlope) {
  std::string frictions;
  for (const char* wheel : {"front", "left", "right"})
    frictions += fmt::format(R"({}"brake_{}": {{ "joint": "{}", "law": "elasto_plastic", "coulomb": "brake",
      "stiffness": 3e4, "damping": 60 }})",
                             frictions.empty() ? "" : ", ", wheel, wheel);
  write("m.json",
        fmt::format(R"({{ "mbgen": 1, "name": "parked", "include": ["{}/tests/data/models/three_wheeler.json"],
    "gravity": ["-sin(atan(0.1))*9.81", 0, "-cos(atan(0.1))*9.81"],
    "inputs": {{ "brake": {{ "unit": "N m", "default": 200 }} }}, "frictions": {{ {} }},
    "joint_springs": {{ "hold": {{ "joint": "steer", "stiffness": 3e4, "damping": 300 }} }},
    "outputs": {{ "front": {{ "tyre": "front", "quantity": "longitudinal_force" }},
      "left": {{ "tyre": "left", "quantity": "longitudinal_force" }},
      "right": {{ "tyre": "right", "quantity": "longitudinal_force" }} }},
    "initial": {{ "equilibrium": true, "positions": {{ "steer": 0 }},
      "velocities": {{ "frame_tx": 0, "frame_rz": 0, "front": 0, "left": 0, "right": 0 }} }} }})",
                    kSource, frictions));
  const Json rest = json_of("equilibrium m.json --json");
  EXPECT_LT(rest["largest_acceleration"].get<double>(), 1e-5);
  EXPECT_EQ(rest["positions"]["frame_tx"], 0.0);
  double sum = 0;
  for (const char* tyre : {"front", "left", "right"}) sum += rest["outputs"][tyre].get<double>();
  EXPECT_GT(sum, 300) << "the tyres carry the slope's share of the weight";
  // It stays there: the bristles start as far bent as they have to.
  ASSERT_EQ(mbgen("simulate m.json --engine generic --duration 1 --out m.csv").exit_code, 0);
  EXPECT_LT(std::abs(table("m.csv").last("z.frame_tx [m]")), 1e-6);
  const Outcome weak = mbgen("equilibrium m.json --input brake=20");
  EXPECT_EQ(weak.exit_code, 1);
}

// A block on a plane of 0.3 rad, by coordinates along and across it: friction by the reaction of its slide holds up to
// tan(0.3), and what it holds is the weight's part along the plane.
TEST_F(CommandLine, FrictionPressedByAReactionHolds) {
  const auto block = [](double mu) {
    return fmt::format(R"j({{ "mbgen": 1, "name": "block", "gravity": ["9.81*sin(0.3)", 0, "-9.81*cos(0.3)"],
    "bodies": {{ "ground": {{ "points": {{ "o": [0, 0, 0] }} }},
      "block": {{ "mass": 2, "inertia": [1, 1, 1], "points": {{ "o": [0, 0, 0] }} }} }},
    "joints": {{ "x": {{ "type": "prismatic", "from": "ground.o", "to": "block.o", "axis": "x" }} }},
    "frictions": {{ "floor": {{ "joint": "x", "reaction": "x", "law": "elasto_plastic", "coulomb": {}, "stiffness": 4e3, "damping": 10 }} }},
    "initial": {{ "equilibrium": true }} }})j",
                       mu);
  };
  write("block.json", block(0.32));
  const Json rest = json_of("equilibrium block.json --json");
  EXPECT_LT(rest["largest_acceleration"].get<double>(), 1e-6);
  EXPECT_NEAR(rest["states"]["floor_load"].get<double>(), 2 * 9.81 * std::cos(0.3), 1e-9);
  EXPECT_NEAR(rest["states"]["floor_bristle"].get<double>() * 4e3, std::tan(0.3), 1e-6);
  write("block.json", block(0.30));
  EXPECT_EQ(mbgen("equilibrium block.json").exit_code, 1) << "tan(0.3) is 0.309";
}

// The search pushed the coach about while its tyres found their loads: it began 0.77 deg off its course.
TEST_F(CommandLine, ARideOverARoughRoadStartsStraight) {
  const Json rest = json_of("equilibrium " + kSource + "/models/rides/coach_class_c.json --json");
  EXPECT_LT(rest["largest_acceleration"].get<double>(), 1e-6);
  for (const char* open : {"chassis_ty", "chassis_rz", "wheel_front_left", "wheel_front_right", "wheel_rear_left"})
    EXPECT_EQ(rest["positions"][open], 0.0) << open;
  EXPECT_GT(std::abs(rest["positions"]["chassis_tx"].get<double>()), 1e-3) << "a wheel rolls where the road is lowest";
  // 2.2 m off its course after 12 s, as long as it began turned.
  ASSERT_EQ(mbgen("simulate " + kSource +
                  "/models/rides/coach_class_c.json --set steer_amplitude=0 --duration 12 --step 2e-3 --engine generic "
                  "--every 100 --out ride.csv")
                .exit_code,
            0);
  EXPECT_LT(std::abs(table("ride.csv").last("z.chassis_ty [m]")), 0.2);
}

// A vehicle that is put down turned stays turned.
TEST_F(CommandLine, TheEquilibriumKeepsPlaceAndHeading) {
  write("m.json", fmt::format(R"({{ "mbgen": 1, "name": "put_down", "include": ["{}/models/coach_rig.json"],
    "initial": {{ "positions": {{ "chassis_tx": 3, "chassis_ty": -2, "chassis_rz": 0.3 }} }} }})",
                              kSource));
  const Json rest = json_of("equilibrium m.json --json");
  EXPECT_EQ(rest["positions"]["chassis_tx"], 3.0);
  EXPECT_EQ(rest["positions"]["chassis_ty"], -2.0);
  EXPECT_EQ(rest["positions"]["chassis_rz"], 0.3);
}

}  // namespace
}  // namespace mbgen::cli_test
