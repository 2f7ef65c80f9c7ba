// The vehicles of the paper through the command line: reference accelerations by both engines, and the coach's slalom.

#include <cmath>
#include <numbers>

#include "tests/support/cli_support.hpp"

namespace mbgen::cli_test {
namespace {

/// Largest error over the largest acceleration of the state, over all states of a reference file.
double worst_error(const Json& answer, const Json& reference, const std::string& key) {
  double worst = 0;
  for (std::size_t s = 0; s < reference["states"].size(); ++s) {
    EXPECT_EQ(answer["states"][s]["status"], "ok");
    const std::vector<double> expected = reference["states"][s][key], actual = answer["states"][s]["zdd"];
    double error = 0, largest = 0;
    for (std::size_t i = 0; i < expected.size(); ++i) {
      error = std::max(error, std::abs(actual.at(i) - expected[i]));
      largest = std::max(largest, std::abs(expected[i]));
    }
    worst = std::max(worst, error / largest);
  }
  return worst;
}

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
    EXPECT_LT(worst_error(answer, reference(), "zdd"), 1e-9) << engine;
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
