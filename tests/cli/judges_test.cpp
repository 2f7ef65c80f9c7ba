// The Cartesian judges through the command line.

#include "tests/support/cli_support.hpp"

namespace mbgen::cli_test {
namespace {

const char* const kJudges[] = {"augmented", "range-space", "null-space", "maggi"};

class JudgesOnVehicles : public CommandLine, public ::testing::WithParamInterface<const char*> {};

// The reference was made by foreign software: tests/data/reference/README.md.
TEST_P(JudgesOnVehicles, AccelerationsEqualTheReference) {
  const std::string vehicle = kSource + "/tests/data/reference/" + GetParam() + "_states.json";
  Json reference = Json::parse(std::ifstream(vehicle));
  reference["states"].erase(reference["states"].begin() + 3, reference["states"].end());
  write("states.json", reference.dump());
  const std::string model = kSource + "/models/" + GetParam() + "_mechanism.json";
  for (const char* judge : kJudges) {
    const Json answer = json_of(fmt::format("evaluate {} --states states.json --engine {}", model, judge));
    EXPECT_LT(worst_error(answer, reference), 1e-11) << judge;
    EXPECT_LT(answer["states"][0]["position_residual"].get<double>(), 1e-12);
    EXPECT_LT(answer["states"][0]["velocity_residual"].get<double>(), 1e-12);
  }
}

// Of the coach all closures are independent, so that what its joints transmit is unique.
TEST_F(CommandLine, JudgesFindTheReactionsOfTheCoach) {
  Json reference = Json::parse(std::ifstream(kSource + "/tests/data/reference/coach_states.json"));
  reference["states"].erase(reference["states"].begin() + 1, reference["states"].end());
  write("states.json", reference.dump());
  const std::string evaluate = "evaluate " + kSource + "/models/coach_mechanism.json --states states.json --reactions";
  const auto reactions = [&](const char* engine) {
    return Json(json_of(fmt::format("{} --engine {}", evaluate, engine))["states"][0]["reactions"]);
  };
  const Json expected = reactions("generic");
  for (const char* judge : kJudges) {
    const Json actual = reactions(judge);
    double largest = 0, error = 0;
    ASSERT_GT(actual.size(), 20u);
    for (const auto& [joint, wrench] : actual.items()) {
      for (const char* part : {"force", "moment"}) {
        for (int axis = 0; axis < 3; ++axis) {
          const double right = expected[joint][part][axis];
          largest = std::max(largest, std::abs(right));
          error = std::max(error, std::abs(wrench[part][axis].get<double>() - right));
        }
      }
    }
    EXPECT_LT(error / largest, 1e-10) << judge;
  }
}

INSTANTIATE_TEST_SUITE_P(Paper, JudgesOnVehicles, ::testing::Values("coach", "truck"));

/// Robots whose platform stands on several legs, free and driven, one of them with redundant equations.
class JudgesOnParallelRobots : public CommandLine, public ::testing::WithParamInterface<const char*> {};

TEST_P(JudgesOnParallelRobots, MoveAndAccelerateAsTheGeneratedCodeDoes) {
  const std::string model = kSource + "/" + GetParam();
  for (const char* engine : {"generated", "augmented"}) {
    const Outcome run =
        mbgen(fmt::format("simulate {} --duration 0.1 --step 5e-4 --every 40 --integrator rk4 --engine {} --out {}.csv",
                          model, engine, engine));
    ASSERT_EQ(run.exit_code, 0) << run.err;
  }
  const Table motion = table("generated.csv");
  expect_same_motion(table("augmented.csv"), motion, 1e-8);
  Json states = {{"states", Json::array()}};
  for (const std::vector<double>& row : motion.rows) {
    Json state = {{"z", Json::array()}, {"zd", Json::array()}, {"t", row[0]}};
    for (std::size_t c = 0; c < row.size(); ++c) {
      if (motion.names[c].starts_with("z.")) state["z"].push_back(row[c]);
      if (motion.names[c].starts_with("zd.")) state["zd"].push_back(row[c]);
    }
    states["states"].push_back(state);
  }
  write("states.json", states.dump());
  const std::string evaluate = "evaluate " + model + " --states states.json --engine ";
  EXPECT_LT(worst_error(json_of(evaluate + "generated"), json_of(evaluate + "augmented")), 1e-8);
}

INSTANTIATE_TEST_SUITE_P(Parallel, JudgesOnParallelRobots,
                         ::testing::Values("tests/data/models/stewart.json", "models/delta.json",
                                           "models/agile_eye.json", "models/tripteron.json"),
                         [](const auto& info) { return std::to_string(info.index); });

/// A slider-crank at its dead centre, along a direction of the x-z plane. Only the piston has mass, and the crank
/// cannot move it: crank 1, connecting rod -1/3, so the big end -4/3.
std::string dead_centre(double x, double z) {
  const auto point = [x, z](double distance) { return fmt::format("[{}, 0, {}]", distance * x, distance * z); };
  return fmt::format(R"({{ "mbgen": 1, "name": "dead_centre",
  "bodies": {{
    "ground": {{ "points": {{ "O": [0, 0, 0], "cylinder": {1} }} }},
    "crank": {{ "points": {{ "O": [0, 0, 0], "pin": {0} }} }},
    "connecting_rod": {{ "points": {{ "pin": {0}, "wrist": {1} }} }},
    "piston": {{ "mass": 0.5, "com": {1}, "inertia": [1e-4, 1e-4, 1e-4], "points": {{ "wrist": {1} }} }}
  }},
  "joints": {{
    "crank": {{ "type": "revolute", "from": "ground.O", "to": "crank.O", "axis": "y" }},
    "piston": {{ "type": "prismatic", "from": "ground.cylinder", "to": "piston.wrist", "axis": [{2}, 0, {3}] }},
    "big_end": {{ "type": "revolute", "from": "crank.pin", "to": "connecting_rod.pin", "axis": "y" }},
    "small_end": {{ "type": "revolute", "from": "connecting_rod.wrist", "to": "piston.wrist", "axis": "y", "cut": true }}
  }} }})",
                     point(0.1), point(0.4), x, z);
}

TEST_F(CommandLine, EveryEngineSaysInTheSameWordsThatAMotionHasNoInertia) {
  write("aligned.json", dead_centre(1, 0));
  write("skew.json", dead_centre(0.6, 0.8));  // where rounding hides the dead centre from whoever looks for zeros
  write("states.json", R"({"joint_order": ["crank", "piston", "big_end"], "states": [
    {"z": [0, 0, 0]}, {"z": [0, 0, 0], "zd": [3, 0, -4]}, {"z": [0.5, 0, -0.6]}]})");
  for (const char* model : {"aligned", "skew"}) {
    for (const char* engine : {"generated", "generic", "augmented", "range-space", "null-space", "maggi"}) {
      const Json answer = json_of(fmt::format("evaluate {}.json --states states.json --engine {}", model, engine));
      for (int s = 0; s < 2; ++s) {
        EXPECT_EQ(answer["states"][s]["status"], "no inertia: big_end") << model << engine;
        EXPECT_EQ(answer["states"][s]["zdd"], nullptr) << model << engine;
      }
      EXPECT_EQ(answer["states"][2]["status"], "ok") << model << engine;
    }
  }
}

TEST_F(CommandLine, JudgesKeepTheFourBarClosedAndItsEnergy) {
  write("four_bar.json", kFourBar);
  for (const char* judge : kJudges) {
    for (const std::string stabilisation : {"projection", "baumgarte"}) {
      const Json report = json_of(fmt::format(
          "simulate four_bar.json --duration 0.5 --step 1e-3 --out o.csv --json --engine {} --stabilisation {}", judge,
          stabilisation));
      EXPECT_EQ(report["engine"], judge);
      EXPECT_EQ(report["stabilisation"], stabilisation);
      // Projection closes each of the four joints to 1e-12; the coordinates carry what they leave to the one that is
      // cut.
      EXPECT_LT(report["position_residual"], stabilisation == "projection" ? 4e-12 : 1e-8);
      EXPECT_LT(std::abs(report["relative_energy_error"].get<double>()), 1e-7);
      EXPECT_EQ(table("o.csv").rows.size(), 501u);
    }
  }
}

// Each drives the coach in its own coordinates; what is left is the difference of two methods of order four.
TEST_F(CommandLine, JudgesDriveTheCoachAsTheGeneratedCodeDoes) {
  const std::string run = "simulate " + kSource + "/models/coach.json --duration 0.05 --step 1e-3 --integrator rk4 ";
  ASSERT_EQ(mbgen(run + "--out generated.csv").exit_code, 0);
  const Table generated = table("generated.csv");
  for (const char* choice : {"augmented --stabilisation projection", "maggi --stabilisation baumgarte"}) {
    ASSERT_EQ(mbgen(fmt::format("{} --out judge.csv --engine {}", run, choice)).exit_code, 0);
    const Table judge = table("judge.csv");
    ASSERT_EQ(judge.names, generated.names);
    ASSERT_EQ(judge.rows.size(), 51u);
    for (std::size_t c = 0; c < judge.names.size(); ++c) {
      if (judge.names[c].starts_with("residual")) continue;
      double largest = 1e-3, error = 0;  // columns that stay near zero are measured against a thousandth of their unit
      for (std::size_t row = 0; row < judge.rows.size(); ++row) {
        largest = std::max(largest, std::abs(generated.rows[row][c]));
        error = std::max(error, std::abs(judge.rows[row][c] - generated.rows[row][c]));
      }
      EXPECT_LT(error / largest, 1e-6) << choice << " " << judge.names[c];
    }
  }
}

TEST_F(CommandLine, JudgesIntegrateByRungeKuttaOnly) {
  std::string text = kFourBar;
  text.insert(text.rfind('}'), R"(, "solver": { "integrator": "abm4" })");
  write("four_bar.json", text);
  const Outcome asked = mbgen("simulate four_bar.json --duration 0.01 --out o.csv --engine maggi --integrator abm4");
  EXPECT_EQ(asked.exit_code, 1);
  EXPECT_EQ(asked.err, "--integrator: engine \"maggi\" works in Cartesian coordinates and integrates by rk4 only\n");
  const Json report = json_of("simulate four_bar.json --duration 0.01 --out o.csv --engine maggi --json");
  EXPECT_EQ(report["integrator"], "rk4") << "the model's choice is for engines that have it";
}

TEST_F(CommandLine, StabilisationIsOfJudgesOnly) {
  write("pendulum.json", kPendulum);
  const std::pair<const char*, const char*> cases[] = {
      {"--engine generic --stabilisation baumgarte",
       "--stabilisation: engine \"generic\" has no such option; engines that have it: augmented, range-space, "
       "null-space, "
       "maggi\n"},
      {"--stabilisation projection",
       "--stabilisation: engine \"generated\" has no such option; engines that have it: augmented, range-space, "
       "null-space, "
       "maggi\n"},
      {"--engine maggi --stabilisation glue",
       "--stabilisation: no stabilisation \"glue\"; there are: projection, baumgarte\n"}};
  for (const auto& [arguments, message] : cases) {
    const Outcome run = mbgen(fmt::format("simulate pendulum.json --out o.csv {}", arguments));
    EXPECT_EQ(run.exit_code, 1) << arguments;
    EXPECT_EQ(run.err, message);
  }
  EXPECT_EQ(leftovers(), std::vector<std::string>{"pendulum.json"});
}

}  // namespace
}  // namespace mbgen::cli_test
