// Wheels that are steered while the vehicle stands.

#include <algorithm>
#include <cmath>

#include "tests/support/cli_support.hpp"

namespace mbgen::cli_test {
namespace {

constexpr double kStiffness = 2000, kRadius = 0.05, kLoad = 4000;

/// A wheel that bears 4000 N and is steered, its kingpin at its centre; its friction at this load is 1. An angle of ""
/// leaves the steering free.
std::string parked(const std::string& angle) {
  const std::string steering =
      fmt::format(R"("motions": {{ "steering": {{ "joint": "steer", "angle": "{}" }} }},)", angle);
  const std::string torque = R"(, "torque": { "unit": "N m", "motion": "steering" })";
  return fmt::format(R"({{ "mbgen": 1, "name": "parked", "gravity": [0, 0, -10],
    "bodies": {{
      "ground": {{ "points": {{ "start": [0, 0, 0.3] }} }},
      "strut": {{ "mass": 370, "com": [0, 0, 0.3], "inertia": [1, 1, 1], "points": {{ "pin": [0, 0, 0.3] }} }},
      "knuckle": {{ "mass": 10, "com": [0, 0, 0.3], "inertia": [0.2, 0.2, 0.2], "points": {{ "hub": [0, 0, 0.3] }} }},
      "wheel": {{ "mass": 20, "com": [0, 0, 0.3], "inertia": [0.5, 1, 0.5], "points": {{ "hub": [0, 0, 0.3] }} }} }},
    "joints": {{
      "up": {{ "type": "prismatic", "from": "ground.start", "to": "strut.pin", "axis": "z" }},
      "steer": {{ "type": "revolute", "from": "strut.pin", "to": "knuckle.hub", "axis": "z" }},
      "wheel": {{ "type": "revolute", "from": "knuckle.hub", "to": "wheel.hub", "axis": "y" }} }},
    {} "tyre_data": {{ "rubber": {{ "model": "pac2002", "coefficients": {{ "UNLOADED_RADIUS": 0.3, "FNOMIN": 4000,
      "PCX1": 1.6, "PDX1": 1.1, "PKX1": 20, "PCY1": 1.3, "PDY1": 1, "PKY1": -15, "PKY2": 1.5 }} }} }},
    "tyres": {{ "tyre": {{ "centre": "wheel.hub", "data": "rubber", "stiffness": 2e5,
      "parking": {{ "stiffness": {}, "radius": {} }} }} }},
    "outputs": {{ "moment": {{ "tyre": "tyre", "quantity": "aligning_moment" }}{} }},
    "initial": {{ "positions": {{ "up": -0.02 }} }},
    "solver": {{ "step": 1e-3, "duration": 1 }} }})",
                     angle.empty() ? "" : steering, kStiffness, kRadius, angle.empty() ? "" : torque);
}

class Parked : public CommandLine {
 protected:
  Table motion_of(const std::string& angle, double duration, const std::string& engine) {
    write("m.json", parked(angle));
    const Outcome run =
        mbgen(fmt::format("simulate m.json --engine {} --duration {} --every 5 --out m.csv", engine, duration));
    EXPECT_EQ(run.exit_code, 0) << run.err;
    return table("m.csv");
  }
};

// Closed form of the patch at a steady rate, with its damping of 0.02 s times the share that does not slide.
TEST_F(Parked, TheSteeringTorqueGrowsWithTheAngleToItsLargestValue) {
  const double rate = 0.2, limit = kRadius * kLoad, angle = limit / kStiffness;
  for (const double sense : {1.0, -1.0}) {
    const Table motion = motion_of(fmt::format("{}*t", sense * rate), 3, "generic");
    for (std::size_t row = 0; row < motion.rows.size(); ++row) {
      const double sticking = std::exp(-rate * motion.rows[row][0] / angle);
      const double moment = limit * (1 - sticking + 0.02 * rate / angle * sticking);
      ASSERT_NEAR(motion.at(row, "moment [N m]"), -sense * moment, 1e-6 * limit) << motion.rows[row][0];
      ASSERT_NEAR(motion.at(row, "torque [N m]"), sense * moment, 1e-6 * limit);
    }
  }
}

TEST_F(Parked, ASteeredWheelThatIsHeldKeepsItsTorqueForAMinute) {
  const Table motion = motion_of("0.3*tanh(2*t)^3", 70, "generic");
  double low = 1e300, high = -1e300;
  for (std::size_t row = 0; row < motion.rows.size(); ++row) {
    if (motion.rows[row][0] < 10) continue;
    low = std::min(low, motion.at(row, "torque [N m]"));
    high = std::max(high, motion.at(row, "torque [N m]"));
  }
  EXPECT_GT(low, 0.9 * kRadius * kLoad);
  EXPECT_LT(high - low, 1e-6);
  EXPECT_EQ(motion.last("x.tyre_turn [rad]"), motion.at(motion.rows.size() - 2, "x.tyre_turn [rad]"));
}

// The patch is a spring of kStiffness, damped with 0.02 s of it; knuckle and wheel have 0.7 kg m^2 about the kingpin.
TEST_F(Parked, AFreeSteeringSwingsOnItsPatch) {
  write("m.json", parked(""));
  const Outcome run = mbgen("linearize m.json --json");
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const double rate = std::sqrt(kStiffness / 0.7), ratio = 0.02 * rate / 2;
  const Json answer = Json::parse(run.out);
  bool found = false;
  for (const Json& mode : answer["modes"]) {
    const double steer = mode["shape"]["steer"][0], frequency = mode["eigenvalue"][1];
    if (steer < 0.99 || frequency == 0) continue;
    found = true;
    EXPECT_NEAR(mode["eigenvalue"][0].get<double>(), -ratio * rate, 1e-6 * rate);
    EXPECT_NEAR(frequency, rate * std::sqrt(1 - ratio * ratio), 1e-6 * rate);
  }
  EXPECT_TRUE(found);
}

TEST_F(Parked, ExplainNamesTheCoefficientsThatAct) {
  std::ifstream file(kSource + "/tests/data/models/turning_three_wheeler.json");
  std::string text{std::istreambuf_iterator<char>(file), {}};
  for (const bool acts : {true, false}) {
    write("m.json", text);
    const std::string law = mbgen("explain m.json --tyre left").out;
    EXPECT_NE(law.find("LATERAL_STIFFNESS 60000"), std::string::npos) << law;
    EXPECT_EQ(law.find("LONGITUDINAL_STIFFNESS"), std::string::npos) << "it is 0";
    for (const char* part :
         {"PECP1 0.55", "QDRP2 -1.2", "turn slip of the set acts", "Turned on the spot", "on a circle"})
      EXPECT_EQ(law.find(part) != std::string::npos, acts) << part;
    if (!acts) break;
    for (std::size_t at = 0; (at = text.find("\"turn_slip\": true", at)) != std::string::npos;)
      text.replace(at, 17, "\"turn_slip\": false");
    text.replace(text.find("{ \"stiffness\": \"twist\" }"), 24, "{ \"stiffness\": \"twist\", \"radius\": 0.06 }");
  }
}

}  // namespace
}  // namespace mbgen::cli_test
