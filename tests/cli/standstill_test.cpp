// Vehicles that brake on a slope of 10 %, stop and stand: brakes are frictions that stick, on the wheels' coordinates.

#include <algorithm>
#include <cmath>

#include "tests/support/cli_support.hpp"

namespace mbgen::cli_test {
namespace {

const std::string kGrade = R"J("gravity": ["-9.81*sin(atan(0.1))", 0, "-9.81*cos(atan(0.1))"])J";

/// Largest less smallest value of a column from a time on, the first column.
double range_of(const Table& motion, const std::string& column, double from) {
  double low = 1e300, high = -1e300;
  for (std::size_t row = 0; row < motion.rows.size(); ++row) {
    if (motion.rows[row][0] < from) continue;
    low = std::min(low, motion.at(row, column));
    high = std::max(high, motion.at(row, column));
  }
  return high - low;
}

/// The three-wheeler on a slope with brakes, moving uphill at a speed; a negative one rolls back.
std::string braked(double speed) {
  std::string text, frictions;
  for (const char* wheel : {"front", "left", "right"})
    frictions += fmt::format(R"({}"brake_{}": {{ "joint": "{}", "law": "elasto_plastic", "coulomb": "brake",
      "stiffness": 3e4, "damping": 60 }})",
                             frictions.empty() ? "" : ", ", wheel, wheel);
  return fmt::format(R"({{ "mbgen": 1, "name": "braked", "include": ["{}/tests/data/models/three_wheeler.json"], {},
    "inputs": {{ "brake": {{ "unit": "N m" }} }}, "frictions": {{ {} }},
    "joint_springs": {{ "hold": {{ "joint": "steer", "stiffness": 3e4, "damping": 300 }} }},
    "outputs": {{ "force": {{ "tyre": "left", "quantity": "longitudinal_force" }} }},
    "initial": {{ "positions": {{ "steer": 0 }}, "velocities": {{ "frame_tx": {}, "frame_rz": 0, "front": {},
      "left": {}, "right": {} }} }} }})",
                     kSource, kGrade, frictions, speed, speed / 0.298, speed / 0.298, speed / 0.298);
}

class Standstill : public CommandLine {
 protected:
  /// Lets the vehicle roll, brakes it from 0.2 s on, and gives its motion.
  Table stopped(double speed, double torque, double duration) {
    write("m.json", braked(speed));
    write("brake.csv", fmt::format("t,brake\n0,0\n0.2,0\n0.3,{}\n", torque));
    const Outcome run = mbgen(fmt::format(
        "simulate m.json --engine generic --input-table brake.csv --duration {} --every 10 --out m.csv", duration));
    EXPECT_EQ(run.exit_code, 0) << run.err;
    return table("m.csv");
  }
};

TEST_F(Standstill, AVehicleStopsOnASlopeAndStaysForwardsAndBackwards) {
  for (const double speed : {5.0, -5.0}) {
    const Table motion = stopped(speed, 200, 20);
    EXPECT_GT(motion.last("z.frame_tx [m]") * speed, 2) << "it rolled";
    EXPECT_LT(range_of(motion, "z.frame_tx [m]", 10), 1e-8) << speed;
    EXPECT_LT(range_of(motion, "force [N]", 10), 1e-3) << speed;
    EXPECT_LT(range_of(motion, "force [N]", 15), 1e-6) << speed;
  }
}

TEST_F(Standstill, WheelsLockAndTheVehicleSlidesToItsRest) {
  const Table motion = stopped(5, 3000, 20);
  bool slides = false;
  for (std::size_t row = 0; row < motion.rows.size(); ++row)
    slides |= std::abs(motion.at(row, "zd.left [rad/s]")) < 0.1 && motion.at(row, "zd.frame_tx [m/s]") > 1;
  EXPECT_TRUE(slides);
  EXPECT_LT(range_of(motion, "z.frame_tx [m]", 10), 1e-8);
  EXPECT_LT(range_of(motion, "force [N]", 15), 1e-6);
}

// From 10 m/s uphill; stands from 6 s on, and from 10 s on for a minute.
TEST_F(Standstill, TheCoachHoldsOnASlopeForAMinute) {
  const std::string coach = kSource + "/models/coach.json";
  ASSERT_EQ(mbgen("equilibrium " + coach + " -o start.json").exit_code, 0);
  std::string brakes;
  for (const char* wheel : {"front_left", "front_right", "rear_left", "rear_right"})
    brakes += fmt::format(R"({}"brake_{}": {{ "joint": "wheel_{}", "law": "elasto_plastic", "coulomb": 10e3,
      "stiffness": 1e6, "damping": 3000 }})",
                          brakes.empty() ? "" : ", ", wheel, wheel);
  write("m.json", fmt::format(R"({{ "mbgen": 1, "name": "coach_on_a_slope", "include": ["{}", "start.json"], {},
    "frictions": {{ {} }},
    "outputs": {{ "front": {{ "tyre": "front_left", "quantity": "longitudinal_force" }},
                  "rear": {{ "tyre": "rear_left", "quantity": "longitudinal_force" }} }},
    "initial": {{ "equilibrium": false }} }})",
                              coach, kGrade, brakes));
  const Outcome run = mbgen(
      "simulate m.json --set speed=10 --set steer_amplitude=0 --set drive_gain=0 --duration 70 --step 1e-3 --every 10 "
      "--out m.csv");
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const Table motion = table("m.csv");
  EXPECT_GT(motion.last("z.chassis_tx [m]"), 6);
  EXPECT_LT(range_of(motion, "z.chassis_tx [m]", 10), 1e-5);
  EXPECT_LT(range_of(motion, "z.chassis_tz [m]", 10), 1e-5);
  EXPECT_LT(range_of(motion, "front [N]", 20), 0.01);
  EXPECT_LT(range_of(motion, "rear [N]", 20), 0.01);
}

}  // namespace
}  // namespace mbgen::cli_test
