// Limits, rotors and motions of actuators, by every engine.

#include "tests/support/cli_support.hpp"

namespace mbgen::cli_test {
namespace {

class ActuatorOptions : public CommandLine {
 protected:
  Json states_of(const std::string& arguments) const { return json_of("evaluate " + arguments)["states"]; }
};

/// Centre of mass 0.5 m below the pin, 0.3 kg m^2 about it; a gear of 20 with a rotor of 1e-3 kg m^2 adds 0.4 kg m^2.
constexpr const char* kGearedPendulum = R"json({ "mbgen": 1, "name": "geared", "gravity": [0, 0, -10],
  "bodies": { "ground": { "points": { "O": [0, 0, 0] } },
    "arm": { "mass": 1, "com": [0, 0, -0.5], "inertia": [0.05, 0.05, 0.05], "points": { "O": [0, 0, 0] } } },
  "joints": { "pin": { "type": "revolute", "from": "ground.O", "to": "arm.O", "axis": "y" } },
  "actuators": { "motor": { "joint": "pin", "gear": -20, "rotor_inertia": 1e-3, "limit": 0.4 } } })json";

TEST_F(ActuatorOptions, ARotorIsFeltByTheSquareOfItsGear) {
  write("geared.json", kGearedPendulum);
  write("states.json", R"({ "joint_order": ["pin", "motor_rotor"], "states": [
    { "z": [0.5, -10], "zd": [2, -40], "inputs": { "motor": 0.2 }, "zdd": { "pin": 7 } },
    { "z": [0.5, -10], "zd": [2, -40], "zdd": { "pin": -15 } }] })");
  const double weight = 5 * std::sin(0.5), inertia = 0.3 + 0.4;
  for (const char* engine : {"generic", "null-space", "augmented"}) {
    const std::string options = std::string("geared.json --states states.json --engine ") + engine;
    const Json forward = states_of(options);
    EXPECT_NEAR(forward[0]["zdd"][0].get<double>(), (-20 * 0.2 - weight) / inertia, 1e-11) << engine;
    const Json inverse = states_of(options + " --inverse");
    const double first = (inertia * 7 + weight) / -20, second = (inertia * -15 + weight) / -20;
    EXPECT_NEAR(inverse[0]["actuators"]["motor"].get<double>(), first, 1e-13) << engine;
    EXPECT_NEAR(inverse[1]["actuators"]["motor"].get<double>(), second, 1e-13) << engine;
    EXPECT_TRUE(inverse[0]["beyond_limit"].empty()) << inverse[0];
    EXPECT_NEAR(inverse[1]["beyond_limit"]["motor"].get<double>(), second - 0.4, 1e-13);
  }
}

TEST_F(ActuatorOptions, ForcesBeyondALimitAreToldAndKept) {
  write("geared.json", kGearedPendulum);
  write("path.csv", "t,z.pin [rad],zd.pin [rad/s],zdd.pin [rad/s^2]\n0,0,0,15\n0.1,0.075,1.5,15\n0.2,0.3,3,15\n");
  const Outcome run = mbgen("simulate geared.json --inverse --path path.csv --step 0.05 --every 2 --out f.csv --json");
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_NE(run.err.find("actuator motor: its force is beyond the limit of 0.4 N m by up to"), std::string::npos)
      << run.err;
  const Table table = this->table("f.csv");
  ASSERT_EQ(table.rows.size(), 3u);
  // With all three curves the acceleration is that of the table up to its last row, where a spline of three rows has it
  // too: at rest under 15 rad/s^2.
  EXPECT_NEAR(table.at(0, "actuator.motor.force [N m]"), -0.7 * 15 / 20, 1e-12);
  EXPECT_NEAR(table.at(0, "actuator.motor.beyond_limit [N m]"), 0.7 * 15 / 20 - 0.4, 1e-12);
  EXPECT_EQ(Json::parse(run.out)["rows"], 3);
  EXPECT_EQ(mbgen("simulate geared.json --engine generic --duration 0.2 --step 0.01 --input-table f.csv --out m.csv")
                .exit_code,
            0);
  write("path.csv", "t,pin,zd.pin,zdd.pin\n0,0,0,15\n0.1,0.075,-1.5,15\n0.2,0.3,3,15\n");
  const Outcome wrong = mbgen("simulate geared.json --inverse --path path.csv --out g.csv");
  EXPECT_EQ(wrong.exit_code, 1);
  EXPECT_NE(wrong.err.find("path.csv: between t = 0 s and 0.1 s \"pin\" changes by 0.075"), std::string::npos)
      << wrong.err;
  write("path.csv", "t,pin,zd.pin\n0,0,0\n0.1,0.075,1.5\n0.2,0.3,3\n");
  EXPECT_NE(mbgen("simulate geared.json --inverse --path path.csv --out g.csv").err.find("the path of \"pin\" lacks"),
            std::string::npos);
}

/// The ankle with its foot driven. actuated: further fields of the motions.
std::string driven_ankle(const std::string& actuated) {
  return R"json({ "mbgen": 1, "name": "driven_ankle", "include": [")json" + kSource +
         R"json(/models/robots/parallel_ankle.json"], "motions": {
    "pitch_path": { "joint": "ankle_ry", "angle": "0.2*sin(6*t)")json" +
         actuated + R"json( }, "roll_path": { "joint": "ankle_rx", "angle": "0.1*cos(4*t)")json" + actuated + " } } }";
}

// The torques of the motors do what the drives of the foot would do: the drives have nothing left.
TEST_F(ActuatorOptions, MotorsGiveTheMotionOfAPlatform) {
  write("driven.json", driven_ankle(R"(, "actuated_by": ["ankle_a", "ankle_b"])"));
  const Outcome run = mbgen("simulate driven.json --inverse --duration 0.3 --step 0.1 --out forces.csv");
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const Table forces = table("forces.csv");
  Json states = {{"joint_order", {"motor_a", "motor_b", "ankle_ry", "ankle_rx"}}};
  for (std::size_t row = 0; row < forces.rows.size(); ++row) {
    const double t = 0.1 * static_cast<double>(row);
    EXPECT_NEAR(forces.at(row, "ankle_ry [rad]"), 0.2 * std::sin(6 * t), 1e-14);
    states["states"].push_back({{"z", {0, 0, 0.2 * std::sin(6 * t), 0.1 * std::cos(4 * t)}},
                                {"zd", {0, 0, 1.2 * std::cos(6 * t), -0.4 * std::sin(4 * t)}},
                                {"zdd", {{"ankle_ry", -7.2 * std::sin(6 * t)}, {"ankle_rx", -1.6 * std::cos(4 * t)}}},
                                {"t", t}});
  }
  write("states.json", states.dump());
  write("free.json",
        R"({ "mbgen": 1, "name": "free", "include": [")" + kSource + R"(/models/robots/parallel_ankle.json"] })");
  const Json expected = states_of("free.json --inverse --project --engine generic --states states.json");
  for (std::size_t row = 0; row < expected.size(); ++row) {
    Json& state = states["states"][row];
    for (const char* name : {"ankle_a", "ankle_b"}) {
      const double force = expected[row]["actuators"][name];
      EXPECT_NEAR(forces.at(row, std::string("actuator.") + name + ".force [N m]"), force, 1e-9 * std::abs(force));
      state["inputs"][name] = force;
    }
    for (const char* key : {"z", "zd"}) state[key] = expected[row][key];
  }
  write("states.json", states.dump());
  const Json forward = states_of("driven.json --engine generic --states states.json");
  for (const Json& state : forward)
    for (const Json& drive : state["drive"]) EXPECT_LT(std::abs(drive.get<double>()), 1e-12);
  for (const char* options : {"--engine null-space", "--engine generic", ""}) {
    const Json inverse = states_of("driven.json --inverse --states states.json " + std::string(options));
    for (std::size_t row = 0; row < inverse.size(); ++row)
      for (const char* name : {"ankle_a", "ankle_b"})
        EXPECT_NEAR(inverse[row]["actuators"][name], states["states"][row]["inputs"][name], 1e-9) << options;
  }
}

TEST_F(ActuatorOptions, AMotionBearsTheForceOfAnActuatorOnItsCoordinate) {
  std::string text = kGearedPendulum;
  text.insert(text.rfind(" }"), R"json(, "motions": { "swing": { "joint": "pin", "angle": "sin(t)" } })json");
  write("driven.json", text);
  EXPECT_NE(mbgen("check driven.json").err.find("acts on a coordinate that motion \"swing\" drives"),
            std::string::npos);
  const std::string place = "\"joint\": \"pin\", \"gear\": -20, \"rotor_inertia\": 1e-3";
  text.replace(text.find(place), place.size(), "\"motion\": \"swing\", \"gear\": -20");
  write("given.json", text);
  write("states.json",
        R"({ "states": [{ "z": [0], "zd": [1], "t": 0 }, { "z": [1], "zd": [0], "t": 1.5707963267948966 }] })");
  for (const char* engine : {"generic", "null-space"}) {
    const Json states = states_of(std::string("given.json --inverse --states states.json --engine ") + engine);
    EXPECT_NEAR(states[0]["actuators"]["motor"].get<double>(), 0, 1e-14);
    EXPECT_NEAR(states[1]["actuators"]["motor"].get<double>(), (-0.3 + 5 * std::sin(1.0)) / -20, 1e-13) << engine;
  }
}

TEST_F(ActuatorOptions, AStateWithOpenAccelerationsIsNamed) {
  write("states.json", R"({ "joint_order": ["motor_a", "motor_b", "ankle_ry", "ankle_rx"], "states": [
    { "z": [0, 0, 0, 0], "zdd": { "motor_a": 1, "motor_b": 2 } }, { "z": [0, 0, 0, 0], "zdd": { "motor_a": 1 } }] })");
  const Outcome run = mbgen("evaluate '" + kSource +
                            "/models/robots/parallel_ankle.json' --inverse --engine generic --states states.json");
  EXPECT_EQ(run.exit_code, 1);
  const Json states = Json::parse(run.out)["states"];
  EXPECT_EQ(states[0]["status"], "ok");
  EXPECT_TRUE(states[1]["actuators"].is_null());
  EXPECT_NE(run.err.find("states.json: /states/1: the given accelerations leave others open"), std::string::npos)
      << run.err;
}

/// A boom on a cylinder, whose motor has a rotor.
constexpr const char* kLiftedBoom = R"json({ "mbgen": 1, "name": "lifted", "gravity": [0, 0, -10],
  "bodies": { "ground": { "points": { "O": [0, 0, 0], "foot": [0.3, 0, -0.5] } },
    "boom": { "mass": 10, "com": [1, 0, 0], "inertia": [1, 1, 1], "points": { "O": [0, 0, 0], "eye": [0.8, 0, 0] } } },
  "joints": { "pin": { "type": "revolute", "from": "ground.O", "to": "boom.O", "axis": "y" } },
  "rods": { "lift": { "from": "ground.foot", "to": "boom.eye" } },
  "actuators": { "ram": { "rod": "lift", "gear": 50, "rotor_inertia": 1e-3 } } })json";

// The judges know a rod that an actuator moves by an equation of their own: its length follows the slide.
TEST_F(ActuatorOptions, ACylinderOfARodByEveryEngine) {
  write("lifted.json", kLiftedBoom);
  write("states.json", R"({ "joint_order": ["pin", "ram_rotor", "lift_length"], "states": [
    { "z": [0, 0, 0], "zd": [0, 0, 0], "zdd": { "pin": 0 } },
    { "z": [-0.4, 0, 0], "zd": [0.7, 0, 0], "zdd": { "pin": 2 } }] })");
  const Json expected = states_of("lifted.json --inverse --project --engine generic --states states.json");
  // At rest the lever of the cylinder about the pin bears 10 kg at 1 m.
  EXPECT_NEAR(expected[0]["actuators"]["ram"].get<double>(), 100 / (0.8 * 0.5 / std::hypot(0.5, 0.5)) / 50, 1e-12);
  auto states = Json::parse(read("states.json"));
  for (std::size_t s = 0; s < 2; ++s) {
    for (const char* key : {"z", "zd"}) states["states"][s][key] = expected[s][key];
    states["states"][s]["inputs"] = expected[s]["actuators"];
  }
  write("states.json", states.dump());
  for (const char* engine : {"generic", "null-space", "augmented"}) {
    const std::string options = std::string("lifted.json --states states.json --engine ") + engine;
    const Json forward = states_of(options), inverse = states_of(options + " --inverse");
    for (std::size_t s = 0; s < 2; ++s) {
      const double force = expected[s]["actuators"]["ram"];
      EXPECT_NEAR(inverse[s]["actuators"]["ram"].get<double>(), force, 1e-11 * std::abs(force)) << engine;
      for (std::size_t i = 0; i < 3; ++i)
        EXPECT_NEAR(forward[s]["zdd"][i].get<double>(), expected[s]["zdd"][i].get<double>(), 1e-9) << engine << i;
    }
  }
}

// The node knows the motors in another order than the solver, and the joints by their names.
TEST_F(ActuatorOptions, ARosNodePublishesAllJointsOfAnAnkle) {
  ASSERT_EQ(mbgen("generate '" + kSource + "/models/robots/parallel_ankle.json' --out made").exit_code, 0);
  const std::string example = "'" + kSource + "/examples/ros2_joint_state";
  const Outcome compiled = shell("c++ -std=c++17 -Wall -Wextra -Imade -I" + example + "/stubs' -I" + example + "' " +
                                 example + "/ankle_node.cpp' made/parallel_ankle.cpp -o node");
  ASSERT_EQ(compiled.exit_code, 0) << compiled.err;
  EXPECT_EQ(compiled.err, "");
  const Outcome run = shell("./node");
  EXPECT_EQ(run.exit_code, 0);
  std::string published = run.out;
  const std::string negative = " -0.000000000";  // of rounding
  for (std::size_t at = published.find(negative); at != std::string::npos; at = published.find(negative))
    published.erase(at + 1, 1);
  EXPECT_EQ(published,
            "motor_a 0.122157745 3.634181490\nmotor_b 0.122157745 3.634181490\nankle_ry 0.100000000 3.000000000\n"
            "ankle_rx 0.000000000 0.000000000\nwarning: motor_states lacks ankle_b\n");
}

}  // namespace
}  // namespace mbgen::cli_test
