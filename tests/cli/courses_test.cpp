// Manoeuvres that go another way than they mean: a car that spins, steers away, or is asked for what has no end.

#include <cmath>

#include "tests/support/cli_support.hpp"

namespace mbgen::cli_test {
namespace {

const std::string kCar = kSource + "/tests/data/models/four_wheeler.json";

class Courses : public CommandLine {
 protected:
  Outcome drive(const std::string& model, const std::string& manoeuvre, const std::string& more = "") const {
    write("m.json", manoeuvre);
    return mbgen("simulate " + model + " --engine generic --manoeuvre m.json --every 10 --out m.csv " + more);
  }
  /// The car with other text in the place of some.
  void write_car(const std::vector<std::pair<std::string, std::string>>& changes) const {
    std::ifstream file(kCar);
    std::stringstream content;
    content << file.rdbuf();
    std::string text = content.str();
    for (const auto& [from, to] : changes) {
      ASSERT_NE(text.find(from), std::string::npos) << from;
      text.replace(text.find(from), from.size(), to);
    }
    write("car.json", text);
  }
};

// Brakes at the rear alone, wheels that lose their side force, a mass a little to the left: the rear goes ahead.
TEST_F(Courses, ASpinningCarHasNotStopped) {
  write_car({{R"("fl", "law": "elasto_plastic", "coulomb": "0.25*brake")",
              R"("fl", "law": "elasto_plastic", "coulomb": "0*brake")"},
             {R"("fr", "law": "elasto_plastic", "coulomb": "0.25*brake")",
              R"("fr", "law": "elasto_plastic", "coulomb": "0*brake")"},
             {R"("com": [0, 0, 0.02])", R"("com": [0, 0.05, 0.02])"},
             {R"("PKY2": 1.5)", R"("PKY2": 1.5, "RBX1": 12, "RBX2": 10, "RCX1": 1, "RBY1": 8, "RBY2": 6, "RCY1": 1)"}});
  const Outcome run = drive("car.json", R"({ "mbgen_manoeuvre": 1, "type": "straight_braking", "speed": 30,
                                             "brake": 12000, "last_speed": 2 })");
  const Table motion = table("m.csv");
  double backwards = 0;  // m/s, over the ground where the forward part first is below the end's speed
  for (std::size_t row = 0; row < motion.rows.size(); ++row) {
    const double vx = motion.at(row, "vehicle_vx [m/s]"), vy = motion.at(row, "vehicle_vy [m/s]");
    const double heading = motion.at(row, "vehicle_heading [rad]");
    if (backwards == 0 && std::cos(heading) * vx + std::sin(heading) * vy < 2) backwards = std::hypot(vx, vy);
  }
  EXPECT_GT(backwards, 5) << "the car does not spin";
  EXPECT_LT(std::hypot(motion.last("vehicle_vx [m/s]"), motion.last("vehicle_vy [m/s]")), 2);
  for (const char* warning : {"the vehicle turns by more than 90 deg from its course, first at t = ",
                              "the vehicle slides: it moves more than 30 deg off its heading, first at t = "})
    EXPECT_NE(run.err.find(warning), std::string::npos) << run.err;
  EXPECT_NE(Json::parse(read("m.csv.run.json"))["status"], "ok");
}

TEST_F(Courses, ASteerRatioOfTheWrongSignIsAWarning) {
  const std::string ride = R"({ "mbgen_manoeuvre": 1, "type": "ride", "speed": 15 })";
  EXPECT_EQ(drive(kCar, ride, "--duration 0.1").err.find("steer_ratio"), std::string::npos);
  write_car({{R"("steer": "steer", "drive")", R"("steer": "steer", "steer_ratio": -16, "drive")"}});
  EXPECT_NE(
      drive("car.json", ride, "--duration 0.1")
          .err.find("simulate: warning: \"steer_ratio\" of the vehicle is -16, but a positive value at its steering "
                    "input turns the wheels to the left: its sign is wrong\n"),
      std::string::npos);
}

TEST_F(Courses, NumbersInOtherUnitsAreNoted) {
  const Outcome run = drive(kCar, R"({ "mbgen_manoeuvre": 1, "type": "ride", "speed": 80,
  "driver": { "understeer": 0.2 } })",
                            "--duration 0.02");
  EXPECT_NE(run.err.find("m.json:1:50: note: 80 m/s are 288 km/h\n"
                         "  hint: speeds are in m/s; km/h may be written \"80/3.6\"\n"),
            std::string::npos)
      << run.err;
  EXPECT_NE(run.err.find("m.json:2:29: note: 0.2 rad s^2/m are 11.5 deg more for every m/s^2 across\n"
                         "  hint: angles are in rad: 0.2 deg s^2/m are 0.003491\n"),
            std::string::npos)
      << run.err;
}

// The track of ISO 3888-1 of a car 1.8 m wide, 50 m ahead: lanes of 15, 25 and 30 m with gaps of 30 and 25 m, the
// second one 3.5 m beside the first.
TEST_F(Courses, ALaneChangeHasItsLanesAndCourseInTheRun) {
  const Outcome run = drive(kCar, R"({ "mbgen_manoeuvre": 1, "type": "lane_change", "speed": 20, "duration": 5 })");
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const Json manoeuvre = Json::parse(read("m.csv.run.json"))["manoeuvre"];
  const double begin[] = {50, 95, 145}, length[] = {15, 25, 30};
  const double width[] = {1.1 * 1.8 + 0.25, 1.2 * 1.8 + 0.25, 1.3 * 1.8 + 0.25};
  ASSERT_EQ(manoeuvre["lanes"].size(), 3u);
  const double x = manoeuvre["course"][0][0], y = manoeuvre["course"][0][1];
  for (std::size_t i = 0; i < 3; ++i) {
    const Json &left = manoeuvre["lanes"][i]["left"], &right = manoeuvre["lanes"][i]["right"];
    for (const Json* limit : {&left, &right}) {
      EXPECT_NEAR((*limit)[0][0].get<double>() - x, begin[i], 1e-6);
      EXPECT_NEAR((*limit)[1][0].get<double>() - x, begin[i] + length[i], 1e-6);
    }
    EXPECT_NEAR(left[0][1].get<double>() - right[0][1].get<double>(), width[i], 1e-9);
    // The right limits are aligned, but for the offset.
    EXPECT_NEAR(right[1][1].get<double>() - y, -width[0] / 2 + (i == 1 ? 3.5 : 0), 1e-6) << i;
  }
  // 100 m in 5 s, a metre apart.
  const Json& course = manoeuvre["course"];
  EXPECT_NEAR(course.back()[0].get<double>() - x, 100, 2);
  EXPECT_NEAR(static_cast<double>(course.size()), 100, 3);
  EXPECT_FALSE(Json::parse(read("m.csv.run.json"))["manoeuvre"].contains("sections"));
}

TEST_F(Courses, WhatHasNoEndIsRefusedByItsField) {
  const std::string circle = R"({ "mbgen_manoeuvre": 1, "type": "steady_circle", "speed": 20, "radius": 1e6)";
  EXPECT_EQ(drive(kCar, circle + " }").err,
            "m.json:1:73: /radius: at 1e+06 m the speed has to grow to 2348 m/s for 5 m/s^2, beyond 1000 m/s\n"
            "  { \"mbgen_manoeuvre\": 1, \"type\": \"steady_circle\", \"speed\": 20, \"radius\": 1e6 }\n"
            "                                                                          ^~~\n"
            "  hint: give \"last_speed\" or a smaller radius, in m\n");
  EXPECT_EQ(drive(kCar, circle + R"(, "last_speed": 21, "acceleration": 1e-6 })").err,
            "m.json: /acceleration: the manoeuvre takes 1e+06 s, 1e+09 steps of 0.001 s; at most 1e+07 are driven\n"
            "  hint: give \"duration\", or a longer step\n");
  EXPECT_EQ(drive(kCar, R"({ "mbgen_manoeuvre": 1, "type": "lane_change", "speed": 20, "approach": 1e9 })").err,
            "m.json: /approach: the manoeuvre takes 1e+08 s, 1e+11 steps of 0.001 s; at most 1e+07 are driven\n"
            "  hint: give \"duration\", or a longer step\n");
  // A circle as large is driven like any other for as long as is asked.
  const Outcome run = drive(kCar, circle + R"(, "last_speed": 21, "duration": 0.5 })");
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_LT(Json::parse(read("m.csv.run.json"))["manoeuvre"]["largest_offset"], 0.01);
}

}  // namespace
}  // namespace mbgen::cli_test
