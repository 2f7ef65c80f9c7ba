// Drives along a file's course, starts from standstill and on a hill, drivers that learn the vehicle.

#include <cmath>

#include "tests/support/cli_support.hpp"

namespace mbgen::cli_test {
namespace {

const std::string kDrivenCar = kSource + "/tests/data/models/four_wheeler.json";

class Drives : public CommandLine {
 protected:
  Json drive(const std::string& model, const std::string& manoeuvre, const std::string& more = "") const {
    write("m.json", manoeuvre);
    return json_of("simulate " + model + " --engine generic --manoeuvre m.json --every 10 --out m.csv --json " + more);
  }
  static double metric(const Json& run, const std::string& name) {
    for (const Json& one : run["metrics"])
      if (one["name"] == name) return one["value"];
    ADD_FAILURE() << "no " << name;
    return std::nan("");
  }
};

// The drive's force at the rolling radius moves the mass and the wheels' inertias: a = M r / (m r^2 + 4 I), less drag.
TEST_F(Drives, AStandingStartHasTheAccelerationOfItsTorque) {
  const Json run =
      drive(kDrivenCar, R"({ "mbgen_manoeuvre": 1, "type": "standing_start", "drive": 800, "last_speed": 14 })");
  const double radius = 0.2958, mass = 1204.02, drag = 0.3 * 0.007 * mass * 9.81;  // N m of rolling resistance
  const double acceleration = (800 - drag) * radius / (mass * radius * radius + 4 * 0.9);
  const double between = metric(run, "time_to_50") - metric(run, "time_to_20");
  EXPECT_NEAR(between, 30 / 3.6 / acceleration, 0.02 * between);
  EXPECT_EQ(metric(run, "rollback") < 1e-6, true);
  EXPECT_EQ(run["status"], "ok");
}

TEST_F(Drives, AStartOnAHillHoldsThenClimbs) {
  std::ifstream file(kDrivenCar);
  std::stringstream content;
  content << file.rdbuf();
  std::string text = content.str();
  const std::string before = R"("parameters": {)";
  text.replace(text.find(before), before.size(),
               R"json("gravity": ["-9.81*sin(slope)", 0, "-9.81*cos(slope)"], "parameters": { "slope": 0.15,)json");
  write("hill.json", text);
  const std::string start =
      R"({ "mbgen_manoeuvre": 1, "type": "standing_start", "brake": 2000, "drive": 900, "at": 1, "last_speed": 3 })";
  const Json held = drive("hill.json", start);
  EXPECT_LT(metric(held, "rollback"), 1e-4);
  const double push = 900 / 0.2958 / 1204 - 9.81 * std::sin(0.15) - 0.07;
  EXPECT_NEAR(metric(held, "largest_longitudinal_acceleration"), push, 0.12 * push);
  const Outcome free = mbgen(
      "simulate hill.json --engine generic --manoeuvre m.json --every 10 --out m.csv --set slope=0.7 --duration 2");
  EXPECT_NE(free.exit_code, 0) << "brakes of 2000 N m do not hold on 40 deg";
}

TEST_F(Drives, ACourseOfAFileIsFollowed) {
  std::string points = "x [m],y [m]\n";
  for (int i = 0; i < 36; ++i)
    points += fmt::format("{},{}\n", 60 * std::sin(i * M_PI / 18), 40 - 40 * std::cos(i * M_PI / 18));
  write("oval.csv", points);
  const std::string track =
      R"({ "mbgen_manoeuvre": 1, "type": "track", "speed": 8, "path": "oval.csv", "closed": true,
      "largest_speed": 14, "lateral_acceleration": 3, "driver": { "learns": true } })";
  const Json run = drive(kDrivenCar, track);
  EXPECT_LT(metric(run, "largest_lateral_acceleration"), 3.6);
  EXPECT_LT(metric(run, "largest_speed"), 14.2);
  EXPECT_LT(run["manoeuvre"]["largest_offset"].get<double>(), 0.5);
  // Ramanujan's circumference of the ellipse.
  const double h = 20.0 * 20 / (100 * 100), length = M_PI * 100 * (1 + 3 * h / (10 + std::sqrt(4 - 3 * h)));
  EXPECT_NEAR(metric(run, "lap_time_1") * metric(run, "mean_speed"), length, 0.02 * length);
  EXPECT_EQ(run["manoeuvre"]["ended"], "the track is passed");
  // The lap ends at its start line, at the origin: rows are 10 steps apart.
  const Table motion = table("m.csv");
  EXPECT_NEAR(motion.last("vehicle_x [m]"), 0, 0.2);
  EXPECT_GT(motion.last("vehicle_x [m]"), 0);
  EXPECT_NEAR(run["manoeuvre"]["learned"]["understeer"].get<double>(), 0.00137, 3e-5);
  EXPECT_EQ(run["manoeuvre"]["learned"]["steer_ratio"], 1.0);
  write("m.json", R"({ "mbgen_manoeuvre": 1, "type": "track", "speed": 8, "path": "none.csv" })");
  const Outcome missing = mbgen("simulate " + kDrivenCar + " --engine generic --manoeuvre m.json --out m.csv");
  EXPECT_EQ(missing.exit_code, 1);
  EXPECT_NE(missing.err.find("m.json:1:62: "), std::string::npos) << missing.err;
}

TEST_F(Drives, InputsOfTheManoeuvreAreItsOwn) {
  write("m.json", R"({ "mbgen_manoeuvre": 1, "type": "ride", "speed": 8 })");
  EXPECT_EQ(mbgen("simulate " + kDrivenCar + " --engine generic --manoeuvre m.json --out m.csv --input steer=0.1").err,
            "--input steer: the manoeuvre moves this input itself\n  hint: leave out --input\n");
  EXPECT_EQ(mbgen("sweep " + kDrivenCar + " --engine generic --manoeuvre m.json --out m.csv --vary brake=1,2").err,
            "--vary brake: the manoeuvre moves this input itself\n  hint: leave out --vary\n");
}

TEST_F(Drives, WhoLearnsIsNotTold) {
  write("m.json",
        R"({ "mbgen_manoeuvre": 1, "type": "ride", "speed": 8, "driver": { "learns": true, "understeer": 0.1 } })");
  EXPECT_NE(mbgen("simulate " + kDrivenCar + " --engine generic --manoeuvre m.json --out m.csv")
                .err.find("/driver/understeer: a driver who learns finds the understeer: leave out one of the two"),
            std::string::npos);
  write("m.json", R"({ "mbgen_manoeuvre": 1, "type": "track", "speed": 8, "path": "a.csv", "laps": 2 })");
  EXPECT_NE(mbgen("simulate " + kDrivenCar + " --engine generic --manoeuvre m.json --out m.csv")
                .err.find("/laps: goes with a closed course: \"closed\": true"),
            std::string::npos);
}

}  // namespace
}  // namespace mbgen::cli_test
