// The vehicles of the paper through the command line: reference accelerations by both engines, and the coach's slalom.

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/support/cli_support.hpp"

namespace mbgen::cli_test {
namespace {

/// A model whose rods have lost their masses: every rod is one line of the file.
std::string without_rod_masses(const std::string& text) {
  std::istringstream lines(text);
  std::string result, line;
  bool rods = false;
  while (std::getline(lines, line)) {
    if (line.find("\"rods\"") != std::string::npos) rods = true;
    const std::size_t mass = line.find(", \"mass\":");
    if (rods && mass != std::string::npos) line.erase(mass, line.find_first_of(",}", mass + 9) - mass);
    result += line + "\n";
  }
  return result;
}

std::string content_of(const std::filesystem::path& path) {
  std::stringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

class Vehicles : public CommandLine, public ::testing::WithParamInterface<const char*> {
 protected:
  std::string model() const { return kSource + "/models/" + GetParam() + "_mechanism.json"; }
  std::string states() const { return kSource + "/tests/data/reference/" + GetParam() + "_states.json"; }
  Json reference() const { return Json::parse(std::ifstream(states())); }
};

TEST_P(Vehicles, AccelerationsEqualTheReferenceWithBothEngines) {
  for (const char* engine : {"generated", "generic"}) {
    const Json answer = json_of("evaluate " + model() + " --states " + states() + " --engine " + engine);
    EXPECT_LT(worst_error(answer, reference()), 1e-9) << engine;
  }
}

TEST_P(Vehicles, AccelerationsEqualTheReferenceWithMasslessRods) {
  std::filesystem::create_directory(path("parts"));
  for (const auto& part : std::filesystem::directory_iterator(kSource + "/models/parts")) {
    write("parts/" + part.path().filename().string(), without_rod_masses(content_of(part.path())));
  }
  const std::string massless = write("massless.json", without_rod_masses(content_of(model())));
  EXPECT_EQ(json_of("inspect " + massless + " --json")["rods"], json_of("inspect " + model() + " --json")["rods"]);
  for (const char* engine : {"generated", "generic"}) {
    const Json answer = json_of("evaluate " + massless + " --states " + states() + " --engine " + engine);
    EXPECT_LT(worst_error(answer, reference(), "zdd_massless_rods"), 1e-9) << engine;
  }
}

/// Height over the road of a point of the coach's chassis and its rate, as expressions of the chassis' coordinates.
struct CornerText {
  std::string height, rate;
};

/// x, y, z: from the chassis' point `origin`, 1 m above the road at the reference.
CornerText corner_text(double x, double y, double z) {
  const std::string across = fmt::format("(sin(z.chassis_rx)*{} + cos(z.chassis_rx)*{})", y, z);
  return {fmt::format("(1 + z.chassis_tz - sin(z.chassis_ry)*{} + cos(z.chassis_ry)*{})", x, across),
          fmt::format("(zd.chassis_tz - zd.chassis_ry*(cos(z.chassis_ry)*{} + sin(z.chassis_ry)*{}) + "
                      "zd.chassis_rx*cos(z.chassis_ry)*(cos(z.chassis_rx)*{} - sin(z.chassis_rx)*{}))",
                      x, across, y, z)};
}

/// The coach without steering that turns, thrown into a roll; twelve corners of its body bounce on the road, and lose
/// energy there.
std::string rolling_coach() {
  std::string points, forces;
  for (const double x : {6.1, -5.9}) {
    for (const double y : {1.25, -1.25}) {
      for (const double z : {2.3, 0.9, -0.5}) {
        const auto [height, rate] = corner_text(x, y, z);
        const std::string name = fmt::format("corner{}", std::count(points.begin(), points.end(), '['));
        points += fmt::format("{}\"{}\": [{}, {}, {}]", points.empty() ? "" : ", ", name, x - 3.6, y, z + 1);
        forces += fmt::format(
            "{}\"{}\": {{ \"at\": \"chassis.{}\", \"force\": [0, 0, "
            "\"6e5*max(0, -{})*max(0, 1 - 0.4*{})\"] }}",
            forces.empty() ? "" : ", ", name, name, height, rate);
      }
    }
  }
  return fmt::format(R"({{ "mbgen": 1, "name": "rolling_coach", "include": ["{}/models/coach.json"],
    "bodies": {{ "chassis": {{ "points": {{ {} }} }} }}, "forces": {{ {} }},
    "outputs": {{ "pitch": {{ "joint": "chassis_ry" }} }},
    "initial": {{ "equilibrium": false, "positions": {{ "chassis_tz": 1 }},
      "velocities": {{ "chassis_tx": 0, "chassis_tz": 4, "chassis_rx": 4.5, "wheel_front_left": 0,
        "wheel_front_right": 0, "wheel_rear_left": 0, "wheel_rear_right": 0 }} }} }})",
                     kSource, points, forces);
}

// Over its roof, onto its wheels and onto its side again: tyres that meet the road and leave it, axles that pass the
// vertical, and angles of more than a turn. The energy is as good as on the road.
TEST_F(CommandLine, CoachRollsOverItsRoofAndOn) {
  write("m.json", rolling_coach());
  const Json report = json_of("simulate m.json --duration 5 --step 2.5e-4 --every 200 --out o.csv --json");
  EXPECT_EQ(report["status"], "ok");
  EXPECT_LT(std::abs(report["relative_energy_error"].get<double>()), 2e-5);
  const Table motion = table("o.csv");
  double roll = 0, load = 0;
  for (std::size_t row = 0; row < motion.rows.size(); ++row) {
    roll = std::max(roll, motion.at(row, "roll [rad]"));
    load = std::max(load, motion.at(row, "load_front_left [N]"));
  }
  EXPECT_GT(roll, 2 * std::numbers::pi) << "it went round";
  EXPECT_GT(load, 1e4) << "its wheels met the road";
  // Until its roof has met the road the generic runtime goes the same way.
  ASSERT_EQ(
      json_of("simulate m.json --engine generic --duration 1 --step 2.5e-4 --every 200 --out g.csv --json")["status"],
      "ok");
  const Table generic = table("g.csv");
  for (std::size_t row = 0; row < generic.rows.size(); ++row)
    EXPECT_NEAR(generic.at(row, "roll [rad]"), motion.at(row, "roll [rad]"), 1e-6) << row;
}

INSTANTIATE_TEST_SUITE_P(Paper, Vehicles, ::testing::Values("coach", "truck"));

TEST_F(CommandLine, CoachDrivesItsSlalom) {
  const std::string coach = kSource + "/models/coach.json";
  ASSERT_EQ(mbgen("simulate " + coach + " --duration 5 --step 1e-3 --every 1 --out slalom.csv").exit_code, 0);
  const Table run = table("slalom.csv");
  double lateral = 0, roll = 0, residual = 0, load = 1e9;
  for (std::size_t row = 0; row < run.rows.size(); ++row) {
    lateral = std::max(lateral, std::abs(run.at(row, "lateral_acceleration [m/s^2]")));
    roll = std::max(roll, std::abs(run.at(row, "roll [rad]")) * 180 / std::numbers::pi);
    residual = std::max(residual, run.at(row, "residual [m]"));
    for (const char* wheel : {"front_left", "front_right", "rear_left", "rear_right"})
      load = std::min(load, run.at(row, std::string("load_") + wheel + " [N]"));
  }
  EXPECT_EQ(run.rows.size(), 5001u);
  EXPECT_GT(lateral, 2);
  EXPECT_LT(lateral, 4);
  EXPECT_GT(roll, 1);
  EXPECT_LT(roll, 5);
  EXPECT_GT(load, 5000);
  EXPECT_LT(residual, 1e-10);
}

// The hump begins at x = 10 m, where the front wheels are after 1.2 s.
TEST_F(CommandLine, CoachMeetsTheHump) {
  const std::string ride = kSource + "/models/rides/coach_hump.json --set speed=8.3333 --set steer_amplitude=0";
  ASSERT_EQ(mbgen("simulate " + ride + " --duration 1.3 --step 2e-3 --engine generic --out hump.csv").exit_code, 0);
  const Table run = table("hump.csv");
  for (const char* wheel : {"front_left", "front_right"}) {
    const std::string load = std::string("load_") + wheel + " [N]";
    double before = 0, on_hump = 0;
    for (std::size_t row = 0; row < run.rows.size(); ++row) {
      double& largest = run.at(row, "t [s]") < 1.19 ? before : on_hump;
      largest = std::max(largest, run.at(row, load));
    }
    EXPECT_NEAR(before, run.at(0, load), 0.02 * before) << wheel;
    EXPECT_GT(on_hump, 1.15 * before) << wheel;
    EXPECT_LT(on_hump, 1.5 * before) << wheel;
  }
}

// Other pivots, other order of operations: what rounding makes of it in a second stays below 1e-9 of each column.
TEST_F(CommandLine, EnginesAgreeOnTheFirstSecondOfTheSlalom) {
  const std::string coach = kSource + "/models/coach.json";
  for (const char* engine : {"generated", "generic"})
    ASSERT_EQ(mbgen(fmt::format("simulate {} --duration 1 --step 1e-3 --engine {} --out {}.csv", coach, engine, engine))
                  .exit_code,
              0);
  expect_same_motion(table("generic.csv"), table("generated.csv"), 1e-9);
}

}  // namespace
}  // namespace mbgen::cli_test
