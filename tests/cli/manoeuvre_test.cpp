// Manoeuvres: a car whose steady turn is a closed form, a driver in lanes, speed and brakes, and what is refused.

#include <cmath>

#include "tests/support/cli_support.hpp"

namespace mbgen::cli_test {
namespace {

const std::string kFourWheeler = kSource + "/tests/data/models/four_wheeler.json";

class Manoeuvre : public CommandLine {
 protected:
  /// Drives the car and gives what FILE.run.json says; the table is m.csv.
  Json drive(const std::string& manoeuvre, const std::string& more = "") {
    write("m.json", manoeuvre);
    const Outcome run =
        mbgen("simulate " + kFourWheeler + " --engine generic --manoeuvre m.json --every 10 --out m.csv " + more);
    EXPECT_EQ(run.exit_code, 0) << run.err;
    return Json::parse(read("m.csv.run.json"));
  }
  static double metric(const Json& run, const std::string& name) {
    for (const Json& metric : run["metrics"])
      if (metric["name"] == name) return metric["value"];
    ADD_FAILURE() << "no metric " << name;
    return std::nan("");
  }
  /// Standard error of a manoeuvre that is refused.
  std::string refusal(const std::string& model, const std::string& manoeuvre, const std::string& more = "",
                      const std::string& duration = "--duration 0.1") {
    write("m.json", manoeuvre);
    const Outcome run =
        mbgen("simulate " + model + " --engine generic --manoeuvre m.json --out m.csv " + duration + " " + more);
    EXPECT_EQ(run.exit_code, 1);
    EXPECT_FALSE(std::filesystem::exists(path("m.csv")));
    return run.err;
  }
};

/// N/rad, of two wheels of the set "summer" under a load in N together (Pacejka, 4.E25, without camber).
double cornering_stiffness(double load) { return 2 * 15 * 3000 * std::sin(2 * std::atan(load / 2 / (1.5 * 3000))); }

// Linear single-track vehicle: yaw rate over angle is U / (l + K U^2), K = m (b / C_f - a / C_r) / l. Loads are those
// of the motion: the drive shifts them by a thousandth.
TEST_F(Manoeuvre, SteadyTurnIsThatOfTheLinearSingleTrackVehicle) {
  const double wheelbase = 2.6, mass = 1204, front = 1.1 + 0.8 / mass, rear = wheelbase - front, angle = 0.002;
  for (const double speed : {10.0, 20.0}) {
    drive(fmt::format(R"({{ "mbgen_manoeuvre": 1, "type": "step_steer", "speed": {}, "steer": {}, "side": "right" }})",
                      speed, angle));
    const Table motion = table("m.csv");
    const auto load = [&](const std::string& axle) {
      return motion.last("vehicle_load_" + axle + "l [N]") + motion.last("vehicle_load_" + axle + "r [N]");
    };
    const double understeer =
        mass / wheelbase * (rear / cornering_stiffness(load("f")) - front / cornering_stiffness(load("r")));
    const double u = std::hypot(motion.last("vehicle_vx [m/s]"), motion.last("vehicle_vy [m/s]"));
    EXPECT_NEAR(u, speed, 0.05);
    const double expected = -angle * u / (wheelbase + understeer * u * u);
    EXPECT_NEAR(motion.last("vehicle_yaw_rate [rad/s]") / expected, 1, 1e-3) << speed;
  }
}

TEST_F(Manoeuvre, TheDriverStaysInTheLanesAndOnTheCircle) {
  for (const char* side : {"left", "right"}) {
    const Json run = drive(fmt::format(
        R"({{ "mbgen_manoeuvre": 1, "type": "lane_change", "speed": "70/3.6", "approach": 20, "side": "{}",
             "driver": {{ "understeer": 0.00135, "anticipation": 0.2 }} }})",
        side));
    EXPECT_LT(metric(run, "lane_excess"), 0) << side;
    EXPECT_EQ(run["manoeuvre"]["ended"], "the track is passed");
    EXPECT_GT(metric(run, "largest_lateral_acceleration"), 3) << side;
  }
  const Json circle = drive(
      R"({ "mbgen_manoeuvre": 1, "type": "steady_circle", "speed": 8, "radius": 50, "last_speed": 10, "duration": 20,
           "driver": { "understeer": 0.00135 } })");
  EXPECT_LT(circle["manoeuvre"]["largest_offset"], 0.2);
}

TEST_F(Manoeuvre, SpeedIsReachedWithinTheLimitOfTheDriveAndBrakesStop) {
  const Json run = drive(R"({ "mbgen_manoeuvre": 1, "type": "events", "speed": 10, "duration": 20, "events": [
    { "at": 1, "speed": 14, "over": 1 }, { "at": 12, "free": true }, { "at": 13, "brake": 2000, "over": 0.5 } ] })");
  const Table motion = table("m.csv");
  double before_brake = 0;
  for (std::size_t row = 0; row < motion.rows.size(); ++row)
    if (motion.rows[row][0] <= 12) before_brake = motion.at(row, "vehicle_vx [m/s]");
  EXPECT_NEAR(before_brake, 14, 0.1);
  EXPECT_NEAR(motion.last("vehicle_vx [m/s]"), 0, 1e-3);
  EXPECT_EQ(run["inputs"]["brake"]["last"], 2000);
  // The drive cannot follow: 900 N m are 2.5 m/s^2, a change of 4 m/s within a second asks for 7.5.
  EXPECT_DOUBLE_EQ(run["inputs"]["drive"]["largest"], 900);
  EXPECT_NE(run["warnings"].dump().find("the speed differs from the wanted one by up to"), std::string::npos);
}

// A judge starts from an equilibrium of its own, and shares no equations.
TEST_F(Manoeuvre, EnginesDriveAlike) {
  write("m.json", R"({ "mbgen_manoeuvre": 1, "type": "lane_change", "speed": 20, "approach": 2, "duration": 2 })");
  for (const std::string engine : {"generated", "generic", "augmented"}) {
    const Outcome run =
        mbgen("simulate " + kFourWheeler + " --engine " + engine + " --manoeuvre m.json --out " + engine + ".csv");
    ASSERT_EQ(run.exit_code, 0) << run.err;
  }
  expect_same_motion(table("generated.csv"), table("generic.csv"), 1e-9);
  expect_same_motion(table("augmented.csv"), table("generic.csv"), 1e-7);
  EXPECT_GT(std::abs(table("generic.csv").last("vehicle_y [m]")), 1);
}

// 0.3 rad are the limit of a copy of the car; its input of the rate follows the steering.
TEST_F(Manoeuvre, SteeringBeyondItsLimitIsRefused) {
  const std::string text = read(kFourWheeler);
  const std::string::size_type place = text.find("\"steer\": \"steer\"");
  ASSERT_NE(place, std::string::npos);
  write("limited.json", text.substr(0, place) + "\"steer_limit\": 0.3, " + text.substr(place));
  const auto of_events = [&](const std::string& events) {
    return refusal("limited.json",
                   R"({ "mbgen_manoeuvre": 1, "type": "events", "speed": 15, "events": [)" + events + "] }");
  };
  EXPECT_NE(of_events(R"({ "at": 1, "steer_table": [[0, 0], [1, 0.4]] })").find("beyond its steer_limit, 0.3 rad"),
            std::string::npos);
  EXPECT_NE(of_events(R"({ "at": 1, "steer": 0.2 }, { "at": 2, "steer": 0.15, "frequency": 1 })")
                .find("0.35 rad at the steering input at t = 2.25 s are beyond"),
            std::string::npos);
  EXPECT_NE(of_events(R"({ "at": 1, "input": "steer_rate", "value": 1 })")
                .find(R"(input "steer_rate" is a derivative of the vehicle's "steer")"),
            std::string::npos);
  EXPECT_NE(of_events(R"({ "at": 1, "input": "brake", "value": 1 })").find(R"(input "brake" is the vehicle's "brake")"),
            std::string::npos);
  EXPECT_NE(refusal(kFourWheeler, R"({ "mbgen_manoeuvre": 1, "type": "ride", "speed": 15, "duration": 1e-9 })", "", "")
                .find("m.json: /duration: the manoeuvre takes 1e-09 s, less than a step"),
            std::string::npos);
}

TEST_F(Manoeuvre, ACircleThatEndsBeforeItsLimitSaysSo) {
  const Json run = drive(
      R"({ "mbgen_manoeuvre": 1, "type": "steady_circle", "method": "constant_steer", "speed": 5, "steer": 0.02,
           "acceleration": 1, "step": 4e-3 })");
  EXPECT_NE(run["metric_notes"].dump().find("the circle ends at 10"), std::string::npos) << run["metric_notes"];
}

// The angle of a change that an event interrupts goes from there to its target, and not beyond it.
TEST_F(Manoeuvre, AnEventEndsTheChangeThatItInterrupts) {
  const Json run = drive(
      R"({ "mbgen_manoeuvre": 1, "type": "events", "speed": 15, "duration": 3, "step": 4e-3, "events": [
           { "at": 1, "steer": 0.05, "over": 10 }, { "at": 2, "steer": 0, "over": 0.1 } ] })");
  EXPECT_GT(run["inputs"]["steer"]["smallest"].get<double>(), -1e-6);
  EXPECT_NEAR(run["inputs"]["steer"]["last"].get<double>(), 0, 1e-12);
}

TEST_F(Manoeuvre, InputsInOtherUnitsAreRefused) {
  std::string text = read(kFourWheeler);
  const auto with = [&](const std::string& unit, const std::string& other) {
    const std::string::size_type place = text.find("\"" + unit + "\"");
    EXPECT_NE(place, std::string::npos);
    write("other.json", std::string(text).replace(place, unit.size() + 2, "\"" + other + "\""));
  };
  with("rad", "deg");
  EXPECT_NE(refusal("other.json", R"({ "mbgen_manoeuvre": 1, "type": "ride", "speed": 15 })")
                .find(R"(input "steer" is the vehicle's "steer": manoeuvres and trims set it in rad, not in deg)"),
            std::string::npos);
  EXPECT_NE(mbgen("linearize other.json --speed 10").err.find("set it in rad, not in deg"), std::string::npos);
  with("N m", "kN m");
  EXPECT_NE(refusal("other.json", R"({ "mbgen_manoeuvre": 1, "type": "ride", "speed": 15 })").find("set it in N m"),
            std::string::npos);
}

TEST_F(Manoeuvre, WhatCannotBeDrivenIsRefused) {
  const std::string ride = R"({ "mbgen_manoeuvre": 1, "type": "ride", "speed": 15 })";
  EXPECT_NE(refusal(kSource + "/models/pendulum.json", ride).find("the model has no vehicle"), std::string::npos);
  EXPECT_NE(refusal(kFourWheeler, ride, "--integrator cvode").find("take rk4 or rosenbrock"), std::string::npos);
  write("t.csv", "t,steer\n0,0\n1,1\n");
  EXPECT_NE(refusal(kFourWheeler, ride, "--input-table t.csv").find("leave out one of the two"), std::string::npos);
  write("still.json",
        fmt::format(
            R"({{ "mbgen": 1, "include": ["{}"], "vehicle": {{ "reference": "car.origin", "drive": "drive" }} }})",
            kFourWheeler));
  EXPECT_NE(refusal("still.json", R"({ "mbgen_manoeuvre": 1, "type": "ride", "speed": 30 })")
                .find("starts at 15 m/s instead of 30 m/s"),
            std::string::npos);
  EXPECT_NE(refusal("still.json", R"({ "mbgen_manoeuvre": 1, "type": "weave", "speed": 15, "steer": 0.1 })")
                .find("needs \"steer\""),
            std::string::npos);
  EXPECT_NE(refusal(kFourWheeler, R"({ "mbgen_manoeuvre": 1, "type": "rides", "speed": 15 })").find("m.json:1:"),
            std::string::npos);
}

}  // namespace
}  // namespace mbgen::cli_test
