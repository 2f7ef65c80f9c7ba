// mbgen new: every starter is checked, generated and driven; nothing is overwritten by mistake.
#include <cmath>

#include "tests/support/cli_support.hpp"

namespace mbgen::cli_test {
namespace {

class New : public CommandLine {};

// All kinds beside each other: parts that several have are the same files.
TEST_F(New, EveryStarterIsAModelThatMoves) {
  const Json list = json_of("new --list --json")["starters"];
  ASSERT_EQ(list.size(), 13u);
  for (const Json& starter : list) {
    const std::string kind = starter["kind"];
    EXPECT_GT(starter["purpose"].get<std::string>().size(), 10u) << kind;
    const Outcome written = mbgen("new " + kind);
    EXPECT_EQ(written.exit_code, 0) << written.err;
    EXPECT_EQ(written.out.substr(0, kind.size() + 6), kind + ".json\n");
    const Outcome checked = mbgen("check " + kind + ".json");
    EXPECT_EQ(checked.out.find(kind + ".json: ok\n"), 0u) << checked.err;
    EXPECT_NE(checked.out.find(", notes 0\n"), std::string::npos) << kind << checked.err;
    EXPECT_EQ(mbgen("generate " + kind + ".json --out " + kind).exit_code, 0);
    const Outcome run = mbgen("simulate " + kind + ".json --engine generic --duration 0.2 --out " + kind + ".csv");
    EXPECT_EQ(run.exit_code, 0) << run.err;
    EXPECT_GE(table(kind + ".csv").rows.size(), 201u) << kind;
  }
}

TEST_F(New, OfSeveralFilesStandsInAFolderUnderAnyName) {
  const Json written = json_of("new car --out cars/mine.json --json");
  EXPECT_EQ(written["file"], "cars/mine.json");
  ASSERT_EQ(written["files"].size(), 16u);
  EXPECT_EQ(written["files"][0], "cars/mine.json");
  for (const Json& file : written["files"]) EXPECT_FALSE(read(file.get<std::string>()).empty()) << file;
  // The road of the car on ice includes the car by its name.
  EXPECT_EQ(mbgen("check cars/car_on_ice.json").exit_code, 0);
  EXPECT_EQ(mbgen("new car --out both/").exit_code, 0);
  const Outcome beside = mbgen("new trailer --out both/");
  EXPECT_EQ(beside.exit_code, 0) << beside.err;  // files of both kinds are the same
  EXPECT_EQ(mbgen("check both/trailer.json").exit_code, 0);
  write("both/car_tyre.json", "precious");
  const Outcome again = mbgen("new car --out both");
  EXPECT_EQ(again.exit_code, 1);
  EXPECT_EQ(
      again.err,
      "both/car.json: file exists\nboth/car_tyre.json: file exists\n  hint: name another one with --out, or overwrite "
      "it with --force\n");
  EXPECT_EQ(read("both/car_tyre.json"), "precious");
  EXPECT_EQ(mbgen("new car --out both --force").exit_code, 0);
  EXPECT_NE(read("both/car_tyre.json"), "precious");
  EXPECT_EQ(mbgen("new car --out -").err,
            "mbgen new: car is 16 files, standard output takes one\n  hint: name a folder: --out car/\n");
  EXPECT_EQ(
      mbgen("new car --out car_tyre.json").err,
      "car_tyre.json: a file of car that stands beside the model has this name\n  hint: name another one with --out\n");
}

// The design position is the equilibrium: loads, static toe and camber are those of the files.
TEST_F(New, CarStandsAtItsDesignPosition) {
  ASSERT_EQ(mbgen("new car").exit_code, 0);
  const Json rest = json_of("equilibrium car.json --json");
  const auto output = [&](const std::string& name) { return rest["outputs"][name].get<double>(); };
  const auto position = [&](const std::string& name) { return rest["positions"][name].get<double>(); };
  EXPECT_NEAR(position("chassis_tz"), 0, 5e-4);
  EXPECT_NEAR(position("chassis_ry"), 0, 2e-4);
  for (const std::string side : {"left", "right"}) {
    EXPECT_NEAR(output("load_front_" + side), 3912, 15);
    EXPECT_NEAR(output("load_rear_" + side), 3200, 15);
  }
  for (const std::string variant : {"car_double_wishbone", "car_twist_beam"}) {
    EXPECT_NE(mbgen("check " + variant + ".json").out.find(", notes 0\n"), std::string::npos) << variant;
    const Json other = json_of("equilibrium " + variant + ".json --json");
    EXPECT_NEAR(other["positions"]["chassis_tz"].get<double>(), 0, 1e-3) << variant;
    EXPECT_NEAR(other["positions"]["chassis_ry"].get<double>(), 0, 1e-3) << variant;
    for (const std::string side : {"left", "right"}) {
      EXPECT_NEAR(other["outputs"]["load_front_" + side].get<double>(), 3912, 25) << variant;
      EXPECT_NEAR(other["outputs"]["load_rear_" + side].get<double>(), 3200, 25) << variant;
    }
  }
  constexpr double kDegree = 3.14159265358979 / 180;
  EXPECT_NEAR(output("toe_front_left"), 0.1 * kDegree, 1e-4);
  EXPECT_NEAR(output("toe_rear_left"), 0.15 * kDegree, 1e-4);
  EXPECT_NEAR(output("camber_front_left"), -0.6 * kDegree, 4e-4);
  EXPECT_NEAR(output("camber_rear_left"), -1.2 * kDegree, 4e-4);
}

// Single-track: the yaw rate over the road wheels' angle is v / (l + k v^2) with the understeer k that the manoeuvre's
// driver knows, and v times it is the lateral acceleration. A passenger car rolls by 3 to 6 deg per g.
TEST_F(New, CarSteersAsItsManoeuvresExpect) {
  ASSERT_EQ(mbgen("new car").exit_code, 0);
  write("short.json",
        R"({ "mbgen_manoeuvre": 1, "type": "step_steer", "speed": 25, "lateral_acceleration": 3, "at": 0.2,
    "duration": 2.5, "driver": { "understeer": 0.004 } })");
  const Json run =
      json_of("simulate car.json --manoeuvre short.json --engine generic --step 2e-3 --every 10 --json --out s.csv");
  EXPECT_EQ(run["status"], "ok");
  const auto metric = [&](const std::string& name) {
    for (const Json& one : run["metrics"])
      if (one["name"] == name) return one["value"].get<double>();
    return std::nan("");
  };
  constexpr double kLength = 2.7, kUndersteer = 0.004, kRatio = 15.5;
  const double v = metric("speed");
  EXPECT_NEAR(metric("yaw_rate_gain") * kRatio * (kLength + kUndersteer * v * v) / v, 1, 0.03);
  EXPECT_NEAR(metric("steady_lateral_acceleration"), 3, 0.1);
  const double roll = metric("steady_roll") / metric("steady_lateral_acceleration") * 9.81 * 180 / 3.14159265358979;
  EXPECT_GT(roll, 3);
  EXPECT_LT(roll, 6);
}

TEST_F(New, NeverOverwritesWithoutForce) {
  write("mine.json", "precious");
  const Outcome refused = mbgen("new pendulum --out mine.json");
  EXPECT_EQ(refused.exit_code, 1);
  EXPECT_EQ(refused.err, "mine.json: file exists\n  hint: name another one with --out, or overwrite it with --force\n");
  EXPECT_EQ(read("mine.json"), "precious");
  EXPECT_EQ(mbgen("new pendulum --out mine.json --force").exit_code, 0);
  EXPECT_NE(read("mine.json").find("\"hinge\""), std::string::npos);
}

TEST_F(New, SaysWhichKindsThereAre) {
  EXPECT_EQ(mbgen("new").err, "mbgen new: KIND is missing\n  hint: mbgen new --list names the kinds\n");
  const Outcome unknown = mbgen("new pendulums");
  EXPECT_EQ(unknown.exit_code, 1);
  EXPECT_EQ(
      unknown.err,
      "mbgen new: unknown kind \"pendulums\"\n  hint: known: car, double_wishbone, four_bar, mcpherson, multilink, "
      "pendulum, quarter_car, solid_axle, trailer, truck, twist_beam, tyre_rig, wishbones\n");
  EXPECT_EQ(leftovers(), std::vector<std::string>{});
}

}  // namespace
}  // namespace mbgen::cli_test
